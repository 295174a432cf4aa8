// What the mesh's and the background's shaders are told of the camera.
layout(push_constant) uniform Camera {
    mat4 clip_from_world;
    vec4 eye;
    vec4 right; // half of the picture's width at distance 1
    vec4 down;  // half of its height
    vec4 ahead;
};
