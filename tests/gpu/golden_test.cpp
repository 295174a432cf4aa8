#include <cstdlib>
#include <filesystem>

#include <lobelia/host/read.h>
#include <lobelia/host/work.h>
#include <lobelia/host/write.h>

#include "support/error_measures.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"

// Reviewed pictures, small and linear: a change that nobody meant. They were made on lavapipe; the
// bounds leave room for another device's rounding, not for another picture. To accept new ones, run
// this program with LOBELIA_UPDATE_GOLDEN=1, look at what git shows, and commit it.
namespace lobelia::test {
namespace {

constexpr double LARGEST_RMS = 1e-4;   // relative to the golden's own
constexpr double LARGEST_ERROR = 5e-3; // of a channel, relative, black against the mean

class Golden : public GpuTest {
protected:
    host::GpuEnvironment sky = value_of(host::make_builtin_environment(gpu));

    host::Image picture(const SphereView& view, SphereMethod method = SphereMethod::split_sum) {
        return value_of(host::render(gpu, sky, {.view = view, .method = method})).picture;
    }
};

std::vector<double> colours(const host::Image& image) {
    std::vector<double> values;
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % 4 != 3) values.push_back(double(image.texels[i]));
    return values;
}

void expect_golden(const std::string& name, const host::Image& actual) {
    const std::string golden = LOBELIA_GOLDEN_FOLDER "/" + name + ".exr";
    const auto content = actual.layers == 6 ? host::Content::environment : host::Content::picture;
    const host::Part part{.image = &actual};
    if (std::getenv("LOBELIA_UPDATE_GOLDEN"))
        value_of(host::write_exr(golden, {&part, 1}, content));

    const auto expected = value_of(host::read_environment(golden)).image;
    ASSERT_EQ(actual.width, expected.width);
    ASSERT_EQ(actual.height, expected.height);
    ASSERT_EQ(actual.layers, expected.layers);
    const auto error = oracle::measure_error(colours(actual), colours(expected));
    EXPECT_LE(error.image_rms, LARGEST_RMS);
    EXPECT_LE(error.pointwise_max, LARGEST_ERROR);
    if (testing::Test::HasFailure()) {
        const std::string kept = name + "-actual.exr";
        value_of(host::write_exr(kept, {&part, 1}, content));
        ADD_FAILURE() << golden << " differs, the picture is in "
                      << std::filesystem::absolute(kept).string();
    }
}

TEST_F(Golden, DefaultMaterialUnderTheBuiltInSky) {
    expect_golden("default", picture({.material = {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 64.0f},
                                      .width = 64,
                                      .height = 64}));
}

TEST_F(Golden, ColouredMaterialFromTheSideUnderATurnedSky) {
    expect_golden("side", picture({.camera = {.eye = {-3, 2, 1}},
                                   .material = {{0.1f, 0.2f, 0.3f}, {0.6f, 0.5f, 0.2f}, 400.0f},
                                   .environment_rotation = 1.0f,
                                   .background = false,
                                   .width = 64,
                                   .height = 48}));
}

TEST_F(Golden, ReferenceOfAGlossySphere) {
    expect_golden("reference",
                  picture({.material = {{}, {1.0f, 1.0f, 1.0f}, 200.0f}, .width = 16, .height = 16},
                          SphereMethod::reference));
}

TEST_F(Golden, PrefilteredSky) {
    const auto filtered = value_of(host::prefilter(gpu, sky, {.exponents = {16.0f}, .width = 16}));
    expect_golden("sky16", filtered.maps[0]);
}

} // namespace
} // namespace lobelia::test
