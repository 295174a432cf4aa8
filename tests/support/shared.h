#pragma once

#include <glm/glm.hpp>

#include <lobelia/lobe.h>

// The shaders' own functions as C++, with GLM for their vector types.
namespace lobelia {

using namespace glm;
using lobelia::uint;
using std::abs;

#define SHARED inline
#include "lobelia/cube.glsl"
#include "lobelia/direction.glsl"
#include "lobelia/importance.glsl"
#include "lobelia/panorama.glsl"
#undef SHARED

} // namespace lobelia
