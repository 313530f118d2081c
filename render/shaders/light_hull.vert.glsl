// One hull per light: a mesh whose vertices are shares of the hull's axes.
#include "render/shaders/shared/light_hull.h"
#include "frame.glsl"

layout(std430, binding = BINDING_PASS_STORAGE) readonly buffer LightHullBlock {
    LightHull hulls[];
};

layout(location = ATTRIBUTE_POSITION) in vec4 in_shares;

flat out uint light_index;

void main() {
    LightHull hull = hulls[gl_BaseInstanceARB + gl_InstanceID];
    gl_Position = frame.clip_from_world * (hull.origin + hull.axes * in_shares);
    light_index = hull.light;
}
