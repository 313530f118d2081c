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
    float lit = sun_through(sun_shadow_map, shadow, position, normal, frame.direction_to_sun.xyz);
    return round(lit * 255.0) / 255.0;
#else
    return 1.0;
#endif
}
