// Deferred shadowing: 1 where the sun reaches the pixel's surface. Defines: TAPS, 4 or 16; GBUFFER_WIDE.
#include "gbuffer_read.glsl"
#include "shadow_lookup.glsl"

layout(binding = UNIT_PASS + 4) uniform sampler2DShadow sun_shadow_map;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform SunShadowBlock {
    SunShadow shadow;
};

layout(location = 0) out float out_lit;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    out_lit = sun_through(sun_shadow_map, shadow, world_position(pixel), world_normal(pixel),
                          frame.direction_to_sun.xyz);
}
