// P_n at a list of directions by importance sampling, plain or filtered: some samples of each
// direction in a range of the list, added to what earlier dispatches summed.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/importance.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 0) const bool FILTERED = true;

layout(set = 0, binding = 0) uniform samplerCube source;
layout(set = 0, binding = 1, std430) readonly buffer Directions { vec4 directions[]; };
layout(set = 0, binding = 2, std430) buffer Results { vec4 results[]; };

layout(push_constant) uniform Params {
    float exponent;
    float size;        // of the source's faces
    uint samples;      // of each direction
    uint first_sample; // of this dispatch
    uint end_sample;
    uint first_query;
    uint end_query;
};

void main() {
    uint query = first_query + gl_GlobalInvocationID.x;
    if (query >= end_query) return;
    Lobe lobe = Lobe(LOBE_PHONG, exponent);
    LobeFrame frame = lobe_frame(directions[query].xyz);
    float share = 1.0 / float(samples); // on each, so that no sum overflows
    vec3 sum = vec3(0.0);
    for (uint i = first_sample; i < end_sample; ++i) {
        LobeSample look = lobe_sample(lobe, frame, i, samples, size);
        sum += share * textureLod(source, look.direction, FILTERED ? look.level : 0.0).rgb;
    }
    if (first_sample > 0u) sum += results[query].rgb;
    results[query] = vec4(sum, 1.0);
}
