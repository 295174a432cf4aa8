// Error and cost of the prefilter: measure_prefilter [fast|normal|high [FACE]].
//
// Error: pointwise relative, |x - exact| / (|exact| + 1e-3 mean), over random directions and R G B;
// x as MapReader reads it, exact from Exact over the panorama's own texels. Cost: process CPU time,
// median of nine, over that of a vkCmdBlitImage mip chain of the same cube map in the same run.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <numeric>

#include <lobelia/exact.h>
#include <lobelia/map_reader.h>
#include <lobelia/panorama.h>
#include <lobelia/prefilter.h>

#include "support/environments.h"
#include "support/error_measures.h"
#include "support/gpu_sources.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

constexpr std::uint32_t DIRECTIONS = 150;
const std::vector<float> EXPONENTS = {1,  2,   4.8f, 8,   11,  16,  32,   37,
                                      64, 128, 150,  256, 512, 700, 1024, 2048};

constexpr VkImageUsageFlags USAGE = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_DST_BIT;
constexpr VkFormat FLOATS = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat HALVES = VK_FORMAT_R16G16B16A16_SFLOAT;

host::GpuBuffer storage(host::Gpu& gpu, VkDeviceSize bytes) {
    return value_of(gpu.create_buffer(
        bytes,
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        host::Memory::host));
}

host::GpuImage cube_image(host::Gpu& gpu, VkFormat format, std::uint32_t face,
                          std::uint32_t levels = 1) {
    return value_of(gpu.create_image({.format = format,
                                      .width = face,
                                      .height = face,
                                      .layers = 6,
                                      .levels = levels,
                                      .usage = USAGE,
                                      .cube = true}));
}

/// A panorama on the device with its cube map.
struct Environment {
    host::GpuImage panorama;
    host::GpuImage cube;
    Panorama lent;
};

Environment load(host::Gpu& gpu, const std::string& name, std::uint32_t face) {
    const host::Image image = real_panorama(name);
    auto panorama =
        value_of(gpu.create_image({.width = image.width, .height = image.height, .usage = USAGE}));
    value_of(gpu.upload(image, panorama));
    const Panorama lent{panorama.handle(), FLOATS, image.width, image.height};
    auto cube = cube_image(gpu, FLOATS, face);
    const auto resample = value_of(PanoramaToCube::create(gpu.device()));
    const auto job = value_of(resample.bind(lent, cube_of(cube)));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return {std::move(panorama), std::move(cube), lent};
}

/// The maps of a plan with what they need.
struct Maps {
    PrefilterPlan plan;
    std::vector<host::GpuImage> images;
    host::GpuBuffer scratch, state;
    PrefilterJob job;
};

Maps prepare(host::Gpu& gpu, const Prefilter& prefilter, const host::GpuImage& cube,
             std::span<const float> exponents, bool lambert, Quality quality) {
    auto plan = value_of(PrefilterPlan::make({.exponents = exponents,
                                              .lambert = lambert,
                                              .quality = quality,
                                              .source_size = cube.description().width}));
    std::vector<host::GpuImage> images;
    std::vector<CubeMap> lent;
    for (const PrefilteredMap& map : plan.maps()) {
        images.push_back(cube_image(gpu, HALVES, map.size));
        lent.push_back(cube_of(images.back()));
    }
    auto scratch = storage(gpu, plan.scratch_size());
    auto state = storage(gpu, plan.state_size());
    auto job =
        value_of(prefilter.bind(plan, cube_of(cube), lent, scratch.handle(), state.handle()));
    return {std::move(plan), std::move(images), std::move(scratch), std::move(state),
            std::move(job)};
}

std::vector<double> colours(const host::GpuBuffer& texels) {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < DIRECTIONS; ++i)
        for (std::uint32_t c = 0; c < 3; ++c) {
            float value;
            std::memcpy(&value, texels.data() + (4 * i + c) * sizeof value, sizeof value);
            values.push_back(double(value));
        }
    return values;
}

