// What the ways to draw the sphere have in common. A shader that includes this defines
// surface_radiance().
#include "lobelia/sphere.glsl"

layout(constant_id = 0) const bool DIFFUSE = true;
layout(constant_id = 1) const bool SPECULAR = true;
layout(constant_id = 2) const bool BACKGROUND = true;

layout(push_constant) uniform Block { SphereParams params; };
layout(set = 0, binding = 0) uniform samplerCube background;

layout(location = 0) out vec4 colour;

vec3 diffuse_colour() {
    return vec3(params.direction.w, params.direction_per_x.w, params.direction_per_y.w);
}
vec3 specular_colour() {
    return vec3(params.moment.w, params.moment_per_x.w, params.moment_per_y.w);
}

// Radiance from the surface to the eye.
vec3 surface_radiance(SurfacePoint point);

void main() {
    vec2 position = gl_FragCoord.xy - 0.5 * vec2(params.width, params.height);
    ImageRay ray = image_ray(params, position.x, position.y);
    float coverage = sphere_coverage(params, ray);

    vec3 radiance = vec3(0.0);
    if (BACKGROUND && params.background != 0u && coverage < 1.0)
        radiance += (1.0 - coverage) * textureLod(background, ray.direction, 0.0).rgb;
    if ((DIFFUSE || SPECULAR) && coverage > 0.0)
        radiance += coverage * surface_radiance(surface_point(params, ray));
    colour = vec4(radiance, coverage);
}
