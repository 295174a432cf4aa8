#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/albedo.glsl"
#include "lobelia/cube.glsl"
#include "lobelia/lobe.glsl"
#include "lobelia/panorama.glsl"
#include "lobelia/sphere.glsl"

// The shared functions, each for one argument of four numbers.
layout(local_size_x = 64) in;

layout(push_constant) uniform Params {
    SphereParams sphere; // for what looks at the sphere
};
layout(set = 0, binding = 0, std430) readonly buffer Arguments { vec4 arguments[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Values { vec4 values[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(arguments.length())) return;
    vec4 x = arguments[i];
    uint face = i % CUBE_FACES;
    vec3 direction = cube_direction(face, 2.0 * x.x - 1.0, 2.0 * x.y - 1.0);
    CubePoint point = cube_point(direction);
    PanoramaPoint place = panorama_point(direction);
    ImageRay ray = image_ray(sphere, 80.0 * (x.x - 0.5), 60.0 * (x.y - 0.5));
    SurfacePoint surface = surface_point(sphere, ray);
    values[8u * i + 0u] = vec4(chord_power(2.0 * x.x * x.x, x.w), phong_albedo(x.y, x.w),
                               lobe_density(Lobe(LOBE_PHONG, x.w), x.z),
                               lobe_sample_chord(Lobe(LOBE_PHONG, x.w), x.x));
    values[8u * i + 1u] = vec4(direction, float(point.face));
    values[8u * i + 2u] = vec4(point.u, point.v, place.u, place.v);
    values[8u * i + 3u] = vec4(panorama_direction(x.x, x.y), 0.0);
    values[8u * i + 4u] = vec4(cube_texel_solid_angle(i % 16u, i / 16u % 16u, 16u),
                               sphere_coverage(sphere, ray), surface.cos_view, 0.0);
    values[8u * i + 5u] = vec4(surface.normal, 0.0);
    values[8u * i + 6u] = vec4(surface.mirror, 0.0);
    values[8u * i + 7u] = vec4(ray.direction, length(ray.moment));
}
