// Error and cost of the prefilter: measure_prefilter [fast|normal|high [FACE [WHAT]]], where WHAT
// is cost, or photographs or made for the error over those panoramas; all without it.
//
// Error: pointwise relative, |x - exact| / (|exact| + 1e-3 mean), over random directions and R G B;
// x as MapReader reads it, exact from Exact over the panorama's own texels. Mean: the largest
// relative difference of a channel's mean over the sphere, as it is read, to the panorama's. Cost:
// process CPU time, median of nine, over that of a vkCmdBlitImage mip chain of the same cube map in
// the same run.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "made_panoramas.h"
#include "prefilter_maps.h"
#include "support/error_measures.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

constexpr int DIRECTIONS = 150;
constexpr int GRID = 256; // of the mean over the sphere
const std::vector<float> EXPONENTS = {0,  0.5f, 1,   2,   4.8f, 8,   11,  16,   32,   37,   45,
                                      64, 128,  150, 256, 300,  512, 700, 1024, 2048, 4096, 1e4f};

/// The grid's directions and their shares of the sphere.
struct Grid {
    Directions directions;
    std::vector<double> shares;
};

Grid make_grid() {
    Grid grid;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < GRID; ++y)
            for (int x = 0; x < GRID; ++x) {
                grid.directions.push_back(oracle::cube_direction(face, x + 0.5, y + 0.5, GRID));
                grid.shares.push_back(oracle::cube_texel_solid_angle(x, y, GRID) /
                                      (4 * oracle::PI));
            }
    return grid;
}

double mean_error(const std::vector<double>& values, const Grid& grid, const oracle::Rgb& mean) {
    oracle::Rgb kept{};
    for (std::size_t i = 0; i < values.size(); ++i) kept[i % 3] += grid.shares[i / 3] * values[i];
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(kept[c] / mean[c] - 1) > std::abs(worst)) worst = kept[c] / mean[c] - 1;
    return worst;
}

std::vector<MadePanorama> photographs() {
    std::vector<MadePanorama> list;
    for (const std::string& name : REAL_PANORAMAS) list.push_back({name, real_panorama(name)});
    return list;
}

void measure_error(host::Gpu& gpu, Quality quality, std::uint32_t face,
                   const std::vector<MadePanorama>& panoramas) {
    const auto exact = value_of(Exact::create(gpu.device()));
    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    const auto reader = value_of(MapReader::create(gpu.device()));
    const auto directions = oracle::test_directions(DIRECTIONS, 7);
    const Grid grid = make_grid();
    const std::size_t count = EXPONENTS.size() + 1; // and Lambert
    struct Row {
        double mean = 0, worst = 0, tail = 0, kept = 0;
        std::string name;
    };
    std::vector<Row> rows(count);
    for (const MadePanorama& panorama : panoramas) {
        const Environment environment = load(gpu, panorama.image, face);
        const Maps maps = bind_maps(gpu, prefilter, environment.cube, EXPONENTS, true, quality);
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            maps.job.record(commands, 0, maps.plan.pass_count());
        }));
        for (std::size_t i = 0; i < count; ++i) {
            const float exponent = maps.plan.maps()[i].exponent;
            const auto error =
                oracle::measure_error(read(gpu, reader, maps, i, directions),
                                      truth(gpu, exact, environment.lent, exponent, directions));
            const double kept =
                mean_error(read(gpu, reader, maps, i, grid.directions), grid, environment.mean);
            Row& row = rows[i];
            row.mean += error.pointwise_rms / double(panoramas.size());
            if (error.pointwise_rms > row.worst) {
                row.worst = error.pointwise_rms;
                row.name = panorama.name;
            }
            row.tail = std::max(row.tail, error.pointwise_p999);
            if (std::abs(kept) > std::abs(row.kept)) row.kept = kept;
        }
    }
    std::printf(
        "| n | mean RMS | worst RMS | worst 99.9th percentile | mean kept within | worst |\n"
        "| --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t i = 0; i < count; ++i) {
        if (i < EXPONENTS.size())
            std::printf("| %g", double(EXPONENTS[i]));
        else
            std::printf("| Lambert");
        const Row& row = rows[i];
        std::printf(" | %.1e | %.1e | %.1e | %.1e | %s |\n", row.mean, row.worst, row.tail,
                    row.kept, row.name.c_str());
    }
}

