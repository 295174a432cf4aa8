#include <algorithm>
#include <cstring>

#include <lobelia/host/work.h>

#include "host/averages.h"
#include "host/camera.h"
#include "host/checks.h"
#include "host/colour_target.h"
#include "host/maps.h"

namespace lobelia::host {

namespace {

constexpr std::size_t TEXEL_BYTES = 4 * sizeof(float);

bool is_black(const std::array<float, 3>& colour) {
    return colour == std::array<float, 3>{};
}

// Without a lobe there is nothing to integrate, and the two methods are the same.
SphereShading shading_for(const RenderSettings& settings) {
    const Material& material = settings.view.material;
    const bool diffuse = !is_black(material.diffuse), specular = !is_black(material.specular);
    return {.method = diffuse || specular ? settings.method : SphereMethod::split_sum,
            .diffuse = diffuse,
            .specular = specular,
            .background = settings.view.background};
}

/// The averages that the reference shows, one for each pixel.
struct ReferenceBuffers {
    std::optional<GpuBuffer> diffuse, specular;
};

Outcome<GpuBuffer> make_reference(Gpu& gpu, const Exact& exact, const ExactSource& source,
                                  const SphereView& view, const ExactSettings& settings,
                                  const std::vector<SpherePixel>& pixels, const Progress& progress,
                                  PassReport& run) {
    const VkDeviceSize bytes = TEXEL_BYTES * view.width * view.height;
    if (bytes > gpu.limits().maxStorageBufferRange)
        return Failure{"a reference of " + std::to_string(view.width) + "x" +
                       std::to_string(view.height) + " pixels takes " + std::to_string(bytes) +
                       " bytes in one buffer and the device allows " +
                       std::to_string(gpu.limits().maxStorageBufferRange) +
                       ", give a smaller size"};
    std::vector<ExactQuery> queries;
    queries.reserve(pixels.size());
    for (const SpherePixel& pixel : pixels) {
        const float* const axis = settings.clipped ? pixel.mirror : pixel.normal;
        const float* const normal = pixel.normal;
        queries.push_back(
            {.axis = {axis[0], axis[1], axis[2]}, .normal = {normal[0], normal[1], normal[2]}});
    }
    const std::string name = run.name;
    const auto averages = average(gpu, exact, source, settings, queries, progress);
    if (!averages) return averages.error();
    run = averages->report;
    run.name = name;

    auto buffer = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!buffer) return buffer.error();
    std::memset(buffer->data(), 0, bytes);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        std::memcpy(buffer->data() + TEXEL_BYTES * pixels[i].index, &averages->texels[4 * i],
                    TEXEL_BYTES);
    return buffer;
}

Outcome<ReferenceBuffers> make_references(Gpu& gpu, const GpuEnvironment& environment,
                                          const SphereView& view, const Progress& progress,
                                          WorkReport& report) {
    const auto exact = Exact::create(gpu.device());
    if (!exact) return core_failure(exact.error());
    const ExactSource source = exact_source(environment);
    const std::vector<SpherePixel> pixels = sphere_pixels(view);
    const Material& material = view.material;
    ReferenceBuffers buffers;
    if (!is_black(material.diffuse)) {
        PassReport run{.name = "diffuse reference"};
        auto buffer = make_reference(gpu, *exact, source, view, {.exponent = 1.0f}, pixels,
                                     share(progress, 0.0, 0.7), run);
        if (!buffer) return buffer.error();
        buffers.diffuse = std::move(*buffer);
        report.passes.push_back(run);
    }
    if (!is_black(material.specular)) {
        PassReport run{.name = "specular reference"};
        auto buffer = make_reference(gpu, *exact, source, view,
                                     {.exponent = material.exponent, .clipped = true}, pixels,
                                     share(progress, buffers.diffuse ? 0.7 : 0.0, 1.0), run);
        if (!buffer) return buffer.error();
        buffers.specular = std::move(*buffer);
        report.passes.push_back(run);
    }
    return buffers;
}

void add(WorkReport& report, const WorkReport& more) {
    report.passes.insert(report.passes.end(), more.passes.begin(), more.passes.end());
    report.images.insert(report.images.end(), more.images.begin(), more.images.end());
    if (more.suns) report.suns = more.suns;
}

/// Everything that the sphere pass reads, with what owns it.
struct Inputs {
    std::optional<PrefilteredMaps> maps;
    ReferenceBuffers references;
    SphereSources sources;
    std::uint64_t bytes = 0;
};

Outcome<Inputs> make_inputs(Gpu& gpu, const GpuEnvironment& environment,
                            const RenderSettings& settings, SphereShading& shading,
                            const Progress& progress, WorkReport& report) {
    const SphereView& view = settings.view;
    Inputs inputs;
    if (!shading.diffuse && !shading.specular) {
        // Nothing lights the sphere: it is black.
    } else if (shading.method == SphereMethod::reference) {
        auto made = make_references(gpu, environment, view, progress, report);
        if (!made) return made.error();
        inputs.references = std::move(*made);
    } else {
        const std::span<const float> exponents(&view.material.exponent, shading.specular ? 1 : 0);
        auto made =
            make_maps(gpu, environment, exponents, shading.diffuse, settings.quality, progress);
        if (!made) return made.error();
        add(report, made->report);
        inputs.maps = std::move(*made);
        shading.prefiltered = true;
        shading.specular_filter = inputs.maps->descriptions.front().filter;
    }

    // Of the maps, the specular one comes first and the diffuse one last.
    const GpuImage* const diffuse_map =
        inputs.maps && shading.diffuse ? &inputs.maps->images.back() : nullptr;
    const GpuImage* const specular_map =
        inputs.maps && shading.specular ? &inputs.maps->images.front() : nullptr;
    const auto& [diffuse, specular] = inputs.references;
    inputs.sources = {.background = environment.cube.view(),
                      .diffuse = diffuse_map ? diffuse_map->view() : VK_NULL_HANDLE,
                      .specular = specular_map ? specular_map->view() : VK_NULL_HANDLE,
                      .prefilter_state = inputs.maps ? inputs.maps->state.handle() : VK_NULL_HANDLE,
                      .reference_diffuse = diffuse ? diffuse->handle() : VK_NULL_HANDLE,
                      .reference_specular = specular ? specular->handle() : VK_NULL_HANDLE};
    inputs.bytes = (view.background ? image_bytes(environment.cube) : 0) +
                   (diffuse_map ? image_bytes(*diffuse_map) : 0) +
                   (specular_map ? image_bytes(*specular_map) : 0) +
                   (diffuse ? diffuse->size() : 0) + (specular ? specular->size() : 0);
    return inputs;
}

Outcome<Done> check(const Gpu& gpu, const RenderSettings& settings) {
    if (const auto refused = check_view(settings.view, gpu.limits())) return *refused;
    if (const auto refused = check_material(settings.view.material, true)) return *refused;
    return Done{};
}

} // namespace

