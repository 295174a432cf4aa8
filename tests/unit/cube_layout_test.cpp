#include <array>

#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <lobelia/host/read.h>
#include <lobelia/host/write.h>

#include "file_fixtures.h"

namespace lobelia::test {

namespace {

constexpr int SIZE = 5;

// The direction at the centre of texel (x, y) of a face, unit length along the face's axis, from
// the table of section "Cube Map Face Selection and Transformations" of the Vulkan specification.
std::array<float, 3> vulkan_direction(unsigned face, unsigned x, unsigned y) {
    const float s = 2.0f * (float(x) + 0.5f) / SIZE - 1.0f;
    const float t = 2.0f * (float(y) + 0.5f) / SIZE - 1.0f;
    switch (face) {
    case 0: return {1, -t, -s};
    case 1: return {-1, -t, s};
    case 2: return {s, 1, t};
    case 3: return {s, -1, -t};
    case 4: return {s, -t, 1};
    default: return {-s, -t, -1};
    }
}

// Where OpenEXR keeps a texel, and its direction. OpenEXR's outermost samples lie on the edges of a
// face, ours half a texel inside: the same grid, (SIZE - 1) / SIZE as wide.
struct Sample {
    int x, y;
    std::array<float, 3> direction;
};

std::vector<Sample> openexr_samples() {
    const Imath::Box2i window({0, 0}, {SIZE - 1, 6 * SIZE - 1});
    std::vector<Sample> samples;
    for (int f = 0; f < 6; ++f)
        for (int j = 0; j < SIZE; ++j)
            for (int i = 0; i < SIZE; ++i) {
                const auto face = Imf::CubeMapFace(f);
                const Imath::V2f in_face{float(i), float(j)};
                const Imath::V2f at = Imf::CubeMap::pixelPosition(face, window, in_face);
                const Imath::V3f d = Imf::CubeMap::direction(face, window, in_face);
                Sample sample{int(at.x), int(at.y), {d.x, d.y, d.z}};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (axis != std::size_t(f / 2)) sample.direction[axis] *= (SIZE - 1.0f) / SIZE;
                samples.push_back(sample);
            }
    return samples;
}

} // namespace

class CubeLayoutTest : public FileTest {};

TEST_F(CubeLayoutTest, KeepsTheDirectionOfEveryTexelThatIsRead) {
    std::vector<std::array<float, 3>> directions(6 * SIZE * SIZE);
    for (const Sample& sample : openexr_samples())
        directions[std::size_t(sample.y * SIZE + sample.x)] = sample.direction;
    std::vector<Channel> channels;
    for (std::size_t axis = 0; axis < 3; ++axis)
        channels.push_back({std::string(1, "RGB"[axis]), Imf::FLOAT, [=](int x, int y) {
                                return directions[std::size_t(y * SIZE + x)][axis] + 1.0f;
                            }});
    Imf::Header header(SIZE, 6 * SIZE);
    Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
    make_exr(path("cube.exr"), header, channels);

    const auto environment = host::read_environment(path("cube.exr"));
    ASSERT_TRUE(environment) << environment.error().message;
    const host::Image& cube = environment->image;
    ASSERT_EQ(cube.layout, host::Layout::cube);
    ASSERT_EQ(cube.layers, 6u);
    ASSERT_EQ(cube.width, unsigned(SIZE));
    ASSERT_EQ(cube.height, unsigned(SIZE));
    for (unsigned face = 0; face < 6; ++face)
        for (unsigned y = 0; y < SIZE; ++y)
            for (unsigned x = 0; x < SIZE; ++x)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(cube.texel(face, x, y)[axis] - 1.0f,
                                vulkan_direction(face, x, y)[axis], 1e-6f)
                        << "face " << face << " texel " << x << ", " << y << " axis " << axis;
}

TEST_F(CubeLayoutTest, KeepsTheDirectionOfEveryTexelThatIsWritten) {
    host::Image cube{host::Layout::cube, SIZE, SIZE, 6, {}};
    cube.texels.resize(6 * SIZE * SIZE * 4);
    for (unsigned face = 0; face < 6; ++face)
        for (unsigned y = 0; y < SIZE; ++y)
            for (unsigned x = 0; x < SIZE; ++x)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    cube.texel(face, x, y)[axis] = vulkan_direction(face, x, y)[axis];
    const host::Part part{"", &cube};
    const auto written = host::write_exr(path("cube.exr"), {&part, 1}, host::Content::environment);
    ASSERT_TRUE(written) << written.error().message;

    const std::vector<float> colour = read_by_openexr(path("cube.exr"));
    for (const Sample& sample : openexr_samples())
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(colour[std::size_t(sample.y * SIZE + sample.x) * 3 + axis],
                        sample.direction[axis], 1e-6f)
                << "file texel " << sample.x << ", " << sample.y << " axis " << axis;
}

} // namespace lobelia::test
