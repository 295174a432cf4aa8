// How much each approximation on the way from a panorama to a pixel is off by, the others left out:
// measure_approximations [PANORAMA...]. Pointwise relative RMS over directions and R G B, mean over
// the panoramas; integrals by Exact.
//     cube       P_n of the cube map of 256 texels for that of the panorama
//     chain      the maps of quality normal, in floats, for P_n of the cube map: levels, cut
//                kernels, the map's texels and how they are read
//     halves     the same maps in halves for those in floats
//     ladder     the mean of P at two exponents a factor of sqrt(2) apart, mixed as variances, for
//                P at the one between them
//     one, two   P at the places and exponents of one and two taps, for the lobe that the horizon
//                cuts; places on the sphere as pixels see them
// Suns are no part of ladders and taps: there texels are cut at 64 times the mean.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "clipped_lobe.h"
#include "prefilter_maps.h"
#include "support/error_measures.h"
#include "support/exact_averages.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

constexpr int DIRECTIONS = 150;
constexpr std::uint32_t FACE = 256;
const std::vector<float> EXPONENTS = {1, 4.8f, 16, 64, 256, 1024, 4096};
constexpr const char* NAMES[] = {"cube", "chain", "halves", "ladder", "one", "two"};
using Values = std::vector<double>;
using Row = std::array<double, std::size(NAMES)>;

class Integrals {
public:
    explicit Integrals(host::Gpu& gpu) : gpu_(gpu) {}

    Values of(const host::GpuImage& source, double exponent, const std::vector<ExactQuery>& queries,
              bool clipped = false) const {
        Values values;
        for (const Average& average :
             ask(gpu_, exact_, source, {.exponent = float(exponent), .clipped = clipped}, queries)
                 .averages)
            values.insert(values.end(), average.begin(), average.begin() + 3);
        return values;
    }

private:
    host::Gpu& gpu_;
    Exact exact_ = value_of(Exact::create(gpu_.device()));
};

double rms(const Values& values, const Values& exact) {
    return oracle::measure_error(values, exact).pointwise_rms;
}

/// A mirror direction R and a normal N on the half sphere that is seen, pixels counting alike.
struct Place {
    oracle::Direction mirror, normal;
    double cosine;
};
std::vector<Place> places(const Directions& mirrors) {
    std::vector<Place> all;
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        const oracle::Direction r = mirrors[i], other = mirrors[(i + 50) % mirrors.size()];
        const double cosine = std::sqrt((double(i) + 0.5) / double(mirrors.size()));
        const oracle::Direction side = normalised(cross(r, other));
        all.push_back({r, cosine * r + std::sqrt(1 - cosine * cosine) * side, cosine});
    }
    return all;
}

/// By one or two lobes on the axis that is `shift` from R towards N, `angle` to either side.
Values by_taps(const Integrals& integrals, const host::GpuImage& source,
               const std::vector<Place>& places, double exponent, bool two) {
    Values values;
    for (const auto& [mirror, normal, cosine] : places) {
        const MatchedTaps taps = matched_taps(cosine, exponent);
        const oracle::Direction across = normalised(cross(normal, mirror));
        const oracle::Direction towards = cross(mirror, across); // from R to N, square to R
        const oracle::Direction axis =
            std::cos(taps.shift) * mirror + std::sin(taps.shift) * towards;
        const double angle = two ? taps.two_tap_angle : 0.0;
        const Values pair =
            integrals.of(source, two ? taps.two_tap_exponent : taps.one_tap_exponent,
                         unclipped({std::cos(angle) * axis + std::sin(angle) * across,
                                    std::cos(angle) * axis - std::sin(angle) * across}));
        for (std::size_t c = 0; c < 3; ++c) values.push_back(0.5 * (pair[c] + pair[c + 3]));
    }
    return values;
}

host::Image without_suns(host::Image image) {
    const oracle::Rgb mean = source_of(image).mean();
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % 4 < 3) image.texels[i] = std::min(image.texels[i], float(64 * mean[i % 4]));
    return image;
}

Row measure(host::Gpu& gpu, const Integrals& integrals, const Environment& environment,
            const host::GpuImage& even, std::size_t index) {
    const float exponent = EXPONENTS[index];
    const Directions directions = oracle::test_directions(DIRECTIONS, 7);
    const std::vector<ExactQuery> queries = unclipped(directions);
    const Values truth = integrals.of(environment.panorama, exponent, queries);
    const Values of_cube = integrals.of(environment.cube, exponent, queries);

    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    const auto reader = value_of(MapReader::create(gpu.device()));
    const auto by_chain = [&](VkFormat format) {
        const Maps maps = bind_maps(gpu, prefilter, environment.cube, {&exponent, 1}, false,
                                    Quality::normal, format);
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            maps.job.record(commands, 0, maps.plan.pass_count());
        }));
        return read(gpu, reader, maps, 0, directions);
    };
    const Values floats = by_chain(VK_FORMAT_R32G32B32A32_SFLOAT);
    const Values halves = by_chain(VK_FORMAT_R16G16B16A16_SFLOAT);

    // The middle of two rungs in 1 / n, where mixing is worst.
    const double low = exponent * 0.5 * (1 + std::sqrt(0.5)), high = low * std::sqrt(2.0);
    Values mixed = integrals.of(even, low, queries);
    const Values sharper = integrals.of(even, high, queries);
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = 0.5 * (mixed[i] + sharper[i]);

    const std::vector<Place> seen = places(directions);
    std::vector<ExactQuery> horizons;
    for (const Place& place : seen) horizons.push_back(query(place.mirror, place.normal));
    const Values cut = integrals.of(even, exponent, horizons, true);
    return {rms(of_cube, truth),
            rms(floats, of_cube),
            rms(halves, floats),
            rms(mixed, integrals.of(even, exponent, queries)),
            rms(by_taps(integrals, even, seen, exponent, false), cut),
            rms(by_taps(integrals, even, seen, exponent, true), cut)};
}

void measure_all(const std::vector<std::string>& panoramas) {
    auto gpu = value_of(host::Gpu::create());
    const Integrals integrals(gpu);
    std::vector<Row> rows(EXPONENTS.size());
    for (const std::string& name : panoramas) {
        const host::Image image = real_panorama(name);
        const Environment environment = load(gpu, image, FACE);
        const Environment even = load(gpu, without_suns(image), FACE);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row row = measure(gpu, integrals, environment, even.panorama, i);
            for (std::size_t k = 0; k < row.size(); ++k)
                rows[i][k] += row[k] / double(panoramas.size());
        }
    }
    std::printf("| n |");
    for (const char* name : NAMES) std::printf(" %s |", name);
    std::printf("\n| --- |");
    for (std::size_t k = 0; k < std::size(NAMES); ++k) std::printf(" --- |");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::printf("\n| %g |", double(EXPONENTS[i]));
        for (const double error : rows[i]) std::printf(" %.1e |", error);
    }
    std::printf("\n");
}

} // namespace
} // namespace lobelia::test

int main(int count, char** arguments) {
    using lobelia::test::REAL_PANORAMAS;
    lobelia::test::measure_all(
        count > 1 ? std::vector<std::string>(arguments + 1, arguments + count) : REAL_PANORAMAS);
}
