#include "prefilter_groups.h"

#include <algorithm>

namespace lobelia {

namespace {

constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t GROUP_SIZE = 8;      // local_size_x and _y of those by places
constexpr std::uint32_t TILE_SIZE = 8;       // of statistics.comp
constexpr std::uint32_t SUM_GROUP_SIZE = 64; // of sum.comp and expand.comp
constexpr std::uint32_t EXPAND_TEXELS = 4;   // of an invocation of expand.comp

std::uint32_t groups(std::uint32_t size, std::uint32_t group) {
    return (size + group - 1) / group;
}

vk::Groups square(std::uint32_t size, std::uint32_t group, std::uint32_t layers) {
    return {groups(size, group), groups(size, group), layers};
}

} // namespace

vk::Groups groups_of(const PrefilterPlan::State& plan, const PlannedPass& planned) {
    const auto target = [&] { return plan.levels[planned.target]; };
    const auto map_size = [&] { return plan.maps[*planned.map].size; };
    switch (planned.kind) {
    case PlannedPass::Kind::statistics:
        return square(plan.source_size / TILE_SIZE, GROUP_SIZE, FACES);
    case PlannedPass::Kind::suns: return {1, 1, 1};
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::halve: return square(target().size, GROUP_SIZE, FACES);
    case PlannedPass::Kind::suns_out:
        return square(sun_window(target().size), GROUP_SIZE, FACES * MOST_SUNS);
    case PlannedPass::Kind::margins:
        return {groups(target().size, GROUP_SIZE), groups(target().margin, GROUP_SIZE), 4 * FACES};
    case PlannedPass::Kind::blur_level: return square(target().size / 2, GROUP_SIZE, 1);
    case PlannedPass::Kind::blur_map: return square(map_size() / 2, GROUP_SIZE, 1);
    case PlannedPass::Kind::project: {
        const std::uint32_t size = plan.levels[planned.source].size;
        return {FACES * size * size / CHUNK_TEXELS, 1, 1};
    }
    case PlannedPass::Kind::sum: return {groups(TERMS, SUM_GROUP_SIZE), 1, 1};
    case PlannedPass::Kind::expand: break;
    }
    return {groups(3 * map_size() * map_size() / 4 / EXPAND_TEXELS, SUM_GROUP_SIZE), 1, 1};
}

} // namespace lobelia
