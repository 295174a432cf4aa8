// Shades what is no sphere: a torus by ray marching, whose material changes along the ring. An engine
// does the same with the normals, the reflectances and the exponents of its own geometry buffer.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/suns.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

struct Surface {
    vec3 normal;
    float exponent; // 0 where there is nothing
    vec3 view;      // towards the eye
    vec3 diffuse;
    vec3 specular;
};

layout(set = 0, binding = 0) uniform samplerCube diffuse_map;
layout(set = 0, binding = 1) uniform sampler2DArray ladder;
layout(set = 0, binding = 2) uniform sampler2DArray tables;
layout(set = 0, binding = 3, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 4, std430) writeonly buffer Picture { vec4 picture[]; };
layout(set = 0, binding = 5, std430) writeonly buffer Surfaces { Surface surfaces[]; };

#define PREFILTER_STATE state
#include "lobelia/taps.glsl"

layout(push_constant) uniform Params { uvec2 size; };

const float RING = 1.0; // around the y axis
const float TUBE = 0.45;
const vec3 EYE = vec3(0.0, 2.4, 2.4); // looks at the origin, 45 degrees down
const float HALF_HEIGHT = 0.4;        // of the picture, at distance 1

float torus_distance(vec3 p) { return length(vec2(length(p.xz) - RING, p.y)) - TUBE; }

Surface surface_at(vec3 p, vec3 along) {
    vec2 ring = normalize(p.xz);
    float side = 0.5 + 0.5 * ring.x;
    Surface surface;
    surface.normal = normalize(p - RING * vec3(ring.x, 0.0, ring.y));
    surface.view = -along;
    surface.exponent = clamp(8.0 * exp2(6.0 * side), 8.0, 512.0);
    surface.diffuse = mix(vec3(0.4, 0.2, 0.1), vec3(0.05, 0.1, 0.3), side);
    surface.specular = mix(vec3(0.2), vec3(0.6, 0.5, 0.3), 0.5 + 0.5 * ring.y);
    return surface;
}

void main() {
    if (any(greaterThanEqual(gl_GlobalInvocationID.xy, size))) return;
    vec2 middle = 2.0 * vec2(gl_GlobalInvocationID.xy) + 1.0 - vec2(size);
    vec2 at = HALF_HEIGHT / float(size.y) * middle;
    vec3 along = normalize(vec3(at.x, (-1.0 - at.y) * sqrt(0.5), (at.y - 1.0) * sqrt(0.5)));
    float travelled = 0.0;
    float left = torus_distance(EYE);
    for (int i = 0; i < 128 && left > 1e-4 && travelled < 8.0; ++i) {
        travelled += left;
        left = torus_distance(EYE + travelled * along);
    }
    uint index = gl_GlobalInvocationID.y * size.x + gl_GlobalInvocationID.x;
    Surface surface = surface_at(EYE + travelled * along, along);
    if (left > 1e-4) surface.exponent = 0.0;
    surfaces[index] = surface;
    vec3 radiance = shade(diffuse_map, ladder, tables, surface.diffuse, surface.specular,
                          surface.exponent, surface.normal, surface.view);
    picture[index] = vec4(left > 1e-4 ? vec3(0.0) : radiance, 1.0);
}
