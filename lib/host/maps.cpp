#include "host/maps.h"

#include "host/averages.h"
#include "host/lobe_map.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LAMBERT_FACE = 32;

Outcome<GpuImage> make_map(Gpu& gpu, const Image& cube, float exponent, std::uint32_t face,
                           const std::string& name, WorkReport& report) {
    PassReport run{.name = name, .invocations = std::uint64_t(6) * face * face};
    const double start = process_milliseconds();
    const Image image = lobe_map(cube, exponent, face);
    run.cpu_ms = process_milliseconds() - start;
    auto map =
        gpu.create_image({.width = face,
                          .height = face,
                          .layers = 6,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          .cube = true});
    if (!map) return map.error();
    if (const auto done = gpu.upload(image, *map); !done) return done.error();
    run.bytes_read = cube.texels.size() * sizeof(float);
    run.bytes_written = image_bytes(*map);
    report.passes.push_back(run);
    report.images.push_back(image_report(name, *map, "kept"));
    return map;
}

} // namespace

Outcome<SphereMaps> make_sphere_maps(Gpu& gpu, const GpuEnvironment& environment,
                                     const Material& material, const Progress& progress,
                                     WorkReport& report) {
    const bool diffuse = material.diffuse != std::array<float, 3>{};
    const bool specular = material.specular != std::array<float, 3>{};
    SphereMaps maps;
    if (!diffuse && !specular) return maps;

    const auto cube = gpu.download(environment.cube, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    if (!cube) return cube.error();
    if (diffuse) {
        auto map = make_map(gpu, *cube, 1.0f, LAMBERT_FACE, "diffuse map", report);
        if (!map) return map.error();
        maps.diffuse = std::move(*map);
    }
    if (progress && !progress(0.5)) return Failure{"cancelled"};
    if (specular) {
        const std::uint32_t face = lobe_face(material.exponent, cube->width);
        auto map = make_map(gpu, *cube, material.exponent, face, "specular map", report);
        if (!map) return map.error();
        maps.specular = std::move(*map);
    }
    return maps;
}

} // namespace lobelia::host
