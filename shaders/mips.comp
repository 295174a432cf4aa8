// Mips in R32G32B32A32_SFLOAT.
#version 450
#extension GL_GOOGLE_include_directive : require

#define TARGET_FORMAT rgba32f
#define ROUNDED(value) (value)
#include "mips.glsl"
