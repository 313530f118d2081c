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
    vec3 position = world_position(pixel);
    vec3 normal = world_normal(pixel);
    vec3 to_sun = frame.direction_to_sun.xyz;
    vec3 point = shadow_receiver(position, normal, to_sun, shadow.bias_m);
    vec3 place = (shadow.map_from_world * vec4(point, 1.0)).xyz;
#if TAPS == 16
    float lit = shadow_pcf_16(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#else
    float lit = shadow_pcf_4(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#endif
    out_lit = dot(normal, to_sun) > 0.0 ? shadow_fade(lit, length(position), shadow.fade) : 0.0;
}
