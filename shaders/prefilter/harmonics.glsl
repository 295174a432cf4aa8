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
// ascent (for l = m the order's first function) and descent.
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

// Number `index` of the 3 size^2 / 4 directions, of length over 1, with all their texel in one octant.
vec3 octant_direction(uint index, uint size) {
    uint half_size = size / 2u;
    float a = float(2u * (index % half_size) + 1u) / float(size);
    float b = float(2u * (index / half_size % half_size) + 1u) / float(size);
    uint axis = index / (half_size * half_size);
    return axis == 0u ? vec3(1.0, a, b) : axis == 1u ? vec3(b, 1.0, a) : vec3(a, b, 1.0);
}

// The texel that the mirrored direction goes through: x, y and the face.
uvec3 mirrored_texel(vec3 direction, uint octant, uint size) {
    vec3 mirrored = vec3((octant & 1u) != 0u ? -direction.x : direction.x,
                         (octant & 2u) != 0u ? -direction.y : direction.y,
                         (octant & 4u) != 0u ? -direction.z : direction.z);
    CubePoint point = cube_point(mirrored);
    return uvec3((vec2(point.u, point.v) + 1.0) * 0.5 * float(size), point.face);
}

#endif
