// What a fragment of a mesh is made of: material factors times textures. Defines choose what is sampled at all:
//   DETAIL    1: normal, metalness-roughness and occlusion textures, 0: base colour only
//   EMISSION  1: emissive texture
#include "frame.glsl"
#include "scene_buffers.glsl"

in MeshVaryings {
    vec3 position;
    vec3 normal;
    vec4 tangent;
    vec2 uv0;
    vec2 uv1;
    vec4 colour;
    flat uint material;
} fragment;

layout(binding = UNIT_BASE_COLOUR) uniform sampler2D base_colour_texture;
layout(binding = UNIT_METALNESS_ROUGHNESS) uniform sampler2D metalness_roughness_texture;
layout(binding = UNIT_NORMAL) uniform sampler2D normal_texture;
layout(binding = UNIT_OCCLUSION) uniform sampler2D occlusion_texture;
layout(binding = UNIT_EMISSIVE) uniform sampler2D emissive_texture;

vec4 sample_base_colour(Material m) {
    vec2 uv = transformed_uv(m.base_colour_uv, fragment.uv0, fragment.uv1);
    return m.base_colour * fragment.colour * texture(base_colour_texture, uv);
}

/// Unit normal on the side that is seen. Lines and points without normals face the eye.
vec3 interpolated_normal() {
    float length2 = dot(fragment.normal, fragment.normal);
    vec3 towards_eye = frame.world_from_view[2].xyz;
    vec3 normal = length2 > 1e-12 ? fragment.normal * inversesqrt(length2) : towards_eye;
    return gl_FrontFacing ? normal : -normal;
}

/// glTF 2.0, 3.9.3: the texture's xy scaled, then rotated into the frame (T, B = w·(N×T), N). The frame of a
/// back face turns with its normal. Degenerate tangents leave the normal as it is.
vec3 mapped_normal(Material m, vec3 normal) {
    vec2 uv = transformed_uv(m.normal_uv, fragment.uv0, fragment.uv1);
    vec3 t = texture(normal_texture, uv).xyz * 2.0 - 1.0;
    t.xy *= m.normal_scale;
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 across = fragment.tangent.xyz - normal * dot(normal, fragment.tangent.xyz);
    float length2 = dot(across, across);
    if (length2 < 1e-12) return normal;
    vec3 tangent = side * across * inversesqrt(length2);
    vec3 bitangent = side * fragment.tangent.w * cross(normal, tangent);
    vec3 mapped = tangent * t.x + bitangent * t.y + normal * t.z;
    float mapped_length2 = dot(mapped, mapped);
    return mapped_length2 > 1e-12 ? mapped * inversesqrt(mapped_length2) : normal;
}

/// Roughness, metalness, occlusion.
vec3 sample_surface(Material m) {
    vec3 surface = vec3(m.roughness, m.metalness, 1.0);
#if DETAIL
    vec2 uv = transformed_uv(m.metalness_roughness_uv, fragment.uv0, fragment.uv1);
    surface.xy *= texture(metalness_roughness_texture, uv).gb;
    vec2 occlusion_uv = transformed_uv(m.occlusion_uv, fragment.uv0, fragment.uv1);
    surface.z = mix(1.0, texture(occlusion_texture, occlusion_uv).r, m.occlusion_strength);
#endif
    return surface;
}

/// Radiance of its own.
vec3 sample_emission(Material m) {
    vec3 emission = m.emissive_cutoff.rgb;
#if EMISSION
    emission *= texture(emissive_texture, transformed_uv(m.emissive_uv, fragment.uv0, fragment.uv1)).rgb;
#endif
    return emission;
}
