// What a fragment of a mesh is made of: material factors times textures. Defines choose what is sampled at
// all:
//   DETAIL    0: base colour only, 1: also metalness-roughness and occlusion textures, 2: also normals, 3: also heights
//             (offset-limited parallax), 4: heights with parallax occlusion
//   EMISSION  1: emissive texture
//   SPECULAR  1: textures of a dielectric's reflection
//   TRANSMISSION  1: how much light goes through
//   LIGHT_MAP  1: baked light
#include "frame.glsl"
#include "scene_buffers.glsl"
#include "colour.glsl"
#include "tangent_space.glsl"
#include "to_eye.glsl"

#define VARYING in
#include "mesh_varyings.glsl"

layout(binding = UNIT_BASE_COLOUR) uniform sampler2D base_colour_texture;
layout(binding = UNIT_METALNESS_ROUGHNESS) uniform sampler2D metalness_roughness_texture;
layout(binding = UNIT_NORMAL) uniform sampler2D normal_texture;
layout(binding = UNIT_OCCLUSION) uniform sampler2D occlusion_texture;
layout(binding = UNIT_EMISSIVE) uniform sampler2D emissive_texture;
layout(binding = UNIT_SPECULAR) uniform sampler2D specular_texture;
layout(binding = UNIT_SPECULAR_COLOUR) uniform sampler2D specular_colour_texture;
#if TRANSMISSION
layout(binding = UNIT_TRANSMISSION) uniform sampler2D transmission_texture;
#endif
#if LIGHT_MAP
layout(binding = UNIT_LIGHT_MAP) uniform sampler2D light_map_texture;
#endif
#if DETAIL >= 3
layout(binding = UNIT_HEIGHT) uniform sampler2D height_texture;
#endif

#if DETAIL >= 3
/// Of texture coordinates before their transform. See look_into_relief().
vec2 relief_shift = vec2(0.0);

/// Samples where the eye looks, with the footprint of the pixel on the surface without heights: shifts jump where one
/// thing hides another.
vec4 sample_texture(sampler2D source, vec2 uv, UvTransform t, UvTransform height) {
    vec2 shift = vec2(dot(t.row0.xy, relief_shift), dot(t.row1.xy, relief_shift));
    return textureGrad(source, t.row0.w == height.row0.w ? uv + shift : uv, dFdx(uv), dFdy(uv));
}
#define SAMPLE(source, name) sample_texture(source, varyings.name, m.name, m.height_uv)
#else
#define SAMPLE(source, name) texture(source, varyings.name)
#endif

vec4 sample_base_colour(Material m) {
    return m.base_colour * varyings.colour * SAMPLE(base_colour_texture, base_colour_uv);
}

/// Unit normal on the side that is seen. One that a singular transform has swallowed faces the eye.
vec3 interpolated_normal() {
    float length2 = dot(varyings.normal, varyings.normal);
    vec3 towards_eye = frame.world_from_view[2].xyz;
    vec3 normal = length2 > 1e-12 ? varyings.normal * inversesqrt(length2) : towards_eye;
    return gl_FrontFacing ? normal : -normal;
}

#if DETAIL >= 2
/// In tangent space. Two-channel textures leave z out: normals are of unit length and point outwards.
vec3 sample_normal(Material m) {
    vec3 t = SAMPLE(normal_texture, normal_uv).xyz * 2.0 - 1.0;
    if ((m.flags & k_material_normal_z_is_missing) != 0u) t.z = sqrt(max(0.0, 1.0 - dot(t.xy, t.xy)));
    return t;
}

#endif

