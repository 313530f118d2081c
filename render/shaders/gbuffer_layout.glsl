// The G-buffer, written and read in one place. Compact, 12 bytes and depth, with emission 16:
//   RT0 RGBA8            base colour, sRGB-encoded here (hardware's own encoding is slow, and rounds as it likes), root of a dielectric's reflectance (1: unlit)
//   RT1 RG16             octahedral normal, world axes
//   RT2 RGBA8            roughness, metalness, occlusion, reflector id (0: none)
//   RT3 R11F_G11F_B10F   radiance of its own, and what it scatters of baked light; exists only where there is some
// Wide, 36 bytes and depth: four targets of half floats (Fahlen 2005, "Illumination for Real-Time Rendering of Large
// Architectural Environments", table 2.1) and the bytes that its materials do without. The normal map is kept
// beside the normal, and applied when light is.
//   RT0 RGBA16F          base colour, linear, x of the normal map
//   RT1 RGBA16F          normal without the map, world axes, z of the normal map
//   RT2, RT3             as above, but for the id
//   RT4 RGBA16F          position, camera-relative world, root of a dielectric's reflectance (1: unlit)
//   RT5 RGBA16F          tangent, y of the normal map
#include "octahedral.glsl"
#include "colour.glsl"

const float k_unlit = 1.0;       ///< alpha of what shows its emission alone
const float k_most_root = 0.95;  ///< alpha of the most reflecting dielectric: what is above is unlit

const float k_max_emission = 60000.0;  ///< R11F_G11F_B10F ends at 64512

vec3 stored_albedo(vec3 albedo) {
    return encode_srgb(albedo);
}

vec3 albedo_from_stored(vec3 stored) {
    return decode_srgb(stored);
}

/// A byte of the root: the usual 0.04 is 51/255 to the bit.
float stored_reflectance(float dielectric_f0) {
    return min(sqrt(dielectric_f0), k_most_root);
}

float reflectance_from_stored(float stored) {
    return stored * stored;
}

bool is_lit(float stored) {
    return stored < 0.5 * (k_most_root + k_unlit);
}

vec2 stored_normal(vec3 normal) {
    return unorm16_from_octahedral(octahedral_from_unit(normal));
}

vec3 normal_from_stored(vec2 stored) {
    return unit_from_octahedral(octahedral_from_unorm16(stored));
}

/// Half floats end at 65504. What lies farther away is moved towards the eye, so that it is still seen in its direction.
vec3 storable_position(vec3 position) {
    const float most_m = 65504.0;
    vec3 size = abs(position);
    return position * min(1.0, most_m / max(max(size.x, size.y), max(size.z, 1.0)));
}

/// What the targets keep of what is written to them, for surfaces that are shaded without ever being stored: so that
/// they look the same.
vec3 kept_surface(vec3 surface) {
    return round(clamp(surface, 0.0, 1.0) * 255.0) / 255.0;
}

vec3 kept_normal(vec3 normal) {
    return normal_from_stored(round(stored_normal(normal) * 65535.0) / 65535.0);
}

vec3 kept_albedo(vec3 albedo) {
    return albedo_from_stored(round(stored_albedo(albedo) * 255.0) / 255.0);
}

/// Of light from all around, the share that lighting will find to be scattered.
vec3 kept_diffuse(vec3 albedo, float metalness) {
    return kept_albedo(albedo) * (1.0 - kept_surface(vec3(metalness)).x);
}

float kept_reflectance(float dielectric_f0) {
    return reflectance_from_stored(round(stored_reflectance(dielectric_f0) * 255.0) / 255.0);
}

/// Floats with 6 bits of mantissa, of which blue has 5.
vec3 kept_emission(vec3 emission) {
    uvec3 bits = floatBitsToUint(clamp(emission, vec3(0.0), vec3(k_max_emission)));
    const uvec3 dropped = uvec3(17u, 17u, 18u);
    return uintBitsToFloat((bits >> dropped) << dropped);
}
