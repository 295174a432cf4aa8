// The environment itself.
#version 450

layout(set = 0, binding = 0) uniform samplerCube environment;
layout(location = 0) in vec3 along;
layout(location = 0) out vec4 colour;

void main() { colour = textureLod(environment, along, 0.0); }
