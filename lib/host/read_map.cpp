#include <cstring>

#include "host/maps.h"

namespace lobelia::host {

Outcome<Averages> read_map(Gpu& gpu, const MapReader& reader, const PrefilteredMaps& maps,
                           std::size_t index, std::span<const Vector> axes) {
    std::vector<float> values;
    for (const Vector& axis : axes)
        values.insert(values.end(), {float(axis.x), float(axis.y), float(axis.z), 0.0f});
    const VkDeviceSize bytes = values.size() * sizeof(float);
    const auto input = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!input) return input.error();
    std::memcpy(input->data(), values.data(), bytes);
    const auto output = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!output) return output.error();
    const auto job = reader.bind({.map = maps.descriptions[index],
                                  .view = maps.images[index].view(),
                                  .state = maps.state.handle(),
                                  .directions = input->handle(),
                                  .results = output->handle(),
                                  .count = std::uint32_t(axes.size())});
    if (!job) return core_failure(job.error());
    PassReport run = read_map_pass(image_bytes(maps.images[index]), axes.size());
    const auto done = run_pass(gpu, run, [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    std::memcpy(values.data(), output->data(), bytes);
    return Averages{std::move(values), run};
}

PassReport read_map_pass(std::uint64_t map_bytes, std::uint64_t count) {
    const std::uint64_t bytes = count * 4 * sizeof(float);
    return {.name = "read map",
            .invocations = count,
            .bytes_read = bytes + map_bytes,
            .bytes_written = bytes};
}

} // namespace lobelia::host
