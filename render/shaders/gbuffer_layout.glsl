// The compact G-buffer, written and read in one place.
//   RT0 sRGB8_A8         base colour, surface class
//   RT1 RG16             octahedral normal, world axes
//   RT2 RGBA8            roughness, metalness, occlusion, reflector id (0: none)
//   RT3 R11F_G11F_B10F   radiance of its own; exists only where something emits
#include "octahedral.glsl"

const float k_class_lit = 0.0;
const float k_class_unlit = 1.0;  ///< shows its emission alone

const float k_max_emission = 60000.0;  ///< R11F_G11F_B10F ends at 64512

vec2 stored_normal(vec3 normal) {
    return unorm16_from_octahedral(octahedral_from_unit(normal));
}

vec3 normal_from_stored(vec2 stored) {
    return unit_from_octahedral(octahedral_from_unorm16(stored));
}
