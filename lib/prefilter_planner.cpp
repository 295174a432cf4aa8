#include "prefilter_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "prefilter_tiers.h"

namespace lobelia {

namespace {

constexpr VkDeviceSize ALIGNMENT = 256;         // no device asks for more at a buffer view's offset
constexpr std::uint32_t LEAST_CHAIN_SIZE = 32;  // coarser grids have an error of their own
constexpr double HALVED_TEXELS_PER_SIGMA = 1.0; // of a kernel that reads the halved level
constexpr double CHAIN_TEXELS_PER_SIGMA = 0.71; // of a level that the chain goes on from
constexpr double CHAIN_EXPONENT = 45; // below it harmonics are cheaper and better than the chain
constexpr double START_TEXELS_PER_SIGMA = 2.83; // of half of the first level, of box averages
constexpr double SHARP_EXPONENT = 1500;
constexpr double CHAIN_RATIO = 2.2; // least ratio of exponents from a level to a map

class Planner {
public:
    Planner(const PrefilterRequest& request, PrefilterPlan::State& plan)
        : tier_(tier_of(request.quality)), plan_(plan) {}

    void run(const PrefilterRequest& request) {
        plan_.source_size = request.source_size;
        plan_.quality = request.quality;
        plan_.levels_up_to = request.levels_up_to;
        plan_.map_format = request.map_format;
        for (const float exponent : request.exponents) add_map(exponent);
        if (request.lambert) plan_.maps.push_back({1.0f, LEAST_MAP_SIZE, MapFilter::bilinear});
        plan_.map_count = plan_.maps.size();
        add_ladder(request.ladder);
        start();
        if (request.levels_up_to > 0) keep_levels();
        for (std::uint32_t i = 0; i < plan_.maps.size(); ++i)
            if (double(plan_.maps[i].exponent) >= CHAIN_EXPONENT) plan_map(i);
        for (std::uint32_t i = 0; i < plan_.maps.size(); ++i)
            if (double(plan_.maps[i].exponent) < CHAIN_EXPONENT) plan_harmonics(i);
        const auto maps = std::stable_partition(plan_.passes.begin(), plan_.passes.end(),
                                                [](const auto& pass) { return !pass.map; });
        plan_.first_map_pass = std::uint32_t(maps - plan_.passes.begin());
        const auto levels = std::stable_partition(plan_.passes.begin(), maps, reads_source);
        plan_.source_passes = std::uint32_t(levels - plan_.passes.begin());
        lay_out();
    }

private:
    static bool reads_source(const PlannedPass& pass) {
        using Kind = PlannedPass::Kind;
        return pass.kind == Kind::statistics || pass.kind == Kind::suns ||
               pass.kind == Kind::prepare || pass.kind == Kind::suns_out;
    }

    void add_map(float exponent) {
        plan_.maps.push_back(
            {exponent, size_for(double(exponent), tier_, plan_.source_size), MapFilter::spline});
    }

    void add_ladder(const Ladder& ladder) {
        plan_.ladder = ladder;
        if (!ladder.rungs) return;
        const double highest = double(exponent_at(ladder, ladder.rungs - 1));
        const double texels = tier_.ladder_texels_per_sigma;
        const double needed =
            std::max(2 * texels * std::sqrt(double(ladder.lowest)), texels * std::sqrt(highest));
        const std::uint32_t size = in_steps(needed, LEAST_MAP_SIZE, plan_.source_size);
        for (std::uint32_t rung = 0; rung < ladder.rungs; ++rung)
            plan_.maps.push_back({exponent_at(ladder, rung), size, MapFilter::bilinear});
    }

    double sharpest() const {
        double most = double(plan_.levels_up_to);
        for (const PrefilteredMap& map : plan_.maps) most = std::max(most, double(map.exponent));
        return most;
    }

    /// Statistics, suns, and the first level: the source, box-averaged where no map is so sharp as
    /// to see it.
    void start() {
        plan_.passes.push_back({PlannedPass::Kind::statistics});
        plan_.passes.push_back({PlannedPass::Kind::suns});
        std::uint32_t size = std::min(2 * LEAST_CHAIN_SIZE, plan_.source_size);
        while (size < plan_.source_size &&
               sharpest_for(size / 2, START_TEXELS_PER_SIGMA) < sharpest())
            size *= 2;
        first_ = prepare(size);
    }

    /// The source without suns, box-averaged to faces of `size`.
    std::uint32_t prepare(std::uint32_t size) {
        PlannedPass pass{PlannedPass::Kind::prepare};
        pass.target = add_level(size, NONE, texel_variance(size, 1.0 / 12), 2);
        pass.block = plan_.source_size / size;
        plan_.passes.push_back(pass);
        pass.kind = PlannedPass::Kind::suns_out;
        plan_.passes.push_back(pass);
        fill_margins(pass.target);
        return pass.target;
    }

