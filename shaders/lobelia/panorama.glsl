// Latitude-longitude panoramas, for C++ and GLSL alike: the image centre is +Z, a quarter of the
// width +X, the top +Y; oriented as OpenEXR's ENVMAP_LATLONG, with samples at texel centres.
#ifndef LOBELIA_PANORAMA_GLSL
#define LOBELIA_PANORAMA_GLSL

#include "lobelia/direction.glsl"

// A point of the image: (0, 0) is its upper left corner, (1, 1) its lower right one.
struct PanoramaPoint {
    float u;
    float v;
};

// The unit vector that a point of the image shows.
SHARED vec3 panorama_direction(float u, float v) {
    float longitude = 0.5f - u;         // turns
    float latitude = 0.5f * (0.5f - v); // turns
    return vec3(sin_turns(longitude) * cos_turns(latitude), sin_turns(latitude),
                cos_turns(longitude) * cos_turns(latitude));
}

// Where the image shows `direction`, of any length but 0. Straight up and down give u = 1/2.
SHARED PanoramaPoint panorama_point(vec3 direction) {
    float longitude = angle_of(direction.x, direction.z);
    float latitude =
        angle_of(direction.y, sqrt(direction.x * direction.x + direction.z * direction.z));
    PanoramaPoint point;
    point.u = 0.5f - longitude / (2.0f * PI);
    point.v = 0.5f - latitude / PI;
    return point;
}

#endif
