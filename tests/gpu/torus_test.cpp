#include <cmath>
#include <cstdlib>
#include <cstring>

#include <lobelia/clipped_tables.h>
#include <lobelia/host/write.h>

#include "host/maps.h"
#include "sphere_fixture.h"
#include "support/parallel.h"
#include "vk/compute_pass.h"

// shade() of lobelia/taps.glsl in an engine's own shader: examples/torus.comp. To look at it, run
// this program with LOBELIA_TORUS_PNG=<file>.
namespace lobelia::test {
namespace {

constexpr std::uint32_t SPIRV[] = {
#include "torus.comp.inc"
};
constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
constexpr std::uint32_t WIDTH = 96, HEIGHT = 64;
constexpr std::size_t PIXELS = WIDTH * HEIGHT;

// As in the shader.
struct Surface {
    alignas(16) std::array<float, 3> normal;
    float exponent;
    alignas(16) std::array<float, 3> view;
    alignas(16) std::array<float, 3> diffuse;
    alignas(16) std::array<float, 3> specular;

    double cosine() const { return std::max(dot(doubles(normal), doubles(view)), 0.0); }
};

struct Torus {
    host::Image picture;
    std::vector<Surface> surfaces;
    std::vector<std::size_t> hits; // pixels that show it
};

class TorusTest : public SphereTest {
protected:
    host::GpuBuffer storage(VkDeviceSize bytes) {
        return value_of(
            gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::host));
    }

    Torus draw_torus(const host::GpuEnvironment& environment) {
        const PrefilterPlan plan =
            value_of(PrefilterPlan::make({.lambert = true,
                                          .ladder = ladder_for(Taps::two, 8.0f, 512.0f),
                                          .source_size = environment.cube.description().width}));
        const host::PrefilteredMaps maps = value_of(host::make_maps(gpu, environment, plan, {}));
        host::PassReport upload;
        const host::GpuImage tables = value_of(host::make_clipped_tables(gpu, upload));
        const host::GpuBuffer picture = storage(PIXELS * sizeof(float[4]));
        const host::GpuBuffer surfaces = storage(PIXELS * sizeof(Surface));

        const vk::Context context = vk::load(gpu.device());
        const std::array<std::uint32_t, 2> size{WIDTH, HEIGHT};
        const vk::ComputePass pass =
            vk::make_compute_pass(context, {.name = "torus",
                                            .spirv = SPIRV,
                                            .bindings = BINDINGS,
                                            .push_constant_size = sizeof size});
        const vk::Sampler linear = vk::make_sampler(context, VK_FILTER_LINEAR);
        const vk::DescriptorSets sets =
            vk::make_descriptor_sets(context, pass.interface, BINDINGS, 1);
        const vk::Resource resources[] = {vk::sampled_image(maps.images[0].view(), linear.get()),
                                          vk::sampled_image(maps.ladder->view(), linear.get()),
                                          vk::sampled_image(tables.view(), linear.get()),
                                          vk::buffer_range(maps.state.handle()),
                                          vk::buffer_range(picture.handle()),
                                          vk::buffer_range(surfaces.handle())};
        vk::write_descriptor_set(context, sets.sets[0], BINDINGS, resources);
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            vk::begin_pass(context, commands, pass, sets.sets[0], size);
            context.call.vkCmdDispatch(commands, WIDTH / 8, HEIGHT / 8, 1);
            vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                               VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                               VK_ACCESS_HOST_READ_BIT);
        }));
        return read_back(picture, surfaces);
    }

private:
    static Torus read_back(const host::GpuBuffer& picture, const host::GpuBuffer& surfaces) {
        Torus torus{{host::Layout::latlong, WIDTH, HEIGHT, 1, std::vector<float>(4 * PIXELS)},
                    std::vector<Surface>(PIXELS),
                    {}};
        std::memcpy(torus.picture.texels.data(), picture.data(), picture.size());
        std::memcpy(torus.surfaces.data(), surfaces.data(), surfaces.size());
        for (std::size_t i = 0; i < PIXELS; ++i)
            if (torus.surfaces[i].exponent > 0.0f) torus.hits.push_back(i);
        return torus;
    }
};

