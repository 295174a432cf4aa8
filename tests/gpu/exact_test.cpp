#include "exact_fixture.h"

#include <functional>

#include "support/error_measures.h"
#include "support/oracle.h"
#include "support/real_panoramas.h"
#include "support/some_of.h"

// The exact integration against an integration in double precision that shares no text with it.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Scene;
using oracle::Source;

constexpr float EXPONENTS[] = {0,     1e-3f, 0.5f, 1,    2,    3,    4,   4.8f,
                               16.0f, 64,    256,  1e3f, 1e4f, 1e5f, 1e6f};

// The errors the project promises, relative to the average or, where the lobe sees next to nothing,
// to a millionth of the brightest texel.
double tolerance(float exponent) {
    return exponent <= 1e4f ? 1e-4 : 1e-3;
}

// Directions of 32 bits and their products are off by up to five roundings, as if the lobe were
// asked for a little beside its axis. It matters where a sun stands on a horizon.
constexpr double TILT = 5 * 0x1p-24;

std::vector<Direction> beside(Direction axis) {
    const Direction across = oracle::normalised(
        oracle::cross(axis, std::abs(axis.x) < 0.5 ? Direction{1, 0, 0} : Direction{0, 1, 0}));
    const Direction along = oracle::cross(axis, across);
    std::vector<Direction> axes;
    for (double sign : {-1.0, 1.0})
        for (Direction to : {across, along})
            axes.push_back(oracle::normalised(axis + (sign * TILT) * to));
    return axes;
}

// The error of a channel, in units of the brighter of the average and the darkest light that
// counts.
double error_of(double found, double truth, double most) {
    return std::abs(found - truth) / std::max(truth, 1e-6 * most);
}

// The least error against the truth at the asked axes and, if that is too much, beside them.
using Truth = std::function<oracle::Rgb(Direction axis, Direction normal)>;
double error_of(const std::array<float, 4>& found, const oracle::Rgb& most, double allowed,
                Direction axis, Direction normal, const Truth& truth) {
    const oracle::Rgb there = truth(axis, normal);
    oracle::Rgb low = there;
    oracle::Rgb high = there;
    const auto widen = [&](const oracle::Rgb& other) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], other[c]);
            high[c] = std::max(high[c], other[c]);
        }
    };
    const auto worst = [&] {
        double error = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double nearest = std::clamp(double(found[c]), low[c], high[c]);
            error = std::max(error, error_of(double(found[c]), nearest, most[c]));
        }
        return error;
    };
    if (worst() <= allowed) return worst();
    for (Direction other : beside(axis)) widen(truth(other, normal));
    if (axis.x != normal.x || axis.y != normal.y)
        for (Direction other : beside(normal)) widen(truth(axis, other));
    return worst();
}

// Every `stride`-th of some small environments.
std::vector<Source> small_sources(std::size_t stride) {
    std::vector<Source> sources;
    std::uint64_t seed = 1;
    for (auto [width, height] :
         {std::pair{1, 1}, {2, 1}, {1, 5}, {3, 2}, {17, 9}, {64, 1}, {64, 32}})
        sources.push_back(random_panorama(Scene::suns, width, height, seed++));
    for (int size : {1, 2, 3, 16}) sources.push_back(random_cube(Scene::suns, size, seed++));
    sources.push_back(random_panorama(Scene::noise, 17, 9, seed++));
    sources.push_back(random_cube(Scene::halves, 16, seed++));
    std::vector<Source> chosen;
    for (std::size_t i = 0; i < sources.size(); i += stride) chosen.push_back(sources[i]);
    return chosen;
}

Direction rounded(Direction d) {
    return {float(d.x), float(d.y), float(d.z)};
}

// +-X, +-Y, +-Z, where horizons lie on edges of texels, and random ones. At a pole a sharp lobe
// meets every column, which takes long.
std::vector<Direction> axes_for(float exponent, std::uint64_t seed) {
    std::vector<Direction> axes;
    for (Direction d : oracle::test_directions(11, seed))
        if (exponent < 1e5f || std::abs(d.y) < 1) axes.push_back(rounded(d));
    return axes;
}

class ExactTruthTest : public ExactTest, public testing::WithParamInterface<float> {};
INSTANTIATE_TEST_SUITE_P(Exponents, ExactTruthTest, testing::ValuesIn(some_of(EXPONENTS)));

