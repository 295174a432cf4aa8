// What the sphere's shaders are told: 128 bytes, the push constants that every device has. For C++
// and GLSL alike. Directions are in the frame of the environment's own image.
#ifndef LOBELIA_SPHERE_PARAMS_GLSL
#define LOBELIA_SPHERE_PARAMS_GLSL

// `direction` of the ray through the image's centre and its change per pixel to the right and down;
// its `moment`, eye x direction, and that one's changes; the sphere's centre as seen from the eye.
struct SphereParams {
    vec4 direction;       // w: red of kd
    vec4 direction_per_x; // w: green of kd
    vec4 direction_per_y; // w: blue of kd
    vec4 moment;          // w: red of ks
    vec4 moment_per_x;    // w: green of ks
    vec4 moment_per_y;    // w: blue of ks
    vec4 centre;          // w: distance from the eye to the silhouette
    float exponent;
    uint width; // of the image, pixels
    uint height;
    uint background; // 0: none is drawn
};

#endif
