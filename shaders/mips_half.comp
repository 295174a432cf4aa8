// Mips in R16G16B16A16_SFLOAT.
#version 450
#extension GL_GOOGLE_include_directive : require

#define TARGET_FORMAT rgba16f
#define ROUNDED(value) nearest_half(value)
#include "mips.glsl"
