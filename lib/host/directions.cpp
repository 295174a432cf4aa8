#include "host/directions.h"

#include <cmath>
#include <numbers>

#include "host/sizes.h"

namespace lobelia::host {

namespace {

/// A face's middle, and the ways along its rows and down its columns.
struct Face {
    Vector outwards, right, down;
};
constexpr Face CUBE[FACES] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
};

double centre(std::uint32_t texel, std::uint32_t size) {
    return (2.0 * texel + 1.0) / size - 1.0;
}

// Solid angle of the part of a face between its middle and the point (x, y).
double corner_solid_angle(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0));
}

double texel_solid_angle(std::uint32_t x, std::uint32_t y, std::uint32_t size) {
    const double left = 2.0 * x / size - 1.0, right = 2.0 * (x + 1.0) / size - 1.0;
    const double top = 2.0 * y / size - 1.0, bottom = 2.0 * (y + 1.0) / size - 1.0;
    return corner_solid_angle(right, bottom) - corner_solid_angle(left, bottom) -
           corner_solid_angle(right, top) + corner_solid_angle(left, top);
}

std::vector<Vector> cube_directions(std::uint32_t size) {
    std::vector<Vector> directions;
    directions.reserve(cube_texels(size));
    for (const Face& face : CUBE)
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x)
                directions.push_back(normalised(face.outwards + centre(x, size) * face.right +
                                                centre(y, size) * face.down));
    return directions;
}

std::vector<Vector> panorama_directions(std::uint32_t width, std::uint32_t height) {
    std::vector<Vector> directions;
    directions.reserve(std::size_t(width) * height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const double longitude = 2.0 * std::numbers::pi * (0.5 - (x + 0.5) / width);
            const double latitude = std::numbers::pi * (0.5 - (y + 0.5) / height);
            directions.push_back({std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                                  std::cos(longitude) * std::cos(latitude)});
        }
    return directions;
}

} // namespace

std::vector<Vector> texel_directions(Layout layout, std::uint32_t width, std::uint32_t height) {
    return layout == Layout::cube ? cube_directions(width) : panorama_directions(width, height);
}

std::vector<double> solid_angles(std::uint32_t size) {
    std::vector<double> angles;
    angles.reserve(std::size_t(size) * size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) angles.push_back(texel_solid_angle(x, y, size));
    return angles;
}

Image reduced_cube(const Image& cube, std::uint32_t size) {
    const std::uint32_t block = cube.width / size;
    const std::vector<double> areas = solid_angles(cube.width);
    Image reduced{Layout::cube, size, size, FACES,
                  std::vector<float>(CHANNELS * cube_texels(size), 1.0f)};
    for (std::uint32_t face = 0; face < FACES; ++face)
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                double light[3] = {}, area = 0.0;
                for (std::uint32_t v = y * block; v < (y + 1) * block; ++v)
                    for (std::uint32_t u = x * block; u < (x + 1) * block; ++u) {
                        const double solid_angle = areas[std::size_t(v) * cube.width + u];
                        const float* texel = cube.texel(face, u, v);
                        for (int i = 0; i < 3; ++i) light[i] += solid_angle * double(texel[i]);
                        area += solid_angle;
                    }
                for (int i = 0; i < 3; ++i) reduced.texel(face, x, y)[i] = float(light[i] / area);
            }
    return reduced;
}

} // namespace lobelia::host
