// kurt2019 where the six colours of the faces are known beforehand.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/kurt2019.glsl"
#include "sphere_pass.glsl"

layout(set = 0, binding = 1, std140) uniform Colours { vec4 colours[6]; };

vec3 surface_radiance(SurfacePoint point) {
    Kurt2019Faces faces = Kurt2019Faces(colours[0].rgb, colours[1].rgb, colours[2].rgb,
                                        colours[3].rgb, colours[4].rgb, colours[5].rgb);
    vec3 mirror = kurt2019_weighted(faces, point.mirror);
    vec3 radiance = vec3(0.0);
    if (DIFFUSE)
        radiance += diffuse_colour() * mix(kurt2019_weighted(faces, point.normal), mirror,
                                           kurt2019_gloss(params.exponent));
    if (SPECULAR)
        radiance += specular_colour() * phong_albedo(point.cos_view, params.exponent) * mirror;
    return radiance;
}
