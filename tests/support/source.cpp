#include "support/source.h"

#include <cassert>
#include <utility>

#include "support/quadrature.h"
#include "support/texel_table.h"

namespace lobelia::oracle {
namespace {

template <class Chart>
void fill_points(TexelTable& table, std::size_t width, std::size_t height) {
    for (int m = 1; m <= MAX_TABLE_POINTS; ++m) {
        const GaussRule& rule = gauss(m);
        auto& columns = table.columns[std::size_t(m)];
        auto& rows = table.rows[std::size_t(m)];
        const auto middle = [](const std::vector<double>& edges, std::size_t i) {
            return 0.5 * (edges[i] + edges[i + 1]);
        };
        const auto half = [](const std::vector<double>& edges, std::size_t i) {
            return 0.5 * std::abs(edges[i + 1] - edges[i]);
        };
        for (std::size_t x = 0; x < width; ++x)
            for (double at : rule.at)
                columns.push_back(Chart::column(middle(table.u, x) + half(table.u, x) * at));
        for (std::size_t y = 0; y < height; ++y)
            for (double at : rule.at)
                rows.push_back(Chart::row(middle(table.v, y) + half(table.v, y) * at));
    }
}

TexelTable make_panorama_table(int width, int height) {
    TexelTable table;
    for (int x = 0; x <= width; ++x) table.u.push_back(2 * PI * (0.5 - double(x) / width));
    for (int y = 0; y <= height; ++y) table.v.push_back(PI * (0.5 - double(y) / height));
    for (int y = 0; y < height; ++y)
        table.radius.push_back(angular_radius<Panorama>(table.box(0, y)));
    fill_points<Panorama>(table, std::size_t(width), std::size_t(height));
    return table;
}

TexelTable make_cube_table(int size) {
    TexelTable table;
    for (int i = 0; i <= size; ++i) table.u.push_back(2.0 * i / size - 1);
    table.v = table.u;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            table.radius.push_back(angular_radius<CubeFace>(table.box(x, y)));
    fill_points<CubeFace>(table, std::size_t(size), std::size_t(size));
    return table;
}

std::vector<Rgb> without_alpha(std::span<const float> rgba) {
    std::vector<Rgb> texels(rgba.size() / 4);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]};
    return texels;
}

} // namespace

Direction panorama_direction(double x, double y, int width, int height) {
    const double longitude = 2 * PI * (0.5 - x / width);
    const double latitude = PI * (0.5 - y / height);
    return {std::sin(longitude) * std::cos(latitude), std::sin(latitude),
            std::cos(longitude) * std::cos(latitude)};
}

Angles panorama_angles(Direction d) {
    return {std::atan2(d.x, d.z), std::atan2(d.y, std::hypot(d.x, d.z))};
}

// Vulkan specification, "Cube Map Face Selection and Transformations": s_c, t_c and r_c.
const FaceFrame& cube_face(int face) {
    static const std::array<FaceFrame, 6> frames{{
        {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, // +X: s = -z, t = -y
        {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}}, // -X: s = +z, t = -y
        {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   // +Y: s = +x, t = +z
        {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, // -Y: s = +x, t = -z
        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  // +Z: s = +x, t = -y
        {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}} // -Z: s = -x, t = -y
    }};
    return frames[std::size_t(face)];
}

Direction cube_direction(int face, double x, double y, int size) {
    const FaceFrame& frame = cube_face(face);
    return normalised(frame.outwards + (2 * x / size - 1) * frame.right +
                      (2 * y / size - 1) * frame.down);
}

FacePoint cube_point(Direction d, int size) {
    int best = 0;
    for (int face = 1; face < 6; ++face)
        if (dot(d, cube_face(face).outwards) > dot(d, cube_face(best).outwards)) best = face;
    const FaceFrame& frame = cube_face(best);
    const double depth = dot(d, frame.outwards);
    return {best, 0.5 * size * (dot(d, frame.right) / depth + 1),
            0.5 * size * (dot(d, frame.down) / depth + 1)};
}

double panorama_texel_solid_angle(int y, int width, int height) {
    const double top = PI * (0.5 - double(y) / height);
    const double bottom = PI * (0.5 - (y + 1.0) / height);
    // sin a - sin b without cancellation
    return 2 * PI / width * 2 * std::cos(0.5 * (top + bottom)) * std::sin(0.5 * (top - bottom));
}

double cube_texel_solid_angle(int x, int y, int size) {
    const auto edge = [size](int i) { return 2.0 * i / size - 1; };
    return CubeFace::solid_angle({edge(x), edge(x + 1), edge(y), edge(y + 1)});
}

Source::Source(int width, int height, int layers, std::vector<Rgb> texels)
    : width_(width), height_(height), layers_(layers), texels_(std::move(texels)) {
    assert(width > 0 && height > 0);
    assert(texels_.size() == std::size_t(width) * std::size_t(height) * std::size_t(layers));
    table_ = std::make_shared<const TexelTable>(layers == 6 ? make_cube_table(width)
                                                            : make_panorama_table(width, height));
}

Source Source::panorama(int width, int height, std::vector<Rgb> texels) {
    return {width, height, 1, std::move(texels)};
}
Source Source::cube(int size, std::vector<Rgb> texels) {
    return {size, size, 6, std::move(texels)};
}
Source Source::panorama(int width, int height, std::span<const float> rgba) {
    return panorama(width, height, without_alpha(rgba));
}
Source Source::cube(int size, std::span<const float> rgba) {
    return cube(size, without_alpha(rgba));
}

std::size_t Source::index(int layer, int x, int y) const {
    return (std::size_t(layer) * std::size_t(height_) + std::size_t(y)) * std::size_t(width_) +
           std::size_t(x);
}

Direction Source::direction(int layer, int x, int y) const {
    return is_cube() ? cube_direction(layer, x + 0.5, y + 0.5, width_)
                     : panorama_direction(x + 0.5, y + 0.5, width_, height_);
}

double Source::solid_angle(int x, int y) const {
    return is_cube() ? cube_texel_solid_angle(x, y, width_)
                     : panorama_texel_solid_angle(y, width_, height_);
}

Rgb Source::mean() const {
    Rgb sum{};
    for (int layer = 0; layer < layers_; ++layer)
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += solid_angle(x, y) / (4 * PI) * texel(layer, x, y)[c];
    return sum;
}

std::vector<float> Source::rgba() const {
    std::vector<float> floats;
    for (const Rgb& texel : texels_) {
        for (double channel : texel) floats.push_back(float(channel));
        floats.push_back(1.0f);
    }
    return floats;
}

} // namespace lobelia::oracle
