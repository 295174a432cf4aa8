#include "host/environment_plan.h"

#include <algorithm>

#include "host/maps.h"
#include "host/sizes.h"

namespace lobelia::host {

namespace {

ImageReport float_image(const char* name, std::uint32_t width, std::uint32_t height,
                        std::uint32_t layers) {
    return {name,
            width,
            height,
            layers,
            1,
            "R32G32B32A32_SFLOAT",
            TEXEL_BYTES * width * height * layers,
            "kept"};
}

/// The pass that makes the cube map in a size that prefilters read, where it has another.
void add_resizing(EnvironmentPlan& plan) {
    const std::uint32_t face = prefilter_face(plan.face);
    if (face == plan.face) return;
    const std::uint64_t source = cube_texels(plan.face), resized = cube_texels(face);
    plan.report.passes.push_back({.name = "cube to cube",
                                  .invocations = resized,
                                  .bytes_read = TEXEL_BYTES * source,
                                  .bytes_written = TEXEL_BYTES * resized});
    plan.work.push_back(double(source + resized));
    plan.report.images.push_back(float_image("resized cube", face, face, FACES));
}

} // namespace

EnvironmentShape shape_of(const Image& environment) {
    const std::vector<float>& texels = environment.texels;
    bool constant = true;
    for (std::size_t i = 4; i < texels.size() && constant; i += 4)
        constant = std::equal(&texels[i], &texels[i] + 3, &texels[0]);
    return {.layout = environment.layout,
            .width = environment.width,
            .height = environment.height,
            .constant = constant};
}

EnvironmentShape builtin_shape() {
    return {.width = BUILTIN_WIDTH, .height = BUILTIN_WIDTH / 2, .builtin = true};
}

std::uint64_t source_bytes(const EnvironmentShape& shape) {
    return TEXEL_BYTES * shape.width * shape.height * (shape.layout == Layout::cube ? FACES : 1);
}

EnvironmentPlan plan_environment(const EnvironmentShape& shape, std::uint32_t face,
                                 Quality quality) {
    if (shape.layout == Layout::cube) {
        EnvironmentPlan plan{
            shape.width,
            {.images = {float_image("environment cube", shape.width, shape.width, FACES)}},
            {}};
        add_resizing(plan);
        return plan;
    }
    EnvironmentPlan plan{face ? face : default_face(shape.width, quality), {}, {}};
    const std::uint64_t panorama = std::uint64_t(shape.width) * shape.height;
    const std::uint64_t cube = cube_texels(plan.face);
    if (shape.builtin) {
        plan.report.passes.push_back(
            {.name = "sky", .invocations = panorama, .bytes_written = TEXEL_BYTES * panorama});
        plan.work.push_back(double(panorama));
    }
    plan.report.passes.push_back({.name = "panorama to cube",
                                  .invocations = cube,
                                  .bytes_read = TEXEL_BYTES * panorama,
                                  .bytes_written = TEXEL_BYTES * cube});
    plan.work.push_back(double(panorama + cube));
    plan.report.images = {float_image("panorama", shape.width, shape.height, 1),
                          float_image("environment cube", plan.face, plan.face, FACES)};
    add_resizing(plan);
    return plan;
}

} // namespace lobelia::host
