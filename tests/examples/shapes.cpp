#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(float s, const Vector& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
float dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normalised(const Vector& a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}

namespace {

constexpr float TURN = 2 * std::numbers::pi_v<float>;

/// A grid of `along` x `across` quads whose vertex at (s, t) in [0, 1]^2 is `vertex(s, t)`.
template <class Function>
Mesh make_grid(std::uint32_t along, std::uint32_t across, Function vertex) {
    Mesh mesh;
    for (std::uint32_t i = 0; i <= along; ++i)
        for (std::uint32_t j = 0; j <= across; ++j) {
            mesh.vertices.push_back(vertex(float(i) / float(along), float(j) / float(across)));
            if (i == along || j == across) continue;
            const std::uint32_t a = i * (across + 1) + j, b = a + across + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return mesh;
}

Vector knot(float s) {
    const float ring = 2 * TURN * s, tube = 3 * TURN * s;
    const float distance = 0.75f + 0.3f * std::cos(tube);
    return {distance * std::sin(ring), distance * std::cos(ring), 0.36f * std::sin(tube)};
}

} // namespace

Mesh make_knot(float radius) {
    return make_grid(1024, 96, [radius](float s, float t) {
        constexpr float STEP = 1e-3f;
        const Vector before = knot(s - STEP), middle = knot(s), after = knot(s + STEP);
        const Vector tangent = normalised(after - before);
        const Vector bend = after + before - 2.0f * middle; // towards the curve's inside
        const Vector side = normalised(bend - dot(bend, tangent) * tangent);
        const Vector normal = std::cos(TURN * t) * side + std::sin(TURN * t) * cross(tangent, side);
        return Vertex{middle + radius * normal, normal, tangent, {36 * s, 5 * t}};
    });
}

Mesh make_sphere() {
    return make_grid(1024, 512, [](float s, float t) {
        const float longitude = TURN * s, polar = TURN / 2 * t;
        const Vector normal{std::sin(polar) * std::sin(longitude), std::cos(polar),
                            std::sin(polar) * std::cos(longitude)};
        return Vertex{normal, normal, {std::cos(longitude), 0, -std::sin(longitude)}, {s, t}};
    });
}

namespace {

// Height in texture units at a place of the tile.
float height(float u, float v) {
    const auto ridge = [](float x) { // 1 in the middle of a line through every integer
        const float distance = std::abs(x - std::round(x));
        const float t = std::clamp((0.13f - distance) / 0.07f, 0.0f, 1.0f);
        return t * t * (3 - 2 * t);
    };
    const float x = u - std::floor(u), y = v - std::floor(v);
    float raised = std::max(ridge(u + v), ridge(u - v));
    for (const auto& [cx, cy] :
         {std::array{0.5f, 0.0f}, {0.0f, 0.5f}, {1.0f, 0.5f}, {0.5f, 1.0f}}) {
        const float square = ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (0.16f * 0.16f);
        raised = std::max(raised, std::sqrt(std::max(1 - square, 0.0f)));
    }
    return 0.1f * raised;
}

} // namespace

Relief make_relief() {
    Relief relief;
    const auto byte = [](float value) { return std::uint8_t(std::lround(255 * value)); };
    for (std::uint32_t row = 0; row < Relief::SIZE; ++row)
        for (std::uint32_t column = 0; column < Relief::SIZE; ++column) {
            constexpr float STEP = 1.0f / Relief::SIZE;
            const float u = (float(column) + 0.5f) * STEP, v = (float(row) + 0.5f) * STEP;
            const Vector normal =
                normalised({(height(u - STEP, v) - height(u + STEP, v)) / (2 * STEP),
                            (height(u, v - STEP) - height(u, v + STEP)) / (2 * STEP), 1});
            relief.texels.push_back({byte(0.5f + 0.5f * normal[0]), byte(0.5f + 0.5f * normal[1]),
                                     byte(0.5f + 0.5f * normal[2]),
                                     byte(std::min(height(u, v) / 0.03f, 1.0f))});
        }
    return relief;
}
