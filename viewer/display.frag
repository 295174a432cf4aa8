// What the window shows of pictures in linear radiance: exposed, tone-mapped and sRGB, two of them
// side by side, or how far they are from the reference as false colour.
#version 450
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const uint SPLIT = 0;  // 1: a second picture, beside the first
layout(constant_id = 1) const uint ERRORS = 0; // 1: false colour in place of the pictures
// Bits 0 and 1: in place of the first, second picture the reference where known.
layout(constant_id = 2) const uint EXACT = 0;
layout(constant_id = 3) const uint ENCODE = 1; // 1: write sRGB values

layout(push_constant) uniform Params {
    float scale;   // of radiance, by the exposure
    float divider; // pixels from the left: the second picture begins there
    float dark;    // radiance that errors of black count against
    uint width;    // of the pictures
};

layout(set = 0, binding = 0) uniform sampler2D first;
layout(set = 0, binding = 1) uniform sampler2D second;
layout(set = 0, binding = 2) uniform sampler2D reference;
layout(set = 0, binding = 3) readonly buffer Known { uint known[]; }; // pixels of the reference

layout(location = 0) out vec4 colour;

#define STOP vec3
const vec3 FALSE_COLOURS[] = vec3[](
#include "false_colours.inc"
);
const int COARSEST = 16; // pixels, of host::ProgressiveReference

// Khronos 2024, "PBR Neutral Tone Mapping" specification; as lobelia::host writes PNG.
vec3 tone_mapped(vec3 radiance) {
    vec3 c = clamp(radiance, vec3(0.0), vec3(1e30));
    float x = min(c.r, min(c.g, c.b));
    c -= x <= 0.08 ? x - x * x / 0.16 : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak <= 0.76) return c;
    float new_peak = 1.0 - 0.0576 / (peak + 0.24 - 0.76);
    float grey = 1.0 - 1.0 / (0.15 * (peak - new_peak) + 1.0);
    return mix(c * (new_peak / peak), vec3(new_peak), grey);
}

vec3 srgb(vec3 linear) {
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear,
               lessThanEqual(linear, vec3(0.0031308)));
}
vec3 linear_of(vec3 encoded) {
    return mix(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92,
               lessThanEqual(encoded, vec3(0.04045)));
}

// The nearest pixel above and to the left whose reference is known; x < 0: there is none yet.
ivec2 known_pixel(ivec2 pixel) {
    for (int step = 1; step <= COARSEST; step *= 2) {
        ivec2 corner = pixel / step * step;
        if (known[corner.y * int(width) + corner.x] != 0u) return corner;
    }
    return ivec2(-1);
}

vec3 false_colour(float error) {
    const int LAST = FALSE_COLOURS.length() - 1;
    float place = clamp(1.0 + log(max(error, 1e-9)) / log(1e4), 0.0, 1.0) * float(LAST);
    int stop = min(int(place), LAST - 1);
    return mix(FALSE_COLOURS[stop], FALSE_COLOURS[stop + 1], place - float(stop));
}

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy), textureSize(first, 0) - 1); // after a failed resize
    bool on_left = SPLIT == 0u || gl_FragCoord.x < divider;
    bool is_exact = (EXACT & (on_left ? 1u : 2u)) != 0u;
    vec4 shown = on_left ? texelFetch(first, pixel, 0) : texelFetch(second, min(pixel, textureSize(second, 0) - 1), 0);
    ivec2 at = ivec2(-1);
    vec3 truth = vec3(0.0);
    if ((EXACT | ERRORS) != 0u && shown.a > 0.5 && (is_exact || ERRORS != 0u)) at = known_pixel(pixel);
    if (at.x >= 0) truth = texelFetch(reference, at, 0).rgb;
    vec3 encoded;
    if (ERRORS == 0u) {
        if (is_exact && at.x >= 0) shown.rgb = truth;
        vec3 mapped = tone_mapped(scale * shown.rgb);
        colour = vec4(ENCODE != 0u ? srgb(mapped) : mapped, 1.0);
        return;
    }
    if (at.x < 0) {
        encoded = vec3(shown.a > 0.5 ? 0.16 : 0.09);
    } else {
        vec3 value = on_left ? texelFetch(first, at, 0).rgb : texelFetch(second, at, 0).rgb;
        vec3 error = is_exact ? vec3(0.0) : abs(value - truth) / (truth + dark);
        encoded = false_colour(max(error.r, max(error.g, error.b)));
    }
    colour = vec4(ENCODE != 0u ? encoded : linear_of(encoded), 1.0);
}
