#include "host/reference.h"

#include <cstring>

#include "host/averages.h"
#include "host/camera.h"
#include "host/checks.h"
#include "host/sizes.h"

namespace lobelia::host {

namespace {

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

} // namespace

Outcome<ReferenceBuffers> make_references(Gpu& gpu, const GpuEnvironment& environment,
                                          const SphereView& view, const Progress& progress) {
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
        buffers.report.passes.push_back(run);
    }
    if (!is_black(material.specular)) {
        PassReport run{.name = "specular reference"};
        auto buffer = make_reference(gpu, *exact, source, view,
                                     {.exponent = material.exponent, .clipped = true}, pixels,
                                     share(progress, buffers.diffuse ? 0.7 : 0.0, 1.0), run);
        if (!buffer) return buffer.error();
        buffers.specular = std::move(*buffer);
        buffers.report.passes.push_back(run);
    }
    return buffers;
}

} // namespace lobelia::host
