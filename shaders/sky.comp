#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/panorama.glsl"

// The built-in environment, from formulas. World: +Y up.

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform Params {
    uint width;
    uint height;
};
layout(set = 0, binding = 0, rgba32f) uniform writeonly image2D panorama;

const int SAMPLES = 4; // a side of a texel

const vec3 SUN_DIRECTION = normalize(vec3(-0.62, 0.58, 0.53));
const vec3 SUN_COLOUR = vec3(1.0, 0.84, 0.62);
const float SUN_RADIUS = 0.012;     // radians: 4 texels across of 1024
const float SUN_IRRADIANCE = 4.0;   // across its rays
const float FLOOR_HEIGHT = -1.2;    // below the middle of the world
const float TILE = 0.8;             // edge of a floor tile

// A rectangle of light: what is seen within `half_size` of the middle, in units of the distance.
vec3 soft_box(vec3 direction, vec3 facing, vec2 half_size, float softness, vec3 radiance) {
    vec3 right = normalize(cross(facing, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, facing);
    float depth = dot(direction, facing);
    if (depth <= 0.01) return vec3(0.0);
    vec2 beyond = abs(vec2(dot(direction, right), dot(direction, up)) / depth) - half_size;
    vec2 inside = 1.0 - smoothstep(-softness, softness, beyond);
    return radiance * inside.x * inside.y;
}

vec3 sky(vec3 direction) {
    float height_above = max(direction.y, 0.0);
    vec3 horizon = vec3(0.80, 0.62, 0.50);
    vec3 middle = vec3(0.30, 0.42, 0.62);
    vec3 zenith = vec3(0.07, 0.14, 0.34);
    vec3 colour = mix(horizon, middle, smoothstep(0.0, 0.28, height_above));
    colour = mix(colour, zenith, smoothstep(0.15, 1.0, height_above));
    float towards_sun = max(dot(direction, SUN_DIRECTION), 0.0);
    float glow = 0.5 * pow(towards_sun, 8.0) + 1.5 * pow(towards_sun, 90.0);
    return colour + SUN_COLOUR * glow;
}

// A tiled floor, which fades to haze before the tiles become smaller than texels.
vec3 ground(vec3 direction) {
    float slope = max(-direction.y, 1e-4);
    vec2 place = direction.xz / slope * -FLOOR_HEIGHT;
    vec2 wave = sin(PI / TILE * place);
    float nearness = smoothstep(0.06, 0.45, slope);
    float tile = smoothstep(-0.15, 0.15, wave.x * wave.y);
    vec3 stone = mix(vec3(0.10, 0.095, 0.09), vec3(0.30, 0.27, 0.23), mix(0.5, tile, nearness));
    vec3 haze = vec3(0.52, 0.42, 0.36);
    return mix(haze, stone, smoothstep(0.0, 0.22, slope));
}

vec3 radiance(vec3 direction, float spacing) {
    vec3 colour = mix(ground(direction), sky(direction), smoothstep(-0.006, 0.006, direction.y));
    colour += soft_box(direction, normalize(vec3(1.0, 0.55, 0.45)), vec2(0.42, 0.26), 0.03,
                       vec3(7.0, 6.2, 5.2)); // warm, to the right
    colour += soft_box(direction, normalize(vec3(-1.0, 0.25, -0.55)), vec2(0.13, 0.55), 0.02,
                       vec3(2.2, 3.4, 5.0)); // a cool strip, behind on the left
    colour += soft_box(direction, normalize(vec3(0.8, 0.10, -0.9)), vec2(0.12, 0.08), 0.02,
                       vec3(5.0, 1.4, 0.5)); // a small red lamp, behind on the right

    // A smooth disc, (1 - t)^2 over t = (1 - cos) / edge, whose integral is known; never narrower
    // than the samples can see.
    float radius = max(SUN_RADIUS, 3.0 * spacing);
    float edge = 0.5 * radius * radius;
    float t = half_square_distance(direction, SUN_DIRECTION) / edge;
    float disc = max(1.0 - t, 0.0);
    return colour + SUN_COLOUR * disc * disc * SUN_IRRADIANCE * 3.0 / (2.0 * PI * edge);
}

void main() {
    uvec2 id = gl_GlobalInvocationID.xy;
    if (id.x >= width || id.y >= height) return;
    float spacing = PI / float(SAMPLES) * max(2.0 / float(width), 1.0 / float(height));

    vec3 light = vec3(0.0);
    float area = 0.0; // a row's share of the texel's solid angle
    for (int y = 0; y < SAMPLES; ++y) {
        float v = (float(id.y) + (float(y) + 0.5) / float(SAMPLES)) / float(height);
        float row_area = cos_turns(0.5 * (0.5 - v));
        area += float(SAMPLES) * row_area;
        for (int x = 0; x < SAMPLES; ++x) {
            float u = (float(id.x) + (float(x) + 0.5) / float(SAMPLES)) / float(width);
            light += row_area * radiance(panorama_direction(u, v), spacing);
        }
    }
    imageStore(panorama, ivec2(id), vec4(light / area, 1.0));
}
