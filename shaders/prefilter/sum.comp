// Adds up the partial sums of project.comp, into the first chunk's place.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "prefilter/harmonics.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) buffer Partials { Term partials[]; };

layout(push_constant) uniform Params { uint chunks; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(TERMS)) return;
    vec3 real = vec3(0.0);
    vec3 imaginary = vec3(0.0);
    for (uint chunk = 0u; chunk < chunks; ++chunk) {
        Term partial = partials[chunk * uint(TERMS) + index];
        real += partial.real.rgb;
        imaginary += partial.imaginary.rgb;
    }
    partials[index].real.rgb = real;
    partials[index].imaginary.rgb = imaginary;
}
