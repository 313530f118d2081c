// Sunlight for surfaces that are lit as they are drawn. Defines: SHADOW_MAP, TAPS.
#if SHADOW_MAP
#include "shadow_lookup.glsl"
layout(binding = UNIT_BESIDE_MATERIALS) uniform sampler2DShadow sun_shadow_map;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform SunShadowBlock {
    SunShadow shadow;
};
#endif

/// Share of the sun that reaches a point, as the shadow result's byte holds it.
/// @param position  camera-relative world, m
float sun_reaches(vec3 position, vec3 normal) {
#if SHADOW_MAP
    vec3 to_sun = frame.direction_to_sun.xyz;
    vec3 point = shadow_receiver(position, normal, to_sun, shadow.bias_m);
    vec3 place = (shadow.map_from_world * vec4(point, 1.0)).xyz;
#if TAPS == 16
    float lit = shadow_pcf_16(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#else
    float lit = shadow_pcf_4(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#endif
    lit = dot(normal, to_sun) > 0.0 ? shadow_fade(lit, length(position), shadow.fade) : 0.0;
    return round(lit * 255.0) / 255.0;
#else
    return 1.0;
#endif
}
