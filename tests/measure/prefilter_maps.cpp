#include "prefilter_maps.h"

#include <cstring>

namespace lobelia::test {
namespace {

constexpr VkImageUsageFlags USAGE = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_DST_BIT;
constexpr VkFormat FLOATS = VK_FORMAT_R32G32B32A32_SFLOAT;

host::GpuBuffer storage(host::Gpu& gpu, VkDeviceSize bytes) {
    return value_of(gpu.create_buffer(
        bytes,
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        host::Memory::host));
}

std::vector<double> colours(const host::GpuBuffer& texels, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        for (std::uint32_t c = 0; c < 3; ++c) {
            float value;
            std::memcpy(&value, texels.data() + (4 * i + c) * sizeof value, sizeof value);
            values.push_back(double(value));
        }
    return values;
}

} // namespace

host::GpuImage cube_image(host::Gpu& gpu, VkFormat format, std::uint32_t face,
                          std::uint32_t levels) {
    return value_of(gpu.create_image({.format = format,
                                      .width = face,
                                      .height = face,
                                      .layers = 6,
                                      .levels = levels,
                                      .usage = USAGE,
                                      .cube = true}));
}

Environment load(host::Gpu& gpu, const host::Image& image, std::uint32_t face) {
    auto panorama =
        value_of(gpu.create_image({.width = image.width, .height = image.height, .usage = USAGE}));
    value_of(gpu.upload(image, panorama));
    const Panorama lent{panorama.handle(), FLOATS, image.width, image.height};
    auto cube = cube_image(gpu, FLOATS, face);
    const auto resample = value_of(PanoramaToCube::create(gpu.device()));
    const auto job = value_of(resample.bind(lent, cube_of(cube)));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return {std::move(panorama), std::move(cube), lent, source_of(image).mean()};
}

Maps bind_maps(host::Gpu& gpu, const Prefilter& prefilter, const host::GpuImage& cube,
               std::span<const float> exponents, bool lambert, Quality quality, VkFormat format) {
    auto plan = value_of(PrefilterPlan::make({.exponents = exponents,
                                              .lambert = lambert,
                                              .quality = quality,
                                              .map_format = format,
                                              .source_size = cube.description().width}));
    std::vector<host::GpuImage> images;
    std::vector<CubeMap> lent;
    for (const PrefilteredMap& map : plan.maps()) {
        images.push_back(cube_image(gpu, format, map.size));
        lent.push_back(cube_of(images.back()));
    }
    auto scratch = storage(gpu, plan.scratch_size());
    auto state = storage(gpu, plan.state_size());
    auto job =
        value_of(prefilter.bind(plan, cube_of(cube), lent, scratch.handle(), state.handle()));
    return {std::move(plan), std::move(images), std::move(scratch), std::move(state),
            std::move(job)};
}

std::vector<double> truth(host::Gpu& gpu, const Exact& exact, const Panorama& panorama,
                          float exponent, const Directions& directions) {
    const ExactSettings settings{.exponent = exponent,
                                 .query_count = std::uint32_t(directions.size())};
    const auto sizes = value_of(Exact::sizes(panorama, settings));
    auto queries = storage(gpu, sizes.queries);
    auto results = storage(gpu, sizes.results);
    auto tables = storage(gpu, sizes.tables);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const oracle::Direction& d = directions[i];
        const ExactQuery query{.axis = {float(d.x), float(d.y), float(d.z)}};
        std::memcpy(queries.data() + i * sizeof query, &query, sizeof query);
    }
    const auto job = value_of(
        exact.bind(panorama, settings, queries.handle(), results.handle(), tables.handle()));
    for (std::uint32_t step = 0; step < job.steps(); ++step)
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, step, 1); }));
    return colours(results, directions.size());
}

std::vector<double> read(host::Gpu& gpu, const MapReader& reader, const Maps& maps,
                         std::size_t index, const Directions& directions) {
    auto input = storage(gpu, directions.size() * 16);
    auto output = storage(gpu, directions.size() * 16);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const oracle::Direction& d = directions[i];
        const float axis[4] = {float(d.x), float(d.y), float(d.z), 0};
        std::memcpy(input.data() + i * sizeof axis, axis, sizeof axis);
    }
    const auto job = value_of(reader.bind({.map = maps.plan.maps()[index],
                                           .view = maps.images[index].view(),
                                           .state = maps.state.handle(),
                                           .directions = input.handle(),
                                           .results = output.handle(),
                                           .count = std::uint32_t(directions.size())}));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return colours(output, directions.size());
}

} // namespace lobelia::test
