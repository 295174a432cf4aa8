#include "host/averages.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>

#include "host/sizes.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t MOST_QUERIES = 1 << 18; // in one buffer: 8 MiB

Outcome<Exact::Sizes> sizes_of(const ExactSource& source, const ExactSettings& settings) {
    const auto sizes = source.is_panorama ? Exact::sizes(source.panorama, settings)
                                          : Exact::sizes(source.cube, settings);
    if (!sizes) return core_failure(sizes.error());
    return *sizes;
}

/// Runs one list of queries that fits into one buffer.
Outcome<Done> average_batch(Gpu& gpu, const Exact& exact, const ExactSource& source,
                            const ExactSettings& settings, std::span<const ExactQuery> queries,
                            const Progress& progress, Averages& result) {
    const auto sizes = sizes_of(source, settings);
    if (!sizes) return sizes.error();
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const auto asked = gpu.create_buffer(sizes->queries, storage, Memory::host);
    if (!asked) return asked.error();
    const auto answered = gpu.create_buffer(sizes->results, storage, Memory::host);
    if (!answered) return answered.error();
    const auto tables = gpu.create_buffer(sizes->tables, storage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                          Memory::device);
    if (!tables) return tables.error();
    std::memcpy(asked->data(), queries.data(), queries.size_bytes());

    const auto job = source.is_panorama ? exact.bind(source.panorama, settings, asked->handle(),
                                                     answered->handle(), tables->handle())
                                        : exact.bind(source.cube, settings, asked->handle(),
                                                     answered->handle(), tables->handle());
    if (!job) return core_failure(job.error());
    for (std::uint32_t step = 0; step < job->steps(); ++step) {
        if (progress && !progress(double(step) / job->steps())) return Failure{"cancelled"};
        const auto done = run_pass(
            gpu, result.report, [&](VkCommandBuffer commands) { job->record(commands, step, 1); });
        if (!done) return done.error();
    }
    const auto* const values = reinterpret_cast<const float*>(answered->data());
    result.texels.insert(result.texels.end(), values, values + CHANNELS * queries.size());
    return Done{};
}

} // namespace

ExactSource exact_source(const GpuEnvironment& environment) {
    const bool is_panorama = environment.panorama.has_value();
    const GpuImage& image = is_panorama ? *environment.panorama : environment.cube;
    const GpuImageDescription& shape = image.description();
    ExactSource source{.is_panorama = is_panorama, .bytes = image_bytes(image)};
    if (is_panorama)
        source.panorama = {image.handle(), shape.format, shape.width, shape.height};
    else
        source.cube = lend_cube(image);
    return source;
}

Outcome<Averages> average(Gpu& gpu, const Exact& exact, const ExactSource& source,
                          ExactSettings settings, std::span<const ExactQuery> queries,
                          const Progress& progress) {
    Averages result;
    result.report = exact_pass("exact", source.bytes, queries.size());
    result.texels.reserve(CHANNELS * queries.size());
    for (std::size_t first = 0; first < queries.size(); first += MOST_QUERIES) {
        const std::size_t count = std::min<std::size_t>(MOST_QUERIES, queries.size() - first);
        const double size = double(queries.size());
        settings.query_count = std::uint32_t(count);
        const auto done = average_batch(
            gpu, exact, source, settings, queries.subspan(first, count),
            share(progress, double(first) / size, double(first + count) / size), result);
        if (!done) return done.error();
    }
    for (std::size_t i = CHANNELS - 1; i < result.texels.size(); i += CHANNELS)
        result.texels[i] = 1.0f;
    return result;
}

PassReport exact_pass(const std::string& name, std::uint64_t source_bytes, std::uint64_t count) {
    return {.name = name,
            .invocations = count,
            .bytes_read = source_bytes + count * sizeof(ExactQuery),
            .bytes_written = count * CHANNELS * sizeof(float)};
}

double exact_work(const PassReport& pass, float exponent) {
    // Where the lobe has fallen to a thousandth; at least a few texels.
    const double share = 0.5 * (1 - std::pow(1e-3, 1 / std::max(double(exponent), 1.0)));
    return double(pass.bytes_read) * double(pass.invocations) * (share + 1e-4);
}

Progress share(const Progress& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double done) { return progress(from + done * (to - from)); };
}

double process_milliseconds() {
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

Outcome<Done> run_pass(Gpu& gpu, PassReport& report,
                       const std::function<void(VkCommandBuffer)>& record) {
    const double start = process_milliseconds();
    const auto device_ms = gpu.submit_timed(record);
    if (!device_ms) return device_ms.error();
    report.cpu_ms = report.cpu_ms.value_or(0.0) + process_milliseconds() - start;
    if (*device_ms) report.gpu_ms = report.gpu_ms.value_or(0.0) + **device_ms;
    return Done{};
}

Failure core_failure(const Error& error) {
    if (error.code == VK_ERROR_VALIDATION_FAILED_EXT) return Failure{error.step};
    return Failure{"could not " + std::string(error.step) + " (VkResult " +
                   std::to_string(int(error.code)) + ")"};
}

std::uint64_t image_texels(const GpuImage& image) {
    const GpuImageDescription& shape = image.description();
    std::uint64_t texels = 0;
    for (std::uint32_t level = 0; level < shape.levels; ++level)
        texels += std::uint64_t(std::max(shape.width >> level, 1u)) *
                  std::max(shape.height >> level, 1u) * shape.layers;
    return texels;
}

std::uint64_t image_bytes(const GpuImage& image) {
    const bool half = image.description().format == VK_FORMAT_R16G16B16A16_SFLOAT;
    return CHANNELS * (half ? 2 : 4) * image_texels(image);
}

CubeMap lend_cube(const GpuImage& image) {
    const GpuImageDescription& shape = image.description();
    return {image.handle(), shape.format, shape.width, shape.levels};
}

const char* format_name(VkFormat format) {
    return format == VK_FORMAT_R16G16B16A16_SFLOAT ? "R16G16B16A16_SFLOAT" : "R32G32B32A32_SFLOAT";
}

ImageReport image_report(const std::string& name, const GpuImage& image, const char* lifetime) {
    const GpuImageDescription& shape = image.description();
    return {name,
            shape.width,
            shape.height,
            shape.layers,
            shape.levels,
            format_name(shape.format),
            image_bytes(image),
            lifetime};
}

} // namespace lobelia::host