    /// All that maps up to the sharpest can be made from, with the margins that they need.
    void keep_levels() {
        if (double(plan_.levels_up_to) >= CHAIN_EXPONENT) {
            source_for(CHAIN_EXPONENT);
            reserve_margin(first_,
                           [](double size) { return sharpest_for(size, HALVED_TEXELS_PER_SIGMA); });
            const auto least_of_chain = [](double size) {
                return sharpest_for(size, CHAIN_TEXELS_PER_SIGMA) / CHAIN_RATIO;
            };
            if (halved_) reserve_margin(*halved_, least_of_chain);
            for (const std::uint32_t level : chain_) reserve_margin(level, least_of_chain);
        }
        project();
    }

    /// For the least exponent that is made from a level: up to `most_of_next`, by its size, they
    /// are made from the next.
    void reserve_margin(std::uint32_t index, double (*most_of_next)(double size)) {
        ChainLevel& level = plan_.levels[index];
        const std::uint32_t next = level.size / 2;
        double least = CHAIN_EXPONENT;
        if (next >= LEAST_CHAIN_SIZE) least = std::max(least, most_of_next(next));
        const double variance = 1 / least - 1 / level.exponent - level.face_variance / 2;
        if (least <= double(plan_.levels_up_to))
            need_margin(level, std::min(tier_.cut * std::sqrt(std::max(variance, 0.0)), 1.3));
    }

    std::uint32_t add_level(std::uint32_t size, double exponent, double face_variance,
                            std::uint32_t margin) {
        plan_.levels.push_back({size, std::min(margin, size), 0, exponent, face_variance});
        return std::uint32_t(plan_.levels.size() - 1);
    }

    std::uint32_t halve(std::uint32_t source) {
        const ChainLevel from = plan_.levels[source];
        PlannedPass pass{PlannedPass::Kind::halve};
        pass.source = source;
        pass.target = add_level(from.size / 2, from.exponent,
                                from.face_variance + texel_variance(from.size, 0.75), 2);
        plan_.passes.push_back(pass);
        fill_margins(pass.target);
        return pass.target;
    }

    void fill_margins(std::uint32_t level) {
        PlannedPass pass{PlannedPass::Kind::margins};
        pass.target = level;
        plan_.passes.push_back(pass);
    }

    /// The coarsest level that a lobe of this exponent can be made from.
    std::uint32_t source_for(double exponent) {
        const std::uint32_t half = plan_.levels[first_].size / 2;
        if (half < LEAST_CHAIN_SIZE || sharpest_for(half, HALVED_TEXELS_PER_SIGMA) < exponent)
            return first_;
        if (!halved_) halved_ = halve(first_);
        std::uint32_t level = *halved_;
        for (std::size_t i = 0;; ++i) {
            const std::uint32_t size = plan_.levels[level].size / 2;
            const double next = sharpest_for(size, CHAIN_TEXELS_PER_SIGMA);
            if (size < LEAST_CHAIN_SIZE || next < CHAIN_RATIO * exponent) return level;
            if (i == chain_.size()) chain_.push_back(blur_level(level, size, next));
            level = chain_[i];
        }
    }

    std::uint32_t blur_level(std::uint32_t source, std::uint32_t size, double exponent) {
        PlannedPass pass{PlannedPass::Kind::blur_level};
        pass.source = source;
        pass.target = add_level(size, exponent, 0, 2);
        set_kernel(pass, exponent, 0);
        plan_.passes.push_back(pass);
        fill_margins(pass.target);
        return pass.target;
    }

    void plan_map(std::uint32_t index) {
        const PrefilteredMap& map = plan_.maps[index];
        PlannedPass pass{PlannedPass::Kind::blur_map};
        pass.source = source_for(double(map.exponent));
        pass.map = index;
        set_kernel(pass, double(map.exponent), read_variance(index));
        plan_.passes.push_back(pass);
    }

    double read_variance(std::uint32_t index) const {
        const PrefilteredMap& map = plan_.maps[index];
        return texel_variance(plan_.across(index),
                              map.filter == MapFilter::spline ? 1.0 / 3 : 1.0 / 6);
    }

