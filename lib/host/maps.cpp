#include "host/maps.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include <lobelia/expected_error.h>

#include "host/averages.h"
#include "host/text.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LEAST_FACE = 16;     // that the prefilter reads
constexpr std::uint32_t LARGEST_FACE = 1024; // likewise
constexpr std::size_t SUN_COUNT_OFFSET = 8;  // bytes, in PrefilterState of lobelia/suns.glsl
constexpr VkImageUsageFlags MAP_USAGE =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

Outcome<std::vector<GpuImage>> make_images(Gpu& gpu, std::span<const PrefilteredMap> maps) {
    std::vector<GpuImage> images;
    for (const PrefilteredMap& map : maps) {
        auto image = gpu.create_image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                       .width = map.size,
                                       .height = map.size,
                                       .layers = 6,
                                       .usage = MAP_USAGE,
                                       .cube = true});
        if (!image) return image.error();
        images.push_back(std::move(*image));
    }
    return images;
}

Outcome<std::optional<GpuImage>> make_ladder_image(Gpu& gpu, const PrefilterPlan& plan) {
    if (!plan.ladder().rungs) return std::optional<GpuImage>{};
    auto image = gpu.create_image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                   .width = plan.ladder_size(),
                                   .height = plan.ladder_size(),
                                   .layers = 6 * plan.ladder().rungs,
                                   .usage = MAP_USAGE});
    if (!image) return image.error();
    return std::optional<GpuImage>(std::move(*image));
}

Outcome<Done> run(Gpu& gpu, const PrefilterPlan& plan, const PrefilterJob& job,
                  const Progress& progress, WorkReport& report) {
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i) {
        const PrefilterPass pass = plan.pass(i);
        PassReport ran{.name = pass.name,
                       .invocations = pass.invocations,
                       .bytes_read = pass.bytes_read,
                       .bytes_written = pass.bytes_written};
        const auto done =
            run_pass(gpu, ran, [&](VkCommandBuffer commands) { job.record(commands, i, 1); });
        if (!done) return done.error();
        report.passes.push_back(ran);
        if (progress && !progress(double(i + 1) / plan.pass_count())) return Failure{"cancelled"};
    }
    return Done{};
}

} // namespace

std::uint32_t prefilter_face(std::uint32_t face) {
    return std::clamp(std::bit_ceil(face), LEAST_FACE, LARGEST_FACE);
}

Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, PrefilterRequest request) {
    request.source_size = environment.source().description().width;
    const auto plan = PrefilterPlan::make(request);
    if (!plan) return core_failure(plan.error());
    return bind_maps(gpu, environment, *plan);
}

Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, const PrefilterPlan& plan) {
    const auto prefilter = Prefilter::create(gpu.device());
    if (!prefilter) return core_failure(prefilter.error());
    return bind_maps(gpu, *prefilter, environment.source(), plan);
}

Outcome<MapsJob> bind_maps(Gpu& gpu, const Prefilter& prefilter, const GpuImage& source,
                           const PrefilterPlan& plan, const MapsJob* levels_of) {
    auto images = make_images(gpu, plan.maps());
    if (!images) return images.error();
    auto ladder = make_ladder_image(gpu, plan);
    if (!ladder) return ladder.error();
    auto scratch = levels_of ? levels_of->scratch : nullptr;
    if (!scratch) {
        auto made = gpu.create_buffer(plan.scratch_size(),
                                      VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                          VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
                                      Memory::device);
        if (!made) return made.error();
        scratch = std::make_shared<const GpuBuffer>(std::move(*made));
    }
    auto state =
        gpu.create_buffer(plan.state_size(),
                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                              VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          Memory::host);
    if (!state) return state.error();
    // A copy of its own: the other job's maps may be shown meanwhile.
    if (levels_of)
        std::memcpy(state->data(), levels_of->maps.state.data(), std::size_t(plan.state_size()));

    std::vector<CubeMap> lent;
    for (const GpuImage& image : *images) lent.push_back(lend_cube(image));
    auto job = prefilter.bind(plan, lend_cube(source), lent, scratch->handle(), state->handle(),
                              *ladder ? (*ladder)->handle() : VK_NULL_HANDLE);
    if (!job) return core_failure(job.error());
    PrefilteredMaps maps{{plan.maps().begin(), plan.maps().end()},
                         std::move(*images),
                         std::move(*ladder),
                         std::move(*state),
                         {}};
    return MapsJob{plan, std::move(scratch), std::move(*job), std::move(maps)};
}

Outcome<PrefilteredMaps> make_maps(Gpu& gpu, const GpuEnvironment& environment,
                                   const PrefilterPlan& plan, const Progress& progress) {
    auto bound = bind_maps(gpu, environment, plan);
    if (!bound) return bound.error();
    PrefilteredMaps& maps = bound->maps;
    const auto done = run(gpu, bound->plan, bound->job, progress, maps.report);
    if (!done) return done.error();
    maps.report.images = map_reports(plan);
    maps.report.suns = sun_count(maps);
    return std::move(maps);
}

std::uint32_t sun_count(const PrefilteredMaps& maps) {
    std::uint32_t suns = 0;
    std::memcpy(&suns, maps.state.data() + SUN_COUNT_OFFSET, sizeof suns);
    return suns;
}

double expected_error(const PrefilterSettings& settings, std::uint32_t source_size) {
    if (settings.method == PrefilterMethod::exact) return EXPECTED_EXACT_ERROR;
    if (settings.method != PrefilterMethod::chain) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const float exponent : settings.exponents)
        largest = std::max(largest, expected_map_error(settings.quality, exponent, source_size));
    return largest;
}

std::vector<ImageReport> map_reports(const PrefilterPlan& plan) {
    const auto report = [](const char* what, float exponent, std::uint32_t size,
                           std::uint32_t layers) -> ImageReport {
        constexpr std::uint64_t HALF_BYTES = 8; // of a texel
        return {what + number_text(exponent),
                size,
                size,
                layers,
                1,
                format_name(VK_FORMAT_R16G16B16A16_SFLOAT),
                HALF_BYTES * size * size * layers,
                "kept"};
    };
    std::vector<ImageReport> reports;
    for (const PrefilteredMap& map : plan.maps())
        reports.push_back(report("map n=", map.exponent, map.size, 6));
    if (plan.ladder().rungs)
        reports.push_back(report("ladder from n=", plan.ladder().lowest, plan.ladder_size(),
                                 6 * plan.ladder().rungs));
    return reports;
}

Outcome<ClippedTablesUpload> ClippedTablesUpload::create(Gpu& gpu) {
    auto tables = ClippedTables::create(gpu.device());
    if (!tables) return core_failure(tables.error());
    auto image =
        gpu.create_image({.format = ClippedTables::FORMAT,
                          .width = ClippedTables::WIDTH,
                          .height = ClippedTables::HEIGHT,
                          .layers = ClippedTables::LAYERS,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (!image) return image.error();
    auto buffer = gpu.create_buffer(
        ClippedTables::BUFFER_BYTES,
        VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::device);
    if (!buffer) return buffer.error();
    return ClippedTablesUpload{std::move(*tables), std::move(*image), std::move(*buffer)};
}

Outcome<GpuImage> make_clipped_tables(Gpu& gpu, PassReport& run) {
    auto upload = ClippedTablesUpload::create(gpu);
    if (!upload) return upload.error();
    const auto done =
        run_pass(gpu, run, [&](VkCommandBuffer commands) { upload->record(commands); });
    if (!done) return done.error();
    return std::move(upload->image);
}

} // namespace lobelia::host
