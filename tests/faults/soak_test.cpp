#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include <lobelia/host/work.h>

#include "library_new.h"
#include "support/environments.h"
#include "support/gpu_sources.h"
#include "vulkan_shim.h"

// Devices opened, worked with and closed again and again, in light that changes: what is alive
// afterwards, of Vulkan's objects and of the heap, is what was alive once every way had been gone,
// to the block. LOBELIA_SOAK_SECONDS says how long, 30 where it does not.
namespace lobelia::test {
namespace {

constexpr std::uint64_t ROUNDS = 54; // on one device: each method, quality and layout together
constexpr int WARM = 2; // devices until all that is kept is there, the shim's own books among it

struct Alive {
    std::size_t objects;
    std::ptrdiff_t blocks;
    bool operator==(const Alive&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Alive& alive) {
    return out << alive.objects << " objects of Vulkan, " << alive.blocks << " blocks";
}

Alive alive() {
    return {VulkanShim::get().census.alive(), LibraryNew::live()};
}

std::chrono::steady_clock::time_point end_of_soak() {
    const char* const asked = std::getenv("LOBELIA_SOAK_SECONDS");
    return std::chrono::steady_clock::now() + std::chrono::seconds(asked ? std::atoi(asked) : 30);
}

/// Another light, another size, another quality, another method each time.
void work(host::Gpu& gpu, std::uint64_t round) {
    const auto scene = oracle::ALL_SCENES[round % std::size(oracle::ALL_SCENES)];
    const int size = 16 << (round % 3);
    const host::Image light = image_of(
        round % 2 ? oracle::random_cube(scene, size, round)
                  : oracle::random_panorama(scene, 4 * size + int(round % 7), 2 * size, round));
    const auto quality = Quality(round / 9 % 3);
    const auto environment = value_of(host::upload_environment(gpu, light, 0, quality));
    const auto methods = host::render_methods();
    const auto method = methods[round % methods.size()].method;
    const float exponent = float(round % 11) * float(round % 13);
    const host::RenderSettings settings{.view = {.material = {.diffuse = {0.2f, 0.3f, 0.4f},
                                                              .specular = {0.5f, 0.4f, 0.3f},
                                                              .exponent = exponent},
                                                 .width = 4,
                                                 .height = 3},
                                        .method = method,
                                        .quality = quality,
                                        .samples = 4,
                                        .background_exponent = 1 + exponent};
    value_of(host::render(gpu, environment, settings));
    value_of(host::prefilter(gpu, environment,
                             {.quality = quality, .exponents = {exponent, 300}, .width = 4}));
}

TEST(Soak, WouldSeeABlockThatStays) {
    LibraryNew::begin();
    const Alive before = alive();
    auto block = std::make_unique<int>(1);
    EXPECT_EQ(alive().blocks, before.blocks + 1);
    block.reset();
    EXPECT_EQ(alive(), before);
}

TEST(Soak, LeavesNothingBehind) {
    VulkanShim::get().pipelines.on = true; // compiled once a device
    LibraryNew::begin();
    const auto end = end_of_soak();
    std::optional<Alive> open, closed; // once it is warm
    int devices = 0;
    std::uint64_t round = 0;
    for (; devices <= WARM || std::chrono::steady_clock::now() < end; ++devices) {
        {
            host::Gpu gpu =
                value_of(host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()}));
            for (std::uint64_t i = 0; i < ROUNDS; ++i) {
                work(gpu, round++);
                ASSERT_EQ(alive(), open.value_or(alive())) << "round " << round;
            }
            if (devices + 1 == WARM) open = alive();
        }
        ASSERT_EQ(alive(), closed.value_or(alive())) << "round " << round;
        ASSERT_EQ(alive().objects, 0u) << VulkanShim::get().census.text();
        if (devices + 1 == WARM) closed = alive();
    }
    std::printf("%llu rounds on %d devices\n", static_cast<unsigned long long>(round), devices);
}

} // namespace
} // namespace lobelia::test
