#include "support/core_jobs.h"

#include <array>
#include <stdexcept>
#include <vector>

#include <lobelia/clipped_tables.h>
#include <lobelia/cube_to_cube.h>
#include <lobelia/exact.h>
#include <lobelia/importance.h>
#include <lobelia/irradiance.h>
#include <lobelia/map_reader.h>
#include <lobelia/mips.h>
#include <lobelia/panorama.h>
#include <lobelia/plain_map.h>
#include <lobelia/prefilter.h>
#include <lobelia/sky.h>
#include <lobelia/sphere.h>

#include "support/fake_device.h"

namespace lobelia::test {
namespace {

template <class T>
T value_of(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().step);
    return *std::move(result);
}

const Device DEVICE = FakeDevice::lend();
const auto COMMANDS = FakeDevice::handle<VkCommandBuffer>();
constexpr VkFormat WHOLE = VK_FORMAT_R32G32B32A32_SFLOAT, HALF = VK_FORMAT_R16G16B16A16_SFLOAT;

VkBuffer buffer() {
    return FakeDevice::handle<VkBuffer>();
}
VkImageView view() {
    return FakeDevice::handle<VkImageView>();
}
CubeMap cube(std::uint32_t size, VkFormat format = WHOLE, std::uint32_t levels = 1) {
    return {FakeDevice::handle<VkImage>(), format, size, levels};
}

template <class Job>
std::function<void()> recording(Job job) {
    return [job = std::move(job)] { job.record(COMMANDS); };
}

std::function<void()> make_prefilter() {
    const std::array exponents = {0.5f, 16.0f, 2048.0f};
    const auto plan = value_of(PrefilterPlan::make({.exponents = exponents,
                                                    .lambert = true,
                                                    .ladder = {.lowest = 16, .rungs = 8},
                                                    .source_size = 256}));
    std::vector<CubeMap> maps;
    for (const PrefilteredMap& map : plan.maps()) maps.push_back(cube(map.size, HALF));
    const auto job = value_of(
        value_of(Prefilter::create(DEVICE))
            .bind(plan, cube(256), maps, buffer(), buffer(), FakeDevice::handle<VkImage>()));
    return [job, passes = plan.pass_count()] { job.record(COMMANDS, 0, passes); };
}

std::function<void()> make_exact() {
    const auto job = value_of(
        value_of(Exact::create(DEVICE))
            .bind(cube(64), {.exponent = 8, .query_count = 100}, buffer(), buffer(), buffer()));
    return [job] { job.record(COMMANDS, 0, job.steps()); };
}

std::function<void()> make_importance() {
    const auto job = value_of(
        value_of(Importance::create(DEVICE))
            .bind(cube(64, WHOLE, 7), {.exponent = 8, .query_count = 100}, buffer(), buffer()));
    return [job] { job.record(COMMANDS, 0, job.steps()); };
}

std::function<void()> make_sphere() {
    const auto job = value_of(
        value_of(Sphere::create(DEVICE, {.format = WHOLE}, {.method = SphereMethod::two_tap}))
            .bind({.background = view(),
                   .diffuse = view(),
                   .prefilter_state = buffer(),
                   .ladder = view(),
                   .clipped_tables = view()}));
    return [job] { job.record(COMMANDS, {.width = 64, .height = 64}); };
}

std::function<void()> make_tables() {
    const auto tables = value_of(ClippedTables::create(DEVICE));
    return [tables] { tables.record(COMMANDS, buffer(), FakeDevice::handle<VkImage>()); };
}

const CoreJob JOBS[] = {
    {"ClippedTables", make_tables, false},
    {"CubeToCube",
     [] {
         return recording(value_of(value_of(CubeToCube::create(DEVICE)).bind(cube(48), cube(64))));
     }},
    {"Exact", make_exact},
    {"Importance", make_importance},
    {"Irradiance",
     [] {
         return recording(
             value_of(value_of(Irradiance::create(DEVICE)).bind(cube(64), buffer(), buffer())));
     }},
    {"MapReader",
     [] {
         return recording(value_of(
             value_of(MapReader::create(DEVICE))
                 .bind({{16, 32, MapFilter::spline}, view(), buffer(), buffer(), buffer(), 100})));
     }},
    {"Mips",
     [] {
         return recording(
             value_of(value_of(Mips::create(DEVICE)).bind(cube(64), cube(64, WHOLE, 7))));
     }},
    {"PanoramaToCube",
     [] {
         return recording(
             value_of(value_of(PanoramaToCube::create(DEVICE))
                          .bind({FakeDevice::handle<VkImage>(), WHOLE, 256, 128}, cube(64))));
     }},
    {"PlainMap",
     [] {
         return recording(
             value_of(value_of(PlainMap::create(DEVICE))
                          .bind({{16, 32, MapFilter::bilinear}, view(), buffer(), cube(32)})));
     }},
    {"Prefilter", make_prefilter},
    {"Sky",
     [] {
         return recording(value_of(
             value_of(Sky::create(DEVICE)).bind({FakeDevice::handle<VkImage>(), view(), 64, 32})));
     }},
    {"Sphere", make_sphere},
};

} // namespace

std::span<const CoreJob> core_jobs() {
    return JOBS;
}

} // namespace lobelia::test
