// Meshes and a texture of the engine's.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

using Vector = std::array<float, 3>;

struct Vertex {
    Vector position, normal, tangent;
    std::array<float, 2> place; // in the texture, which repeats
};
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A tube of that radius around the knot that winds twice around the z axis and thrice through the
/// hole, about 2.5 wide.
Mesh make_knot(float radius);

/// The unit sphere.
Mesh make_sphere();

/// A lattice with a stud in each mesh: SIZE x SIZE texels of a normal in tangent space, 0.5 + 0.5
/// n, and 1 where the relief is raised.
struct Relief {
    static constexpr std::uint32_t SIZE = 256;
    std::vector<std::array<std::uint8_t, 4>> texels;
};
Relief make_relief();

Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(float s, const Vector& a);
float dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector normalised(const Vector& a);
