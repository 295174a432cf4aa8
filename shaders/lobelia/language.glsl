// What the shared files need, and their rules. A shared file is GLSL that C++ includes too, so that
// the tests and the shaders run one text:
//   - free functions, plain structs and constants; results in a struct, no out or inout;
//   - `f` on literals, .x .y .z .w and no swizzles, no textures, no discard;
//   - SHARED before each function: `inline` for C++ (the including header defines it, inside
//     namespace lobelia, and undefines it again), nothing for GLSL;
//   - files named in <lobelia/lobe.h> are scalar; the others use vec3, which the tests take from GLM.
#ifndef LOBELIA_LANGUAGE_GLSL
#define LOBELIA_LANGUAGE_GLSL

#ifndef __cplusplus
#define SHARED
#endif

const float PI = 3.14159265358979f;

#endif