Outcome<Rendering> render(Gpu& gpu, const GpuEnvironment& environment,
                          const RenderSettings& settings, const Progress& progress) {
    if (const auto valid = check(gpu, settings); !valid) return valid.error();
    const SphereView& view = settings.view;
    SphereShading shading = shading_for(settings);
    Rendering rendering;
    const auto inputs =
        make_inputs(gpu, environment, settings, shading, progress, rendering.report);
    if (!inputs) return inputs.error();

    const auto target = ColourTarget::create(gpu, view.width, view.height);
    if (!target) return target.error();
    const auto sphere =
        Sphere::create(gpu.device(), {.render_pass = target->render_pass()}, shading);
    if (!sphere) return core_failure(sphere.error());
    const auto job = sphere->bind(inputs->sources);
    if (!job) return core_failure(job.error());

    PassReport run{.name = "sphere",
                   .invocations = std::uint64_t(view.width) * view.height,
                   .bytes_read = inputs->bytes,
                   .bytes_written = image_bytes(target->image())};
    const auto drawn = run_pass(gpu, run, [&](VkCommandBuffer commands) {
        target->record(commands, [&](VkCommandBuffer inside) { job->record(inside, view); });
    });
    if (!drawn) return drawn.error();
    auto picture = gpu.download(target->image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    if (!picture) return picture.error();
    rendering.picture = std::move(*picture);
    rendering.report.passes.push_back(run);
    rendering.report.images.push_back(image_report("picture", target->image(), "kept"));
    return rendering;
}

} // namespace lobelia::host
