// Surfaces lit as they are drawn, as deferred shading would light what the compact G-buffer keeps of them. Blended ones
// say apart what they send and which share of each colour behind them they let through, so that clear glass keeps its
// highlights and coloured glass colours. Defines: BLENDED, ALPHA_MASK, SHADOW_MAP, TAPS, LOCAL_LIGHTS, BRDF, and those of
// material.glsl.
#include "material.glsl"
#include "gbuffer_layout.glsl"
#include "to_eye.glsl"
#include "sun_and_sky.glsl"
#include "local_lights.glsl"
#include "colour.glsl"
#include "sun_reaches.glsl"

#if BLENDED
layout(location = 0, index = 0) out vec4 out_radiance;
layout(location = 0, index = 1) out vec4 out_passes;  ///< share of what lies behind, in each colour
#else
layout(location = 0) out vec4 out_radiance;
#endif

void main() {
    Material m = materials[varyings.material];
    look_into_relief(m);
    vec4 base = sample_base_colour(m);
#if ALPHA_MASK
    if (base.a < m.emissive_cutoff.a) discard;
#endif
    vec3 normal = surface_normal(m);
    normal = kept_normal(normal);
    vec3 kept = kept_surface(sample_surface(m));
    Surface s = make_surface(normal, kept_albedo(base.rgb), kept.x, kept.y, kept.z,
                             kept_reflectance(sample_dielectric_f0(m)));
    vec3 to_eye = direction_to_eye(varyings.position);
    float distance_m = dot(varyings.position, -frame.world_from_view[2].xyz);
#if TRANSMISSION
    // The transmitted part replaces diffuse reflection below the same Fresnel layer (KHR_materials_transmission).
    float transmission = sample_transmission(m);
    float n_dot_v = clamp(dot(normal, to_eye), k_min_n_dot_v, 1.0);
    vec3 enters = 1.0 - environment_reflectance(s.f0, s.f90, s.roughness, n_dot_v);
    vec3 goes_through = transmission * enters * s.diffuse;
    s.diffuse *= 1.0 - transmission;
#else
    const vec3 goes_through = vec3(0.0);
#endif

    vec3 radiance = sky_light(s, to_eye) + sun_light(s, to_eye, sun_reaches(varyings.position, normal)) +
                    directional_lights(s, to_eye) + local_lights(s, varyings.position, to_eye, distance_m);
    bool unlit = (m.flags & k_material_unlit) != 0u;
    radiance = unlit ? vec3(0.0) : radiance;
#if EMISSION
    vec3 emission = sample_emission(m);
#if LIGHT_MAP
    emission += s.diffuse * sample_light_map(m);
#endif
    radiance += kept_emission(unlit ? base.rgb : emission);
#endif
#if BLENDED
    float alpha = (m.alpha_mode == k_alpha_blend ? clamp(base.a, 0.0, 1.0) : 1.0) * varyings.opacity;
    out_passes = vec4(1.0 - alpha + alpha * goes_through, 1.0 - alpha);
#else
    const float alpha = 1.0;
#endif
    out_radiance = vec4(storable_radiance(radiance * (alpha * frame.exposure.x)), alpha);
}
