// The diffuse lobe's light from spherical harmonics, for C++ and GLSL alike. Ramamoorthi and Hanrahan
// 2001, "An Efficient Representation for Irradiance Environment Maps": the lobe leaves degrees 0, 1
// and 2 nearly all of what it leaves, nothing of degree 3 and little of 4. The coefficients come from
// Irradiance (lobelia/irradiance.h):
//     P_1(normal) = the sum of coefficient[i] basis.y[i], i up to IRRADIANCE_DEGREE_2 or _4.
#ifndef LOBELIA_IRRADIANCE_GLSL
#define LOBELIA_IRRADIANCE_GLSL

#include "lobelia/language.glsl"

const uint IRRADIANCE_DEGREE_2 = 9u; // how many coefficients there are up to degree 2
const uint IRRADIANCE_DEGREE_4 = 18u;

// Real orthonormal spherical harmonics of degrees 0, 1, 2 and 4.
struct IrradianceBasis {
    float y[18];
};

SHARED IrradianceBasis irradiance_basis(vec3 d) {
    float xx = d.x * d.x;
    float yy = d.y * d.y;
    float zz = d.z * d.z;
    float xy = d.x * d.y;
    float yz = d.y * d.z;
    float xz = d.x * d.z;
    IrradianceBasis basis;
    basis.y[0] = 0.282094792f;
    basis.y[1] = 0.488602512f * d.y;
    basis.y[2] = 0.488602512f * d.z;
    basis.y[3] = 0.488602512f * d.x;
    basis.y[4] = 1.092548431f * xy;
    basis.y[5] = 1.092548431f * yz;
    basis.y[6] = 0.315391565f * (3.0f * zz - 1.0f);
    basis.y[7] = 1.092548431f * xz;
    basis.y[8] = 0.546274215f * (xx - yy);
    basis.y[9] = 2.503342942f * xy * (xx - yy);
    basis.y[10] = 1.770130769f * yz * (3.0f * xx - yy);
    basis.y[11] = 0.946174696f * xy * (7.0f * zz - 1.0f);
    basis.y[12] = 0.669046544f * yz * (7.0f * zz - 3.0f);
    basis.y[13] = 0.105785547f * ((35.0f * zz - 30.0f) * zz + 3.0f);
    basis.y[14] = 0.669046544f * xz * (7.0f * zz - 3.0f);
    basis.y[15] = 0.473087348f * (xx - yy) * (7.0f * zz - 1.0f);
    basis.y[16] = 1.770130769f * xz * (xx - 3.0f * yy);
    basis.y[17] = 0.625835735f * (xx * (xx - 3.0f * yy) - yy * (3.0f * xx - yy));
    return basis;
}

// What the lobe of exponent 1 multiplies coefficient i by: its eigenvalue for that degree.
SHARED float irradiance_eigenvalue(uint i) {
    if (i == 0u) return 1.0f;
    if (i < 4u) return 2.0f / 3.0f;
    return i < 9u ? 0.25f : -1.0f / 24.0f;
}

#ifndef __cplusplus
// P_1 about a unit vector, from the first `count` coefficients. Light that is not there: a series
// that ends rings around a sun, and below 0 it is cut.
vec3 irradiance_average(vec4 coefficients[IRRADIANCE_DEGREE_4], vec3 normal, uint count) {
    IrradianceBasis basis = irradiance_basis(normal);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < count; ++i) sum += basis.y[i] * coefficients[i].rgb;
    return max(sum, 0.0);
}
#endif

#endif
