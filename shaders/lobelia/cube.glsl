// Cube maps in Vulkan's face order and orientation (+X -X +Y -Y +Z -Z), for C++ and GLSL alike.
// Vulkan specification, "Cube Map Face Selection" and "Cube Map Coordinate Transformation".
#ifndef LOBELIA_CUBE_GLSL
#define LOBELIA_CUBE_GLSL

#include "lobelia/direction.glsl"

const uint CUBE_FACES = 6u;

// A point of the cube: u to the right and v downwards, each from -1 to 1 across the face.
struct CubePoint {
    uint face;
    float u;
    float v;
};

// The face coordinate, u or v, of the centre of texel number `texel` in a row of `size`.
SHARED float cube_texel_centre(uint texel, uint size) {
    return (float(2u * texel + 1u) - float(size)) / float(size);
}

// The vector from the cube's centre to a point of its surface; not of unit length.
SHARED vec3 cube_direction(uint face, float u, float v) {
    switch (face) {
    case 0u:
        return vec3(1.0f, -v, -u);
    case 1u:
        return vec3(-1.0f, -v, u);
    case 2u:
        return vec3(u, 1.0f, v);
    case 3u:
        return vec3(u, -1.0f, -v);
    case 4u:
        return vec3(u, -v, 1.0f);
    }
    return vec3(-u, -v, -1.0f);
}

// The point that `direction`, of any length but 0, goes through. On edges and corners Z wins over Y
// and Y over X, as the specification advises.
SHARED CubePoint cube_point(vec3 direction) {
    float x = abs(direction.x);
    float y = abs(direction.y);
    float z = abs(direction.z);
    CubePoint point;
    if (z >= x && z >= y) {
        bool front = direction.z > 0.0f;
        point.face = front ? 4u : 5u;
        point.u = (front ? direction.x : -direction.x) / z;
        point.v = -direction.y / z;
    } else if (y >= x) {
        bool top = direction.y > 0.0f;
        point.face = top ? 2u : 3u;
        point.u = direction.x / y;
        point.v = (top ? direction.z : -direction.z) / y;
    } else {
        bool right = direction.x > 0.0f;
        point.face = right ? 0u : 1u;
        point.u = (right ? -direction.z : direction.z) / x;
        point.v = -direction.y / x;
    }
    return point;
}

// Solid angle of a triangle in the plane at distance 1 that has twice the area `double_area`; `a`,
// `b` and `c` are its corners as seen from the origin. Van Oosterom and Strackee 1983, "The Solid
// Angle of a Plane Triangle".
SHARED float triangle_solid_angle(vec3 a, vec3 b, vec3 c, float double_area) {
    float denominator = length(a) * length(b) * length(c) + dot(a, b) * length(c) +
                        dot(a, c) * length(b) + dot(b, c) * length(a);
    return 2.0f * atan_series(double_area / denominator);
}

// Solid angle in steradians of a rectangle of `area` on any face, in face coordinates from -1 to 1.
// The usual form, a difference of four arctangents, loses the digits of small ones; here nothing
// cancels, and the relative error is below 1e-6 at every size.
SHARED float cube_solid_angle(float left, float top, float right, float bottom, float area) {
    vec3 a = vec3(left, top, 1.0f);
    vec3 b = vec3(right, top, 1.0f);
    vec3 c = vec3(right, bottom, 1.0f);
    vec3 d = vec3(left, bottom, 1.0f);
    return triangle_solid_angle(a, b, c, area) + triangle_solid_angle(a, c, d, area);
}

// The same of texel (x, y) of a face of `size` texels a side.
SHARED float cube_texel_solid_angle(uint x, uint y, uint size) {
    float texel = 2.0f / float(size);
    float left = (float(2u * x) - float(size)) / float(size);
    float top = (float(2u * y) - float(size)) / float(size);
    float right = (float(2u * x + 2u) - float(size)) / float(size);
    float bottom = (float(2u * y + 2u) - float(size)) / float(size);
    return cube_solid_angle(left, top, right, bottom, texel * texel);
}

#endif
