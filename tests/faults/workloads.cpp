#include "workloads.h"

#include <lobelia/host/work.h>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

namespace {

using Texels = host::Outcome<std::vector<float>>;

Texels texels_of(host::Outcome<host::Rendering> rendering) {
    if (!rendering) return rendering.error();
    return std::move(rendering->picture.texels);
}

Texels texels_of(host::Outcome<host::Prefiltering> filtered) {
    if (!filtered) return filtered.error();
    std::vector<float> texels;
    for (const host::Image& map : filtered->maps)
        texels.insert(texels.end(), map.texels.begin(), map.texels.end());
    return texels;
}

const host::Image& light() {
    static const host::Image image = image_of(oracle::random_cube(oracle::Scene::suns, 16, 5));
    return image;
}

Workload upload() {
    return {"upload", [](host::Gpu& gpu) -> Texels {
                const auto made =
                    host::upload_environment(gpu, even_panorama(32, 16, 1.0f, 2.0f, 3.0f));
                if (!made) return made.error();
                auto cube = gpu.download(made->cube, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
                if (!cube) return cube.error();
                return std::move(cube->texels);
            }};
}

Workload sky() {
    return {"sky", [](host::Gpu& gpu) -> Texels {
                const auto made = host::make_builtin_environment(gpu, 1);
                if (!made) return made.error();
                auto cube = gpu.download(made->cube, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
                if (!cube) return cube.error();
                return std::move(cube->texels);
            }};
}

Workload rendering(SphereMethod method, float exponent = 300.0f, float specular = 0.6f) {
    return {"render", [=](host::Gpu& gpu) -> Texels {
                const auto environment = host::upload_environment(gpu, light());
                if (!environment) return environment.error();
                const SphereView view{
                    .material = {{0.3f, 0.3f, 0.3f}, {specular, specular, specular}, exponent},
                    .width = 1,
                    .height = 1};
                return texels_of(host::render(gpu, *environment,
                                              {.view = view, .method = method, .samples = 4}));
            }};
}

Workload filtering(host::PrefilterMethod method) {
    return {"prefilter", [method](host::Gpu& gpu) -> Texels {
                const auto environment = host::upload_environment(gpu, light());
                if (!environment) return environment.error();
                return texels_of(host::prefilter(
                    gpu, *environment,
                    {.method = method, .samples = 4, .exponents = {300.0f}, .width = 1}));
            }};
}

} // namespace

const std::vector<WorkloadGroup>& workload_groups() {
    using enum SphereMethod;
    static const std::vector<WorkloadGroup> all{
        {"Environments", {upload(), sky()}},
        {"Samples",
         {filtering(host::PrefilterMethod::importance),
          filtering(host::PrefilterMethod::filtered_importance), rendering(kurt2019),
          rendering(importance)}},
        {"Maps",
         {filtering(host::PrefilterMethod::chain), rendering(sh4), rendering(two_tap, 1e4f)}},
        {"Truth", {filtering(host::PrefilterMethod::exact), rendering(reference, 1.0f, 0.0f)}},
    };
    return all;
}

} // namespace lobelia::test
