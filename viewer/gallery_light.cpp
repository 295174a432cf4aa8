#include "gallery_light.h"

#include <cmath>
#include <filesystem>

#include "environment.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr const char* FOLDER = "/usr/share/blender/datafiles/studiolights/world/";
// A wood, a street and a hall, for the Eucalyptus Grove, the Uffizi Gallery and St. Peter's.
constexpr const char* PHOTOGRAPHS[] = {"forest", "courtyard", "interior"};
constexpr double MIDDLE_GREY = 0.2;

Outcome<host::Image> cube_of(host::Gpu& gpu, const host::GpuEnvironment& environment) {
    auto cube = gpu.download(environment.cube, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    if (!cube) return cube.error();
    cube->layout = host::Layout::cube;
    return cube;
}

/// Few texels are much brighter than all others: the mean of logarithms does not see them.
float exposure_for(const host::Image& cube) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cube.texels.size(); i += 4)
        sum += std::log2(double(cube.texels[i + 1]) + 1e-4);
    return float(std::log2(MIDDLE_GREY) - sum / (double(cube.texels.size()) / 4));
}

Outcome<GalleryLight> make_light(host::Gpu& gpu, const std::string& name,
                                 const std::optional<host::Environment>& file,
                                 ProgressLine& progress) {
    Outcome<host::Image> cubes[2] = {host::Image{}, host::Image{}};
    for (int i = 0; i < 2; ++i) {
        const auto environment =
            upload_source(gpu, file, i == 0 ? 0 : GALLERY_FACE, Quality::normal, progress);
        if (!environment) return environment.error();
        cubes[i] = cube_of(gpu, *environment);
        if (!cubes[i]) return cubes[i].error();
    }
    auto light = host::upload_environment(gpu, *cubes[1]);
    if (!light) return light.error();
    const float exposure = exposure_for(*cubes[1]);
    return GalleryLight{name, std::move(*cubes[0]), std::move(*cubes[1]), std::move(*light),
                        exposure};
}

} // namespace

Outcome<std::vector<GalleryLight>> gallery_lights(host::Gpu& gpu, ProgressLine& progress) {
    std::vector<GalleryLight> lights;
    for (const std::string name : PHOTOGRAPHS) {
        const std::string path = FOLDER + name + ".exr";
        if (!std::filesystem::exists(path)) continue;
        const auto file = host::read_environment(path);
        if (!file) return file.error();
        auto light = make_light(gpu, name, *file, progress);
        if (!light) return light.error();
        lights.push_back(std::move(*light));
    }
    if (lights.empty()) {
        auto light = make_light(gpu, "built-in", std::nullopt, progress);
        if (!light) return light.error();
        lights.push_back(std::move(*light));
    }
    return lights;
}

} // namespace lobelia::cli
