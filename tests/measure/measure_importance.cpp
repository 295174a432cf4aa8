// Error of the usual methods, importance sampling and filtered importance sampling:
// measure_importance.
//
// Error: pointwise relative, |x - exact| / (|exact| + 1e-3 mean), over random directions and R G B,
// exact from Exact over the panorama's own texels; the mean over the panoramas.

#include <cstdio>

#include <lobelia/exact.h>
#include <lobelia/panorama.h>

#include "support/error_measures.h"
#include "support/real_panoramas.h"
#include "support/sampled.h"

namespace lobelia::test {
namespace {

constexpr std::uint32_t FACE = 256;
constexpr float EXPONENTS[] = {1, 4.8f, 16, 64, 256, 1024, 4096};

struct Rung {
    bool filtered;
    std::uint32_t samples;
};
constexpr Rung RUNGS[] = {{false, 64}, {false, 256}, {false, 1024}, {true, 8},
                          {true, 32},  {true, 64},   {true, 256},   {true, 1024}};

using Averages = std::vector<std::array<float, 4>>;

host::GpuImage cube_map(host::Gpu& gpu, const host::GpuImage& panorama) {
    host::GpuImage cube =
        value_of(gpu.create_image({.width = FACE,
                                   .height = FACE,
                                   .layers = 6,
                                   .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                   .cube = true}));
    const auto resample = value_of(PanoramaToCube::create(gpu.device()));
    const auto job = value_of(resample.bind(panorama_of(panorama), cube_of(cube)));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return cube;
}

Averages truth(host::Gpu& gpu, const Exact& exact, const host::GpuImage& panorama, float exponent,
               const std::vector<oracle::Direction>& axes) {
    const ExactSettings settings{.exponent = exponent, .query_count = std::uint32_t(axes.size())};
    const auto sizes = value_of(Exact::sizes(panorama_of(panorama), settings));
    const auto buffer = [&](VkDeviceSize bytes) {
        return value_of(gpu.create_buffer(
            bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
            host::Memory::host));
    };
    const host::GpuBuffer queries = buffer(sizes.queries), results = buffer(sizes.results),
                          tables = buffer(sizes.tables);
    auto* query = reinterpret_cast<ExactQuery*>(queries.data());
    for (const oracle::Direction& d : axes)
        *query++ = {.axis = {float(d.x), float(d.y), float(d.z)}};
    const auto job = value_of(exact.bind(panorama_of(panorama), settings, queries.handle(),
                                         results.handle(), tables.handle()));
    for (std::uint32_t step = 0; step < job.steps(); ++step)
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, step, 1); }));
    Averages averages(axes.size());
    std::memcpy(averages.data(), results.data(), sizes.results);
    return averages;
}

std::vector<double> colours(const Averages& averages) {
    std::vector<double> values;
    for (const auto& average : averages)
        values.insert(values.end(), average.begin(), average.begin() + 3);
    return values;
}

void measure(host::Gpu& gpu) {
    const auto axes = oracle::test_directions(400, 7);
    const auto exact = value_of(Exact::create(gpu.device()));
    double error[std::size(RUNGS)][std::size(EXPONENTS)] = {};
    for (const std::string& name : REAL_PANORAMAS) {
        const host::GpuImage panorama = on_device(gpu, real_panorama(name));
        const host::GpuImage source = mips_of(gpu, cube_map(gpu, panorama));
        for (std::size_t i = 0; i < std::size(EXPONENTS); ++i) {
            const auto expected = colours(truth(gpu, exact, panorama, EXPONENTS[i], axes));
            for (std::size_t k = 0; k < std::size(RUNGS); ++k) {
                const auto [filtered, samples] = RUNGS[k];
                const auto found = sampled(
                    gpu, source,
                    {.exponent = EXPONENTS[i], .samples = samples, .filtered = filtered}, axes);
                error[k][i] += oracle::measure_error(colours(found), expected).pointwise_rms;
            }
        }
    }
    std::printf("| method |");
    for (const float exponent : EXPONENTS) std::printf(" n = %g |", double(exponent));
    std::printf("\n");
    for (std::size_t k = 0; k < std::size(RUNGS); ++k) {
        std::printf("| %s, %u |", RUNGS[k].filtered ? "filtered" : "plain", RUNGS[k].samples);
        for (const double sum : error[k])
            std::printf(" %.2g |", sum / double(REAL_PANORAMAS.size()));
        std::printf("\n");
    }
}

} // namespace
} // namespace lobelia::test

int main() {
    auto gpu = lobelia::test::value_of(lobelia::host::Gpu::create());
    std::printf("%s, source faces of %u texels\n", gpu.description().name.c_str(),
                lobelia::test::FACE);
    lobelia::test::measure(gpu);
}
