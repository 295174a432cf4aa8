// Real spherical harmonics up to a degree, by order: those of order m are the real and imaginary part
// of (x + i y)^m times a polynomial in z, from the recurrence of the normalised associated Legendre
// functions (Holmes and Featherstone 2002, "A unified approach to the Clenshaw summation"):
//   p_l = ascent (z p_{l-1} - descent p_{l-2}).
#ifndef PREFILTER_HARMONICS_GLSL
#define PREFILTER_HARMONICS_GLSL

#include "lobelia/cube.glsl"

const int DEGREE = 28;

// Share of a variance in the face's plane, in its coordinates, that there is on the sphere, about the
// mean. The planner takes the same.
const float MEAN_READING = 0.6;

const int ORDERS = DEGREE + 1;
const int TERMS = ORDERS * (ORDERS + 1) / 2; // pairs of degree l and order m <= l

// Where the term of degree l and order m lies: by order, then degree.
int term(int l, int m) { return m * ORDERS - m * (m - 1) / 2 + l - m; }

// The first function of order m, l = m, but for its power of (x + i y).
float first_of_order(int m) {
    float square = m == 0 ? 1.0 / (4.0 * PI) : 2.0 / (4.0 * PI);
    for (int k = 1; k <= m; ++k) square *= float(2 * k + 1) / float(2 * k);
    return sqrt(square);
}

float ascent(int l, int m) { return sqrt(float(4 * l * l - 1) / float(l * l - m * m)); }

float descent(int l, int m) {
    return sqrt(float((l - 1) * (l - 1) - m * m) / float(4 * (l - 1) * (l - 1) - 1));
}

// A term's coefficients: of the real part and of the imaginary part, R G B. In w the recurrence's
// ascent and descent, where l = m such that the recurrence starts with the order's first function from 1
// and 0.
struct Term {
    vec4 real;
    vec4 imaginary;
};

// A cube map's texels come in eights, mirrored in x, y and z, at which a harmonic differs by its sign
// alone. `octant` has bits for negative x, y and z; what a real part of order m and degree l turns to
// depends on whether m (for x) and l + m (for z) are odd, an imaginary part's on y too.
float real_sign(uint octant, int odd_order, int odd_sum) {
    bool negative = ((octant & 1u) != 0u && odd_order == 1) != ((octant & 4u) != 0u && odd_sum == 1);
    return negative ? -1.0 : 1.0;
}
float imaginary_sign(uint octant, int odd_order, int odd_sum) {
    bool negative = ((octant & 1u) != 0u) != ((octant & 2u) != 0u);
    return negative ? -real_sign(octant, odd_order, odd_sum) : real_sign(octant, odd_order, odd_sum);
}

// Number `index` of the 3 size^2 / 4 texels with all their directions in one octant: the axis whose face
// it is on, and its place among those with coordinates above 0 along the next axis and the one after.
uvec3 octant_texel(uint index, uint size) {
    uint half_size = size / 2u;
    return uvec3(index / (half_size * half_size), index % half_size, index / half_size % half_size);
}

// Its place on the face; for `across` see map_place().
vec2 octant_place(uint index, uint size, uint across) {
    return vec2(2u * octant_texel(index, size).yz + 1u) / float(across);
}

// The vector of a point in the frame of its face: those two axes, and forward.
vec3 octant_vector(uint index, uint size, vec3 point) {
    uint axis = octant_texel(index, size).x;
    return axis == 0u ? point.zxy : axis == 1u ? point.yzx : point;
}

// The direction of a place on its face, of length over 1.
vec3 octant_direction(uint index, uint size, vec2 at) {
    return octant_vector(index, size, vec3(at, 1.0));
}

// The texel in the mirrored direction: x, y and the face.
uvec3 mirrored_texel(uint index, uint octant, uint size) {
    uint axis = octant_texel(index, size).x;
    uint face = 2u * axis + ((octant >> axis) & 1u);
    vec3 direction = octant_direction(index, size, octant_place(index, size, size));
    vec3 mirrored = vec3((octant & 1u) != 0u ? -direction.x : direction.x,
                         (octant & 2u) != 0u ? -direction.y : direction.y,
                         (octant & 4u) != 0u ? -direction.z : direction.z);
    vec3 ahead = cube_direction(face, 0.0, 0.0);
    vec2 at = vec2(dot(mirrored, cube_direction(face, 1.0, 0.0) - ahead),
                   dot(mirrored, cube_direction(face, 0.0, 1.0) - ahead));
    return uvec3((at + 1.0) * 0.5 * float(size), face);
}

#endif
