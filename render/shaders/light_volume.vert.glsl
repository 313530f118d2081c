// One quad per light over its rectangle on the screen, as a strip of vertices 0…3, at the depth where the
// light ends: a depth test keeps the pixels before it, and no sky. Define NEAR_SIDE: 1 puts it where the light begins.
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/light_rectangle.h"

layout(std430, binding = BINDING_PASS_STORAGE) readonly buffer LightRectangleBlock {
    LightRectangle rectangles[];
};

flat out uint light_index;

void main() {
    LightRectangle rectangle = rectangles[gl_BaseInstanceARB + gl_InstanceID];
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
#if NEAR_SIDE
    float depth = rectangle.near_depth;
#else
    float depth = rectangle.depth;
#endif
    gl_Position = vec4(mix(rectangle.ndc.xy, rectangle.ndc.zw, corner), depth, 1.0);
    light_index = rectangle.light;
}