TEST_P(ExactTruthTest, GivesTheLobeAverages) {
    const float exponent = GetParam();
    double worst = 0;
    std::uint64_t seed = 100;
    for (const Source& source : small_sources(exponent < 1e5f ? 1 : 4)) {
        const Truth truth = [&](Direction axis, Direction) {
            return lobe_average(source, oracle::normalised(axis), double(exponent));
        };
        const std::vector<Direction> axes = axes_for(exponent, seed++);
        const std::vector<Average> found = averages(source, exponent, axes);
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const double error =
                error_of(found[i], largest(source), tolerance(exponent), axes[i], axes[i], truth);
            EXPECT_LE(error, tolerance(exponent))
                << shape_of(source) << " n " << exponent << " axis " << axes[i].x << " "
                << axes[i].y << " " << axes[i].z << ": " << found[i][0] << " for "
                << truth(axes[i], axes[i])[0];
            worst = std::max(worst, error);
        }
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST_P(ExactTruthTest, GivesTheSpecularAveragesAboveAHorizon) {
    const float exponent = GetParam();
    double worst = 0;
    double worst_weight = 0;
    oracle::Random random(200);
    for (const Source& source : small_sources(exponent < 1e5f ? 3 : 6)) {
        std::vector<ExactQuery> queries;
        for (int i = 0; i < 8; ++i) {
            const Direction normal = random.direction();
            const Direction across = oracle::normalised(oracle::cross(normal, random.direction()));
            const double sine = i == 0 ? 0.0 : i == 1 ? 1.0 : random.unit(); // head on, grazing
            queries.push_back(query(sine * across + std::sqrt(1 - sine * sine) * normal, normal));
        }
        const Truth truth = [&](Direction axis, Direction normal) {
            oracle::Rgb value = specular_average(source, normal, axis, double(exponent));
            for (double& channel : value)
                channel /= oracle::albedo(oracle::dot(axis, normal), double(exponent));
            return value;
        };
        const std::vector<Average> found =
            ask(on_device(gpu, image_of(source)), {.exponent = exponent, .clipped = true}, queries);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto direction = [](const float* f) {
                return oracle::normalised({f[0], f[1], f[2]});
            };
            const Direction axis = direction(queries[i].axis);
            const Direction normal = direction(queries[i].normal);
            const double albedo = oracle::albedo(oracle::dot(axis, normal), double(exponent));
            const double found_albedo =
                double(found[i][3]) * (double(exponent) + 2) / (2 * oracle::PI);
            EXPECT_NEAR(found_albedo / albedo, 1, tolerance(exponent))
                << shape_of(source) << " n " << exponent << " N.R " << oracle::dot(axis, normal);
            worst_weight = std::max(worst_weight, std::abs(found_albedo / albedo - 1));
            const double error =
                error_of(found[i], largest(source), tolerance(exponent), axis, normal, truth);
            EXPECT_LE(error, tolerance(exponent))
                << shape_of(source) << " n " << exponent << " N.R " << oracle::dot(axis, normal)
                << ": " << found[i][0] << " for " << truth(axis, normal)[0];
            worst = std::max(worst, error);
        }
    }
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("worst_weight", std::to_string(worst_weight));
}

class ExactRealTest : public ExactTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Panoramas, ExactRealTest,
                         testing::Range(std::size_t(0), REAL_PANORAMAS.size(), std::size_t(ONE_IN)),
                         [](const auto& parameter) { return REAL_PANORAMAS[parameter.param]; });

TEST_P(ExactRealTest, AveragesAPhotographedPanorama) {
    if (!has_real_panoramas()) GTEST_SKIP() << "no panoramas in " LOBELIA_PANORAMAS;
    const std::string name = REAL_PANORAMAS[GetParam()];
    const host::Image image = real_panorama(name);
    const Source source = source_of(image);
    const host::GpuImage panorama = on_device(gpu, image);
    std::vector<Direction> axes;
    for (Direction d : oracle::test_directions(16, 300)) axes.push_back(rounded(d));
    // for time, half of the exponents each
    const std::array<float, 3> exponents =
        GetParam() % 2 ? std::array{0.0f, 4.8f, 64.0f} : std::array{1.0f, 16.0f, 256.0f};
    double worst_rms = 0;
    for (float exponent : exponents) {
        const std::vector<Average> found = averages(panorama, exponent, axes);
        const std::vector<oracle::Rgb> truth = lobe_averages(source, axes, double(exponent));
        std::vector<double> actual, exact_values;
        for (std::size_t i = 0; i < axes.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                actual.push_back(double(found[i][c]));
                exact_values.push_back(truth[i][c]);
            }
        const oracle::ErrorMeasures error = oracle::measure_error(actual, exact_values);
        EXPECT_LE(error.pointwise_rms, 1e-5) << name << " n " << exponent;
        EXPECT_LE(error.pointwise_max, 1e-4) << name << " n " << exponent;
        worst_rms = std::max(worst_rms, error.pointwise_rms);
    }
    RecordProperty("worst_rms_millionths", std::to_string(1e6 * worst_rms));
}

} // namespace
} // namespace lobelia::test
