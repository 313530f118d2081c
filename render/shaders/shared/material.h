// A material as shaders read it: factors, flags and texture transforms of assets::Material. Textures are
// bound per material; absent ones are neutral (white, flat normal), so shaders always multiply and never
// branch.
#ifndef RAMBLA_SHARED_MATERIAL_H
#define RAMBLA_SHARED_MATERIAL_H

#include "render/shaders/shared/types.h"

SHARED_BEGIN

SHARED_CONSTANT k_material_unlit = 1u;
SHARED_CONSTANT k_material_double_sided = 2u;
SHARED_CONSTANT k_material_has_normal_texture = 4u;
SHARED_CONSTANT k_material_normal_z_is_missing = 8u;

SHARED_CONSTANT k_alpha_blend = 2u;  // of assets::AlphaMode

// uv' = (dot(row0.xy, uv) + row0.z, dot(row1.xy, uv) + row1.z)
struct UvTransform {
    vec4 row0;  // w: uv set, 0 or 1
    vec4 row1;  // w: padding
};

struct Material {
    vec4 base_colour;
    vec4 emissive_cutoff;  // rgb radiance, a: alpha below which a masked material is cut away
    float metalness;
    float roughness;
    float normal_scale;
    float occlusion_strength;
    uint flags;           // k_material_…
    uint alpha_mode;      // assets::AlphaMode
    float dielectric_f0;  // what it reflects at normal incidence where it is no metal and has no specular
                          // textures
    float height_depth;   // assets::Material::height_depth; 0 without a texture of heights
    vec4 specular;        // rgb reflectance at normal incidence, may exceed 1 before textures; a: strength
    UvTransform base_colour_uv;
    UvTransform metalness_roughness_uv;
    UvTransform normal_uv;
    UvTransform occlusion_uv;
    UvTransform emissive_uv;
    UvTransform specular_uv;
    UvTransform specular_colour_uv;
    UvTransform height_uv;
    UvTransform transmission_uv;
    UvTransform light_map_uv;
    vec4 transmission;  // x: share of a dielectric's light that goes through; y: factor of the light map; z:
                        // optical depth of a ball of haze through its middle; w: padding
};
SHARED_END

#ifdef __cplusplus
static_assert(sizeof(rambla::render::shared::Material) == 416);
#endif
#endif