double cpu_milliseconds() {
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

double median_cost(host::Gpu& gpu, int repeats,
                   const std::function<void(VkCommandBuffer)>& record) {
    std::vector<double> costs;
    for (int run = 0; run < 9; ++run) {
        const double start = cpu_milliseconds();
        for (int i = 0; i < repeats; ++i) value_of(gpu.submit(record));
        costs.push_back((cpu_milliseconds() - start) / repeats);
    }
    std::nth_element(costs.begin(), costs.begin() + 4, costs.end());
    return costs[4];
}

void record_mip_chain(const host::Gpu& gpu, VkCommandBuffer commands, const host::GpuImage& cube) {
    const auto blit = reinterpret_cast<PFN_vkCmdBlitImage>(
        gpu.device().get_device_proc_addr(gpu.device().handle, "vkCmdBlitImage"));
    const host::GpuImageDescription& shape = cube.description();
    for (std::uint32_t level = 1; level < shape.levels; ++level) {
        record_layout_change(gpu, commands, cube, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
        const auto from = std::int32_t(shape.width >> (level - 1)), to = from / 2;
        const VkImageBlit region{.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, 6},
                                 .srcOffsets = {{}, {from, from, 1}},
                                 .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 6},
                                 .dstOffsets = {{}, {to, to, 1}}};
        blit(commands, cube.handle(), VK_IMAGE_LAYOUT_GENERAL, cube.handle(),
             VK_IMAGE_LAYOUT_GENERAL, 1, &region, VK_FILTER_LINEAR);
    }
}

void measure_cost(host::Gpu& gpu, Quality quality, std::uint32_t face) {
    const Environment environment = load(gpu, real_panorama("city"), face);
    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    std::uint32_t levels = 1;
    while (face >> levels) ++levels;
    const auto chain = cube_image(gpu, VK_FORMAT_R32G32B32A32_SFLOAT, face, levels);
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        record_layout_change(gpu, commands, chain, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_GENERAL);
    }));
    const double yardstick = median_cost(
        gpu, 20, [&](VkCommandBuffer commands) { record_mip_chain(gpu, commands, chain); });
    std::printf("mip chain by vkCmdBlitImage: %.2f ms\n", yardstick);

    const std::vector<float> six = {2048, 512, 128, 32, 8, 2}, one = {8};
    for (const bool full : {true, false}) {
        const Maps maps =
            bind_maps(gpu, prefilter, environment.cube, full ? six : one, full, quality);
        const double cost = median_cost(gpu, 1, [&](VkCommandBuffer commands) {
            maps.job.record(commands, 0, maps.plan.pass_count());
        });
        std::printf("%s: %.1f ms, %.1f times that\n",
                    full ? "n = 2048 512 128 32 8 2 and Lambert" : "n = 8 alone", cost,
                    cost / yardstick);
        for (std::uint32_t i = 0; full && i < maps.plan.pass_count(); ++i) {
            const double part = median_cost(
                gpu, 1, [&](VkCommandBuffer commands) { maps.job.record(commands, i, 1); });
            std::printf("    %-12s %6.2f ms\n", maps.plan.pass(i).name, part);
        }
    }
}

} // namespace
} // namespace lobelia::test

int main(int argc, char** argv) {
    using namespace lobelia;
    const std::string tier = argc > 1 ? argv[1] : "normal";
    const Quality quality = tier == "fast"   ? Quality::fast
                            : tier == "high" ? Quality::high
                                             : Quality::normal;
    const auto face = std::uint32_t(argc > 2 ? std::atoi(argv[2]) : 256);
    const std::string what = argc > 3 ? argv[3] : "";
    auto gpu = test::value_of(host::Gpu::create());
    std::printf("%s, quality %s, source faces of %u texels\n", gpu.description().name.c_str(),
                tier.c_str(), face);
    if (what.empty() || what == "cost") test::measure_cost(gpu, quality, face);
    if (what.empty() || what == "photographs")
        test::measure_error(gpu, quality, face, test::photographs());
    if (what.empty() || what == "made")
        test::measure_error(gpu, quality, face, test::made_panoramas());
}
