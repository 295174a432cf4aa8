#include "sphere_fixture.h"

// The sums of Kurt 2019 against the same in double precision.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;

/// A colour, and how far off a device may be: filters weigh texels in steps of at least 2^-8.
struct Light {
    Rgb colour{};
    Rgb slack{};

    void add(double weight, const Light& other) {
        for (std::size_t c = 0; c < 3; ++c) {
            colour[c] += weight * other.colour[c];
            slack[c] += weight * other.slack[c];
        }
    }
};

/// The mean of a square of texels.
Light block(const oracle::Source& source, int face, int x, int y, int size) {
    Light sum;
    for (int j = y * size; j < (y + 1) * size; ++j)
        for (int i = x * size; i < (x + 1) * size; ++i)
            sum.add(1.0 / (size * size), {source.texel(face, i, j), {}});
    return sum;
}

/// A face averaged down to `size` texels, read bilinearly at (u, v) from 0 to 1.
Light bilinear(const oracle::Source& source, int face, double u, double v, int size) {
    const double x = u * size - 0.5, y = v * size - 0.5;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const double right_share = x - left, low_share = y - top;
    const int texels = source.width() / size;
    Light sum;
    Rgb least{1e300, 1e300, 1e300}, most{};
    for (int i = 0; i < 4; ++i) {
        const bool right = i % 2 == 1, low = i / 2 == 1;
        const Light texel = block(source, face, left + right, top + low, texels);
        sum.add((right ? right_share : 1 - right_share) * (low ? low_share : 1 - low_share), texel);
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], texel.colour[c]);
            most[c] = std::max(most[c], texel.colour[c]);
        }
    }
    // Both shares may be off by a step, and either moves at most the whole contrast by it.
    for (std::size_t c = 0; c < 3; ++c) sum.slack[c] = 2 * (most[c] - least[c]) / 256;
    return sum;
}

std::array<Light, 6> faces_of(const oracle::Source& source) {
    const int size = std::min(source.width(), 64);
    std::array<Light, 6> faces;
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < 9; ++i)
            faces[std::size_t(face)].add(1.0 / 9, bilinear(source, face, (2 * (i % 3) + 1) / 6.0,
                                                           (2 * (i / 3) + 1) / 6.0, size));
    return faces;
}

Light about(const std::array<Light, 6>& faces, Direction direction) {
    const double weights[] = {direction.x,  -direction.x, direction.y,
                              -direction.y, direction.z,  -direction.z};
    double total = 0;
    for (const double weight : weights) total += std::max(weight, 0.0);
    Light sum;
    for (std::size_t face = 0; face < 6; ++face)
        sum.add(std::max(weights[face], 0.0) / total, faces[face]);
    return sum;
}

class SphereKurt2019Test : public SphereTest {
protected:
    void expect_sums(const oracle::Source& source, const Material& material, const Camera& eye) {
        const host::GpuEnvironment environment = upload(image_of(source));
        const SphereView view{.camera = eye, .material = material, .width = 12, .height = 12};
        const host::Image picture = draw(environment, view, SphereMethod::kurt2019);
        const std::array<Light, 6> faces = faces_of(source);
        const oracle::Camera camera = oracle_camera(view);
        const double n = double(material.exponent);
        const double gloss = 1 - std::sqrt(2 / (n + 2));
        int compared = 0;
        for (std::uint32_t i = 0; i < 144; ++i) {
            const float* const pixel = &picture.texels[std::size_t(4) * i];
            const auto hit =
                oracle::meet_sphere(camera.eye, ray(camera, i % 12 + 0.5, i / 12 + 0.5));
            if (!hit || pixel[3] < 1.0f) continue;
            const Light mirror = about(faces, oracle::mirror(hit->normal, hit->view));
            const double cosine = dot(hit->normal, hit->view);
            const double kd = double(material.diffuse[0]), ks = double(material.specular[0]);
            Light expected;
            expected.add(kd * (1 - gloss), about(faces, hit->normal));
            expected.add(kd * gloss + ks * oracle::albedo(cosine, n), mirror);
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(double(pixel[c]), expected.colour[c],
                            expected.slack[c] + 1e-5 * expected.colour[c])
                    << "face " << source.width() << " kd " << kd << " ks " << ks << " n " << n
                    << " pixel " << i;
            ++compared;
        }
        EXPECT_GT(compared, 60);
    }
};

TEST_F(SphereKurt2019Test, IsTheWeightedMeanOfNineSamplesAFace) {
    oracle::Random random(31);
    for (const int face : {16, 64, 128, 256}) {
        const auto source = oracle::random_cube(oracle::Scene::noise, face, std::uint64_t(face));
        for (const Material& material : {grey(1.0f, 0.0f, 0.0f), grey(0.75f, 0.0f, 4.8f),
                                         grey(0.0f, 1.0f, 64.0f), grey(0.25f, 0.5f, 1e6f)})
            expect_sums(source, material, {.eye = floats(4.0 * random.direction())});
    }
}

} // namespace
} // namespace lobelia::test
