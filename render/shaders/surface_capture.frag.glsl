// Places and normals as lighting finds them. Define GBUFFER_WIDE.
#include "gbuffer_read.glsl"

layout(location = 0) out vec4 out_position;  ///< camera-relative world, m
layout(location = 1) out vec4 out_normal;    ///< world axes

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    out_position = vec4(world_position(pixel), 1.0);
    out_normal = vec4(world_normal(pixel), 0.0);
}