    /// From the source's lobe to `exponent`, less what the source has been blurred beyond its lobe
    /// and what reading the target will blur.
    void set_kernel(PlannedPass& pass, double exponent, double reading) {
        ChainLevel& source = plan_.levels[pass.source];
        const double variance = 1 / exponent - 1 / source.exponent;
        pass.narrowing = source.face_variance + reading;
        pass.drift = 4 * source.face_variance + reading;
        const double left = variance - pass.narrowing;
        const double texel = 2.0 / source.size;
        if (left < 0.25 * texel * texel) {
            // Sharper than the source: the source's nearest texels, at least one.
            pass.kernel = {10 / (texel * texel), 0.5, 0.5 * texel * texel};
            pass.narrowing = 0;
            pass.drift = 0;
            return;
        }
        const bool sharp = pass.kind == PlannedPass::Kind::blur_map && exponent >= SHARP_EXPONENT;
        const double reach =
            (sharp ? tier_.sharp_cut : tier_.cut) * std::sqrt(variance - pass.narrowing / 2);
        const double last_chord = reach < 1.3 ? 1 - std::cos(reach) : 1 - std::cos(1.3);
        const std::vector<double> to = lobe_eigenvalues(exponent, 3);
        const std::vector<double> from = lobe_eigenvalues(source.exponent, 3);
        pass.kernel = match_kernel({to[1] / from[1], to[2] / from[2]}, last_chord);
        need_margin(source, std::min(reach, 1.3));
    }

    /// A kernel reaches furthest into a neighbour at a corner, by 2.13 units of the face's plane a
    /// radian at most.
    static void need_margin(ChainLevel& level, double reach) {
        const double texels = 2.13 * reach * level.size / 2 + 2;
        const std::uint32_t even = (std::uint32_t(std::ceil(texels)) + 1) / 2 * 2;
        level.margin = std::max(level.margin, std::min(even, level.size));
    }

    /// A level of the least size, blurred evenly: the same whatever else is asked for, so that maps
    /// of low exponents have the same bits without the sharp ones.
    std::uint32_t low_source() {
        if (low_) return *low_;
        const std::uint32_t size = std::min(2 * LEAST_CHAIN_SIZE, plan_.source_size);
        const std::uint32_t first = plan_.levels[first_].size == size ? first_ : prepare(size);
        low_ = size <= LEAST_CHAIN_SIZE
                   ? first
                   : blur_level(first, LEAST_CHAIN_SIZE,
                                sharpest_for(LEAST_CHAIN_SIZE, CHAIN_TEXELS_PER_SIGMA));
        return *low_;
    }

    /// The low level's spherical harmonics.
    std::uint32_t project() {
        const std::uint32_t source = low_source();
        if (plan_.terms_bytes) return source;
        PlannedPass pass{PlannedPass::Kind::project};
        pass.source = source;
        plan_.passes.push_back(pass);
        plan_.passes.push_back({PlannedPass::Kind::sum});
        const std::uint32_t size = plan_.levels[source].size;
        plan_.terms_bytes = VkDeviceSize(6) * size * size / CHUNK_TEXELS * TERMS * TERM_BYTES;
        return source;
    }

    void plan_harmonics(std::uint32_t index) {
        const PrefilteredMap& map = plan_.maps[index];
        const ChainLevel& from = plan_.levels[project()];
        const double blurred =
            mean_on_sphere(from.face_variance) + MEAN_READING * read_variance(index);
        PlannedPass expand{PlannedPass::Kind::expand};
        expand.map = index;
        expand.narrowing = read_variance(index);
        const std::uint32_t degrees = degrees_for(double(map.exponent), tier_.series_end);
        const std::vector<double> to = lobe_eigenvalues(double(map.exponent), degrees);
        const std::vector<double> done = lobe_eigenvalues(from.exponent, degrees);
        for (std::uint32_t l = 0; l < degrees; ++l)
            expand.eigenvalues.push_back(to[l] / done[l] * std::exp(0.5 * l * (l + 1) * blurred));
        plan_.passes.push_back(expand);
    }

    void lay_out() {
        const std::uint64_t across = plan_.source_size / 8;
        plan_.tiles_bytes = 6 * across * across * 16;
        const auto align = [](VkDeviceSize size) {
            return (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
        };
        plan_.terms_offset = align(plan_.tiles_bytes);
        VkDeviceSize offset = plan_.terms_offset + align(plan_.terms_bytes);
        for (ChainLevel& level : plan_.levels) {
            level.offset = offset;
            offset += align(level.bytes());
        }
        plan_.scratch_bytes = offset;
    }

    const Tier& tier_;
    PrefilterPlan::State& plan_;
    // Levels made so far, each half the size of the one before.
    std::uint32_t first_ = 0;
    std::optional<std::uint32_t> halved_;
    std::vector<std::uint32_t> chain_;
    std::optional<std::uint32_t> low_; // the one that low exponents are made from
};

} // namespace

void plan_passes(const PrefilterRequest& request, PrefilterPlan::State& plan) {
    Planner(request, plan).run(request);
}

} // namespace lobelia
