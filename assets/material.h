#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace rambla::assets {

/// Index of nothing, in every index of a Scene.
inline constexpr std::uint32_t k_none = 0xffffffffu;

enum class WrapMode : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter : std::uint8_t { nearest, linear };
enum class MipFilter : std::uint8_t { none, nearest, linear };

struct Sampler {
    WrapMode wrap_u = WrapMode::repeat;
    WrapMode wrap_v = WrapMode::repeat;
    Filter magnify = Filter::linear;
    Filter minify = Filter::linear;
    MipFilter mip = MipFilter::linear;

    bool operator==(const Sampler&) const = default;
};

/// How the bytes of an image are read: chosen by use (colours sRGB, everything else linear).
enum class ColourSpace : std::uint8_t { linear, srgb };

struct Texture {
    std::string name;
    std::uint32_t image = k_none;
    ColourSpace colour_space = ColourSpace::linear;
    Sampler sampler;
};

/// A texture as a material uses it: uv' = rotation(angle) · (uv · scale) + offset, as KHR_texture_transform.
struct TextureSlot {
    std::uint32_t texture = k_none;
    std::uint32_t uv_set = 0;  ///< 0 or 1
    glm::vec2 offset{0.0f};
    glm::vec2 scale{1.0f};
    float rotation_rad = 0.0f;
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// Metallic-roughness material of glTF 2.0, section 3.9; colours are linear Rec. 709.
struct Material {
    std::string name;
    glm::vec4 base_colour{1.0f};
    float metalness = 1.0f;
    float roughness = 1.0f;
    float normal_scale = 1.0f;
    float occlusion_strength = 1.0f;
    glm::vec3 emissive{
        0.0f};         ///< radiance, scaled as architecture's 1.0 = white under the noon sun; may exceed 1
    float ior = 1.5f;  ///< index of refraction, ≥ 1; 0: a dielectric that reflects all its specular colour
    float specular = 1.0f;            ///< strength of a dielectric's reflection, [0, 1]
    glm::vec3 specular_colour{1.0f};  ///< of a dielectric's reflection at normal incidence, ≥ 0
    float transmission = 0.0f;        ///< share of the light that is not reflected and goes through, [0, 1]
    /// How far a height of 0 lies below one of 1, in units of texture coordinates before their transform,
    /// which are taken to be as long one way as the other; [0, k_max_height_depth].
    float height_depth = 0.0f;
    /// Of the balls of haze that Emitters make of it; surfaces ignore it. Through a ball's middle, e to the
    /// power of minus this of the light behind remains. [0, k_max_optical_depth].
    float optical_depth = 0.0f;
    float light_map_strength = 1.0f;  ///< factor of the light map, ≥ 0: what makes bytes of a picture HDR
    float alpha_cutoff = 0.5f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool double_sided = false;
    bool unlit = false;  ///< shown as its base colour, neither lit nor shadowed
    TextureSlot base_colour_texture;
    TextureSlot metalness_roughness_texture;  ///< roughness in G, metalness in B
    TextureSlot normal_texture;
    TextureSlot occlusion_texture;  ///< R
    TextureSlot emissive_texture;
    TextureSlot specular_texture;         ///< A
    TextureSlot specular_colour_texture;  ///< RGB
    TextureSlot transmission_texture;     ///< R
    TextureSlot height_texture;           ///< R: 1 at the surface, 0 at the deepest
    /// RGB: the radiance that a white Lambert surface would send because of light that has been baked, which
    /// is its irradiance over π, with all that hides it counted in. Bytes are sRGB, so that the dark keeps
    /// its steps, floats are linear light.
    TextureSlot light_map_texture;
};

inline constexpr float k_max_height_depth = 0.25f;  ///< of Material::height_depth

inline constexpr float k_max_optical_depth = 100.0f;  ///< of Material::optical_depth

/// Whether light goes through some of it: none does through metals (KHR_materials_transmission).
[[nodiscard]] inline bool transmits(const Material& material) {
    const bool metal = material.metalness >= 1.0f && material.metalness_roughness_texture.texture == k_none;
    return material.transmission > 0.0f && !metal && !material.unlit;
}

/// Whether baked light falls on it and it scatters some: metals and what is unlit scatter none.
[[nodiscard]] inline bool is_light_mapped(const Material& material) {
    const bool metal = material.metalness >= 1.0f && material.metalness_roughness_texture.texture == k_none;
    return material.light_map_texture.texture != k_none && material.light_map_strength > 0.0f && !metal &&
           !material.unlit;
}

/// Its alpha mode, but that what transmits is blended with what lies behind it.
[[nodiscard]] inline AlphaMode drawn_as(const Material& material) {
    return transmits(material) ? AlphaMode::blend : material.alpha_mode;
}

/// Calls `visit` with each texture slot of a material.
template <class M, class Visit>
void for_each_texture_slot(M& material, Visit&& visit) {
    for (auto* slot : {&material.base_colour_texture, &material.metalness_roughness_texture,
                       &material.normal_texture, &material.occlusion_texture, &material.emissive_texture,
                       &material.specular_texture, &material.specular_colour_texture,
                       &material.transmission_texture, &material.height_texture, &material.light_map_texture})
        visit(*slot);
}

}  // namespace rambla::assets
