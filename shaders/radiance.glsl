// What the passes let into a map: radiance that can be summed, and halves that lose no light.
#ifndef RADIANCE_GLSL
#define RADIANCE_GLSL

float luminance(vec3 radiance) { return dot(radiance, vec3(0.2126, 0.7152, 0.0722)); }

// Radiance as the integration takes it: NaN and negative values are 0, and nothing is above 2^120
// (1.3e36), infinity included, so that no sum of it overflows. Tests bits, since a shader may assume
// that NaN does not occur.
const uint LARGEST_RADIANCE = 0x7b800000u;
float sane(float value) {
    uint bits = floatBitsToUint(value);
    bool negative = (bits & 0x80000000u) != 0u;
    bool nan = (bits & 0x7fffffffu) > 0x7f800000u;
    if (negative || nan) return 0.0;
    return uintBitsToFloat(min(bits, LARGEST_RADIANCE));
}
vec3 sane(vec3 radiance) { return vec3(sane(radiance.r), sane(radiance.g), sane(radiance.b)); }

// Halves of values that are not negative, to the nearest; the largest half is the most.
uvec3 to_halves(vec3 value) {
    value = min(value, vec3(65504.0));
    uvec3 bits = floatBitsToUint(value);
    uvec3 normal = (bits - 0x38000000u + 0x0fffu + ((bits >> 13) & 1u)) >> 13;
    uvec3 denormal = uvec3(value * 16777216.0 + 0.5);
    return mix(normal, denormal, lessThan(value, vec3(6.103515625e-5)));
}

// The nearest half, still as a float. A store to an image may round either way, and one that always
// rounds down loses light: what it is given needs no rounding.
vec3 nearest_half(vec3 value) {
    uvec3 halves = to_halves(value);
    return vec3(unpackHalf2x16(halves.x | (halves.y << 16)), unpackHalf2x16(halves.z).x);
}

#endif
