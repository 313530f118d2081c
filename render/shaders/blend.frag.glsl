// Transparent surfaces, lit as the opaque ones are; premultiplied, so that glass keeps its highlights however
// clear it is. Defines: SHADOW_MAP, TAPS, and those of material.glsl.
#include "material.glsl"
#include "sun_and_sky.glsl"
#include "local_light.glsl"
#include "colour.glsl"
#if SHADOW_MAP
#include "shadow_lookup.glsl"
layout(binding = UNIT_PASS) uniform sampler2DShadow sun_shadow_map;
layout(std140, binding = BINDING_PASS_UNIFORMS) uniform SunShadowBlock {
    SunShadow shadow;
};
#endif

layout(location = 0) out vec4 out_radiance;

float sun_reaches(vec3 normal) {
#if SHADOW_MAP
    vec3 point = shadow_receiver(varyings.position, normal, frame.direction_to_sun.xyz, shadow.bias_m);
    vec3 place = (shadow.map_from_world * vec4(point, 1.0)).xyz;
#if TAPS == 16
    float lit = shadow_pcf_16(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#else
    float lit = shadow_pcf_4(sun_shadow_map, place.xy, place.z, shadow.size_texels);
#endif
    return shadow_fade(lit, length(varyings.position), shadow.fade);
#else
    return 1.0;
#endif
}

void main() {
    Material m = materials[varyings.material];
    vec4 base = sample_base_colour(m);
    vec3 normal = interpolated_normal();
#if DETAIL
    vec3 mapped = mapped_normal(m, normal);  // outside any branch: its texture needs derivatives
    normal = (m.flags & k_material_has_normal_texture) != 0u ? mapped : normal;
#endif
    vec3 surface_values = sample_surface(m);
    Surface s = make_surface(normal, base.rgb, surface_values.x, surface_values.y, surface_values.z);
    float length2 = dot(varyings.position, varyings.position);
    bool orthographic = frame.counts.y != 0u;
    vec3 to_eye = orthographic || length2 < 1e-20 ? frame.world_from_view[2].xyz
                                                  : -varyings.position * inversesqrt(length2);

    vec3 radiance = sky_light(s, to_eye) + sun_light(s, to_eye, sun_reaches(normal));
    for (uint i = 0u; i < frame.counts.x; ++i) {
        radiance += local_light(lights[i], s, varyings.position, to_eye);
    }
    radiance += sample_emission(m);
    bool unlit = (m.flags & k_material_unlit) != 0u;
    radiance = unlit ? base.rgb : radiance;
    float alpha = clamp(base.a, 0.0, 1.0);
    out_radiance = vec4(storable_radiance(radiance * (alpha * frame.exposure.x)), alpha);
}
