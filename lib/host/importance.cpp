#include "host/importance.h"

#include <algorithm>
#include <cstring>

#include "host/sizes.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t MOST_AXES = 1 << 18; // in one buffer: 4 MiB

/// Runs one list of axes that fits into one buffer.
Outcome<Done> average_batch(Gpu& gpu, const Importance& importance, const GpuImage& source,
                            const ImportanceSettings& settings, std::span<const Vector> axes,
                            const Progress& progress, Averages& result) {
    std::vector<float> values;
    for (const Vector& axis : axes)
        values.insert(values.end(), {float(axis.x), float(axis.y), float(axis.z), 0.0f});
    const VkDeviceSize bytes = values.size() * sizeof(float);
    const auto asked = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!asked) return asked.error();
    const auto answered =
        gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!answered) return answered.error();
    std::memcpy(asked->data(), values.data(), bytes);

    const auto job =
        importance.bind(lend_cube(source), settings, asked->handle(), answered->handle());
    if (!job) return core_failure(job.error());
    for (std::uint32_t step = 0; step < job->steps(); ++step) {
        if (progress && !progress(double(step) / job->steps())) return Failure{"cancelled"};
        const auto done = run_pass(
            gpu, result.report, [&](VkCommandBuffer commands) { job->record(commands, step, 1); });
        if (!done) return done.error();
    }
    std::memcpy(values.data(), answered->data(), bytes);
    result.texels.insert(result.texels.end(), values.begin(), values.end());
    return Done{};
}

} // namespace

Outcome<Averages> average_by_samples(Gpu& gpu, const Importance& importance, const GpuImage& source,
                                     ImportanceSettings settings, std::span<const Vector> axes,
                                     const Progress& progress) {
    Averages result;
    result.report = importance_pass(settings.filtered, image_bytes(source), axes.size());
    result.texels.reserve(CHANNELS * axes.size());
    const double size = double(axes.size());
    for (std::size_t first = 0; first < axes.size(); first += MOST_AXES) {
        const std::size_t count = std::min<std::size_t>(MOST_AXES, axes.size() - first);
        settings.query_count = std::uint32_t(count);
        const auto done = average_batch(
            gpu, importance, source, settings, axes.subspan(first, count),
            share(progress, double(first) / size, double(first + count) / size), result);
        if (!done) return done.error();
    }
    return result;
}

PassReport importance_pass(bool filtered, std::uint64_t mips_bytes, std::uint64_t count) {
    const std::uint64_t bytes = count * CHANNELS * sizeof(float);
    return {.name = filtered ? "filtered importance" : "importance",
            .invocations = count,
            .bytes_read = mips_bytes + bytes,
            .bytes_written = bytes};
}

} // namespace lobelia::host
