#include <cstring>

#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"
#include "support/shared.h"
#include "vk/compute_pass.h"

namespace lobelia {

#define SHARED inline
#include "lobelia/sphere.glsl"
#undef SHARED

// The shaders' functions, as the device runs them and as C++ does: one text, two compilers.
namespace test {
namespace {

constexpr std::uint32_t SPIRV[] = {
#include "shared_functions.comp.inc"
};
constexpr VkDescriptorType BINDINGS[] = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                         VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
constexpr std::size_t VALUES = 8; // for each argument

// A camera at (0, 0, 4) that looks at the origin, 30 degrees over 60 pixels.
SphereParams some_params() {
    const float pixel = 0.26794919f / 30.0f;
    SphereParams params{};
    params.direction = vec4(0, 0, -1, 0);
    params.direction_per_x = vec4(pixel, 0, 0, 0);
    params.direction_per_y = vec4(0, -pixel, 0, 0);
    params.moment = vec4(0, 0, 0, 0);
    params.moment_per_x = vec4(0, 4 * pixel, 0, 0);
    params.moment_per_y = vec4(4 * pixel, 0, 0, 0);
    params.centre = vec4(0, 0, -4, std::sqrt(15.0f));
    return params;
}

// As main() of shared_functions.comp.
std::array<vec4, VALUES> values_for(const SphereParams& sphere, vec4 x, uint i) {
    const uint face = i % CUBE_FACES;
    const vec3 direction = cube_direction(face, 2.0f * x.x - 1.0f, 2.0f * x.y - 1.0f);
    const CubePoint point = cube_point(direction);
    const PanoramaPoint place = panorama_point(direction);
    const ImageRay ray = image_ray(sphere, 80.0f * (x.x - 0.5f), 60.0f * (x.y - 0.5f));
    const SurfacePoint surface = surface_point(sphere, ray);
    return {vec4(chord_power(2.0f * x.x * x.x, x.w), phong_albedo(x.y, x.w),
                 lobe_density(phong(x.w), x.z), lobe_sample_chord(phong(x.w), x.x)),
            vec4(direction, float(point.face)),
            vec4(point.u, point.v, place.u, place.v),
            vec4(panorama_direction(x.x, x.y), 0.0f),
            vec4(cube_texel_solid_angle(i % 16u, i / 16u % 16u, 16u), sphere_coverage(sphere, ray),
                 surface.cos_view, 0.0f),
            vec4(surface.normal, 0.0f),
            vec4(surface.mirror, 0.0f),
            vec4(ray.direction, length(ray.moment))};
}

class SharedFunctionsTest : public GpuTest {
protected:
    std::vector<vec4> run(const SphereParams& sphere, const std::vector<vec4>& arguments) {
        const auto storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        const auto bytes = arguments.size() * sizeof(vec4);
        const host::GpuBuffer input =
            value_of(gpu.create_buffer(bytes, storage, host::Memory::host));
        const host::GpuBuffer output =
            value_of(gpu.create_buffer(VALUES * bytes, storage, host::Memory::host));
        std::memcpy(input.data(), arguments.data(), bytes);

        const vk::Context context = vk::load(gpu.device());
        const vk::ComputePass pass =
            vk::make_compute_pass(context, {.name = "shared functions",
                                            .spirv = SPIRV,
                                            .bindings = BINDINGS,
                                            .push_constant_size = sizeof sphere});
        const vk::DescriptorSets sets =
            vk::make_descriptor_sets(context, pass.interface, BINDINGS, 1);
        const vk::Resource resources[] = {vk::buffer_range(input.handle()),
                                          vk::buffer_range(output.handle())};
        vk::write_descriptor_set(context, sets.sets[0], BINDINGS, resources);
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            vk::begin_pass(context, commands, pass, sets.sets[0], sphere);
            context.call.vkCmdDispatch(commands, std::uint32_t(arguments.size() + 63) / 64, 1, 1);
            vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                               VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                               VK_ACCESS_HOST_READ_BIT);
        }));
        std::vector<vec4> values(VALUES * arguments.size());
        std::memcpy(values.data(), output.data(), VALUES * bytes);
        return values;
    }
};

TEST_F(SharedFunctionsTest, GiveTheSameOnTheDeviceAndInCpp) {
    // exp2, log2 and sqrt are the compilers' own, at most a few units in the last place apart. The
    // surface is compared by what a rounding of the ray's place does to it: next to the silhouette
    // the square root of a small difference.
    oracle::Random random(11);
    std::vector<vec4> arguments;
    for (int i = 0; i < 4096; ++i)
        arguments.push_back({float(random.unit()), float(random.unit()), float(random.unit()),
                             i % 64 == 0 ? 0.0f : float(std::exp(random.between(-4.0, 13.8)))});
    const SphereParams sphere = some_params();
    const std::vector<vec4> found = run(sphere, arguments);
    for (uint i = 0; i < arguments.size(); ++i) {
        const auto expected = values_for(sphere, arguments[i], i);
        for (std::size_t v = 0; v < VALUES; ++v)
            for (int c = 0; c < 4; ++c) {
                const float want = expected[v][c], got = found[VALUES * i + v][c];
                const bool surface = v == 5 || v == 6 || (v == 4 && c == 2);
                ASSERT_NEAR(got, want, (surface ? 2e-4f : 4e-6f) * std::max(std::abs(want), 1.0f))
                    << "argument " << i << ": " << arguments[i].x << " " << arguments[i].y << " "
                    << arguments[i].z << " " << arguments[i].w << " value " << v << "." << c;
            }
    }
}

} // namespace
} // namespace test
} // namespace lobelia
