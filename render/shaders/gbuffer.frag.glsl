// Defines: ALPHA_MASK, GBUFFER_WIDE, and those of material.glsl.
#include "material.glsl"
#include "gbuffer_layout.glsl"

layout(location = 0) out vec4 out_albedo;
#if GBUFFER_WIDE
layout(location = 1) out vec4 out_normal;
layout(location = 4) out vec4 out_position;
layout(location = 5) out vec4 out_tangent;
#else
layout(location = 1) out vec2 out_normal;
#endif
layout(location = 2) out vec4 out_surface;
#if EMISSION
layout(location = 3) out vec3 out_emission;
#endif

void main() {
    Material m = materials[varyings.material];
    look_into_relief(m);
    vec4 base = sample_base_colour(m);
#if ALPHA_MASK
    if (base.a < m.emissive_cutoff.a) discard;
#endif
    bool unlit = (m.flags & k_material_unlit) != 0u;
    vec3 surface = sample_surface(m);
    vec3 albedo = unlit ? vec3(0.0) : base.rgb;
    float reflectance = unlit ? k_unlit : stored_reflectance(sample_dielectric_f0(m));
#if GBUFFER_WIDE
    vec3 normal = interpolated_normal();
    TangentSpace space = tangent_space(m, normal);
    out_albedo = vec4(albedo, space.map.x);
    out_normal = vec4(normal, space.map.z);
    out_position = vec4(storable_position(varyings.position), reflectance);
    out_tangent = vec4(space.tangent, space.map.y);
#else
    out_albedo = vec4(stored_albedo(albedo), reflectance);
    out_normal = stored_normal(surface_normal(m));
#endif
    out_surface = vec4(surface, 0.0);
#if EMISSION
    vec3 emission = sample_emission(m);
#if LIGHT_MAP
    emission += kept_diffuse(base.rgb, surface.y) * sample_light_map(m);
#endif
    // The format knows neither sign nor overflow.
    out_emission = clamp(unlit ? base.rgb : emission, vec3(0.0), vec3(k_max_emission));
#endif
}