TEST_F(TorusTest, IsLitByTheBuiltInSky) {
    const Torus torus = draw_torus(value_of(host::make_builtin_environment(gpu, 128)));
    if (const char* const path = std::getenv("LOBELIA_TORUS_PNG"))
        value_of(host::write_png(path, torus.picture, 0.0f));
    EXPECT_GT(torus.hits.size(), PIXELS / 5);
    EXPECT_LT(torus.hits.size(), PIXELS / 2);
    for (std::size_t i = 0; i < 4 * PIXELS; ++i) {
        const float shown = torus.picture.texels[i];
        const bool hit = torus.surfaces[i / 4].exponent > 0.0f;
        ASSERT_TRUE(std::isfinite(shown) && (hit ? shown > 0.0f : shown == float(i % 4 == 3)))
            << "pixel " << i / 4 << " channel " << i % 4 << " value " << shown;
    }
}

TEST_F(TorusTest, GivesBackConstantLightByItsAlbedo) {
    // Averages of ones are ones, in halves too. The albedo is good to 1e-6, and the cosine that the
    // device takes to 3e-7, the albedo's slope being at most 1; the rest is rounding.
    const Torus torus = draw_torus(upload(even_panorama(64, 32, 1, 1, 1)));
    double least = 1e6, most = 0;
    for (const std::size_t i : torus.hits) {
        const Surface& surface = torus.surfaces[i];
        const double exponent = double(surface.exponent);
        const double albedo = oracle::albedo(surface.cosine(), exponent);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(double(torus.picture.texels[4 * i + c]),
                        double(surface.diffuse[c]) + double(surface.specular[c]) * albedo, 5e-6)
                << "pixel " << i << " n " << exponent << " cosine " << surface.cosine();
        least = std::min(least, exponent);
        most = std::max(most, exponent);
    }
    EXPECT_LT(least, 10.0);
    EXPECT_GT(most, 400.0);
}

TEST_F(TorusTest, IsTheTruthInSmoothLight) {
    // Light of degree 4 at most. Mixing two rungs, of variances v and v / sqrt(2), is off by
    // (0.29 v l (l + 1) / 2)^2 / 8 of degree l: 2e-2 of degree 4 at v = 1 / 8, and less than half
    // of that with the lobe's own decay. The pair of taps has the lobe's mean and its variances but
    // nothing of its skewness, sigma^3 = 0.04 of the light's third derivative over 6 at n = 8. With
    // halves (5e-4) and the maps' own error (1e-3) that makes 2e-2 of the light shown.
    const oracle::Source light = oracle::random_cube(oracle::Scene::smooth, 64, 3);
    const Torus torus = draw_torus(upload(image_of(light)));
    constexpr std::size_t COUNT = 12;
    std::array<oracle::Rgb, COUNT> expected;
    const auto pixel = [&](std::size_t k) {
        return torus.hits[(2 * k + 1) * torus.hits.size() / (2 * COUNT)];
    };
    oracle::parallel_for(COUNT, [&](std::size_t k) {
        const auto& [normal, exponent, view, kd, ks] = torus.surfaces[pixel(k)];
        expected[k] = oracle::shade(light, doubles(normal), doubles(view),
                                    {{kd[0], kd[1], kd[2]}, {ks[0], ks[1], ks[2]}, exponent});
    });
    for (std::size_t k = 0; k < COUNT; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(double(torus.picture.texels[4 * pixel(k) + c]) / expected[k][c], 1.0, 2e-2)
                << "n " << torus.surfaces[pixel(k)].exponent << " cosine "
                << torus.surfaces[pixel(k)].cosine() << " channel " << c;
}

} // namespace
} // namespace lobelia::test
