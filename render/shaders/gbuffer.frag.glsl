// Defines: ALPHA_MASK, and those of material.glsl.
#include "material.glsl"
#include "gbuffer_layout.glsl"

layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec2 out_normal;
layout(location = 2) out vec4 out_surface;
#if EMISSION
layout(location = 3) out vec3 out_emission;
#endif

void main() {
    Material m = materials[varyings.material];
    vec4 base = sample_base_colour(m);
#if ALPHA_MASK
    if (base.a < m.emissive_cutoff.a) discard;
#endif
    vec3 normal = surface_normal(m);
    bool unlit = (m.flags & k_material_unlit) != 0u;
    vec3 surface = sample_surface(m);
    out_albedo = vec4(unlit ? vec3(0.0) : stored_albedo(base.rgb), unlit ? k_unlit : stored_reflectance(sample_dielectric_f0(m)));
    out_normal = stored_normal(normal);
    out_surface = vec4(surface, 0.0);
#if EMISSION
    // The format knows neither sign nor overflow.
    out_emission = clamp(unlit ? base.rgb : sample_emission(m), vec3(0.0), vec3(k_max_emission));
#endif
}