/// glTF 2.0, 3.9.3: the texture's xy scaled, then rotated into the frame (T, B = w·(N×T), N). The frame of a
/// back face turns with its normal. Degenerate tangents leave the normal as it is.
TangentSpace tangent_space(Material m, vec3 normal) {
    TangentSpace flat_space = TangentSpace(vec3(0.0), vec3(0.0, 0.0, 1.0));
#if DETAIL >= 2
    vec3 t = sample_normal(m);  // outside any branch: its texture needs derivatives
    t.xy *= m.normal_scale;
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 across = varyings.tangent.xyz - normal * dot(normal, varyings.tangent.xyz);
    float length2 = dot(across, across);
    float t_length2 = dot(t, t);
    bool mapped = (m.flags & k_material_has_normal_texture) != 0u && length2 >= 1e-12 && t_length2 > 1e-12;
    if (!mapped) return flat_space;
    t *= inversesqrt(t_length2);
    return TangentSpace(side * across * inversesqrt(length2), vec3(t.x, side * varyings.tangent.w * t.y, t.z));
#else
    return flat_space;
#endif
}

#if DETAIL >= 3
float relief_level;  ///< of detail of the heights, for loops in which derivatives are undefined

float relief_depth(vec2 uv) {
    return 1.0 - textureLod(height_texture, uv, relief_level).r;
}
#include "relief.glsl"

/// Finds where textures are sampled from now on. From behind, heights would be holes: there, and without tangents, nothing
/// shifts.
void look_into_relief(Material m) {
    relief_level = textureQueryLod(height_texture, varyings.height_uv).y;
    float height = texture(height_texture, varyings.height_uv).r;
    vec3 normal = interpolated_normal();
    vec3 across = varyings.tangent.xyz - normal * dot(normal, varyings.tangent.xyz);
    float length2 = dot(across, across);
    if (!gl_FrontFacing || length2 < 1e-12) return;
    vec3 tangent = across * inversesqrt(length2);
    vec3 eye = direction_to_eye(varyings.position);
    vec3 to_eye = vec3(dot(eye, tangent), varyings.tangent.w * dot(eye, cross(normal, tangent)), dot(eye, normal));
#if DETAIL == 3
    relief_shift = limited_shift(to_eye, m.height_depth * (1.0 - height));
#else
    vec2 shift = deepest_shift(to_eye, m.height_depth);
    vec2 texel_shift = vec2(dot(m.height_uv.row0.xy, shift), dot(m.height_uv.row1.xy, shift));
    relief_shift = shift * relief_entry(varyings.height_uv, texel_shift, int(frame.counts.w));
#endif
}
#else
void look_into_relief(Material m) {}
#endif

/// The interpolated normal, or the normal texture's where there is one.
vec3 surface_normal(Material m) {
    vec3 normal = interpolated_normal();
    return normalize(tilted_normal(tangent_space(m, normal), normal));
}

/// Roughness, metalness, occlusion.
vec3 sample_surface(Material m) {
    vec3 surface = vec3(m.roughness, m.metalness, 1.0);
#if DETAIL
    surface.xy *= SAMPLE(metalness_roughness_texture, metalness_roughness_uv).gb;
    surface.z = mix(1.0, SAMPLE(occlusion_texture, occlusion_uv).r, m.occlusion_strength);
#endif
    return surface;
}

/// Radiance of its own.
vec3 sample_emission(Material m) {
    vec3 emission = m.emissive_cutoff.rgb;
#if EMISSION
    emission *= SAMPLE(emissive_texture, emissive_uv).rgb;
#endif
    return emission;
}

/// KHR_materials_specular: what a dielectric reflects at normal incidence, as grey of the same luminance.
float sample_dielectric_f0(Material m) {
#if SPECULAR
    vec3 f0 = min(m.specular.rgb * SAMPLE(specular_colour_texture, specular_colour_uv).rgb, 1.0);
    return luminance(f0) * m.specular.a * SAMPLE(specular_texture, specular_uv).a;
#else
    return m.dielectric_f0;
#endif
}

#if TRANSMISSION
/// KHR_materials_transmission: of the light that a dielectric does not reflect, the share that goes through instead of
/// being scattered.
float sample_transmission(Material m) {
    return m.transmission.x * SAMPLE(transmission_texture, transmission_uv).r;
}
#endif

#if LIGHT_MAP
/// Radiance that a white Lambert surface would send because of baked light.
vec3 sample_light_map(Material m) {
    const float most = 65504.0;  // finite, or black surfaces would make no number of it
    return min(m.transmission.y * SAMPLE(light_map_texture, light_map_uv).rgb, vec3(most));
}
#endif