std::vector<double> truth(host::Gpu& gpu, const Exact& exact, const Panorama& panorama,
                          float exponent, const std::vector<oracle::Direction>& directions) {
    const ExactSettings settings{.exponent = exponent, .query_count = DIRECTIONS};
    const auto sizes = value_of(Exact::sizes(panorama, settings));
    auto queries = storage(gpu, sizes.queries);
    auto results = storage(gpu, sizes.results);
    auto tables = storage(gpu, sizes.tables);
    for (std::uint32_t i = 0; i < DIRECTIONS; ++i) {
        const oracle::Direction& d = directions[i];
        const ExactQuery query{.axis = {float(d.x), float(d.y), float(d.z)}};
        std::memcpy(queries.data() + i * sizeof query, &query, sizeof query);
    }
    const auto job = value_of(
        exact.bind(panorama, settings, queries.handle(), results.handle(), tables.handle()));
    for (std::uint32_t step = 0; step < job.steps(); ++step)
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, step, 1); }));
    return colours(results);
}

std::vector<double> read(host::Gpu& gpu, const MapReader& reader, const Maps& maps,
                         std::size_t index, const std::vector<oracle::Direction>& directions) {
    auto input = storage(gpu, DIRECTIONS * 16);
    auto output = storage(gpu, DIRECTIONS * 16);
    for (std::uint32_t i = 0; i < DIRECTIONS; ++i) {
        const oracle::Direction& d = directions[i];
        const float axis[4] = {float(d.x), float(d.y), float(d.z), 0};
        std::memcpy(input.data() + i * sizeof axis, axis, sizeof axis);
    }
    const auto job = value_of(reader.bind({.map = maps.plan.maps()[index],
                                           .view = maps.images[index].view(),
                                           .state = maps.state.handle(),
                                           .directions = input.handle(),
                                           .results = output.handle(),
                                           .count = DIRECTIONS}));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return colours(output);
}

void measure_error(host::Gpu& gpu, Quality quality, std::uint32_t face) {
    const auto exact = value_of(Exact::create(gpu.device()));
    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    const auto reader = value_of(MapReader::create(gpu.device()));
    const auto directions = oracle::test_directions(DIRECTIONS, 7);
    const std::size_t count = EXPONENTS.size() + 1; // and Lambert
    std::vector<double> mean(count), worst(count), worst_tail(count);
    for (const std::string& name : REAL_PANORAMAS) {
        const Environment environment = load(gpu, name, face);
        const Maps maps = prepare(gpu, prefilter, environment.cube, EXPONENTS, true, quality);
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            maps.job.record(commands, 0, maps.plan.pass_count());
        }));
        for (std::size_t i = 0; i < count; ++i) {
            const float exponent = maps.plan.maps()[i].exponent;
            const auto error =
                oracle::measure_error(read(gpu, reader, maps, i, directions),
                                      truth(gpu, exact, environment.lent, exponent, directions));
            mean[i] += error.pointwise_rms / double(REAL_PANORAMAS.size());
            worst[i] = std::max(worst[i], error.pointwise_rms);
            worst_tail[i] = std::max(worst_tail[i], error.pointwise_p999);
        }
    }
    std::printf(
        "| n | mean RMS | worst RMS | worst 99.9th percentile |\n| --- | --- | --- | --- |\n");
    for (std::size_t i = 0; i < count; ++i) {
        if (i < EXPONENTS.size())
            std::printf("| %g", double(EXPONENTS[i]));
        else
            std::printf("| Lambert");
        std::printf(" | %.1e | %.1e | %.1e |\n", mean[i], worst[i], worst_tail[i]);
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
    const Environment environment = load(gpu, "city", face);
    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    std::uint32_t levels = 1;
    while (face >> levels) ++levels;
    const auto chain = cube_image(gpu, FLOATS, face, levels);
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
            prepare(gpu, prefilter, environment.cube, full ? six : one, full, quality);
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
    auto gpu = test::value_of(host::Gpu::create());
    std::printf("%s, quality %s, source faces of %u texels\n", gpu.description().name.c_str(),
                tier.c_str(), face);
    test::measure_cost(gpu, quality, face);
    test::measure_error(gpu, quality, face);
}
