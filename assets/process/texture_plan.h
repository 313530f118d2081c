#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "assets/process/mips.h"
#include "assets/scene.h"

namespace rambla::assets {

enum class TextureRole : std::uint8_t {
    colour,     ///< light, sRGB or linear
    data,       ///< numbers, linear
    normals,    ///< a tangent-space normal map
    roughness,  ///< metalness and roughness under a normal map
    light  ///< a light map, never in blocks: it is smooth and seen close up, where their 5 bits would band
};

/// Bits of the channels that materials read.
using ChannelMask = std::uint8_t;
inline constexpr ChannelMask k_red = 1, k_green = 2, k_blue = 4, k_alpha = 8;

/// One way in which materials use a picture: all that its mip levels depend on.
struct TextureJob {
    std::uint32_t image = k_none;    ///< k_none: all ones, 1×1
    std::uint32_t normals = k_none;  ///< image of the normal map, for roughness
    TextureRole role = TextureRole::data;
    ColourSpace colour_space = ColourSpace::linear;
    AlphaUse alpha = AlphaUse::ignored;
    float cutoff = 0.0f;     ///< where alpha is tested
    float roughness = 1.0f;  ///< factors, for roughness
    float normal_scale = 1.0f;

    auto operator<=>(const TextureJob&) const = default;
};

/// What has to be made of a scene's pictures, each use once, and who then uses what.
struct TexturePlan {
    std::vector<TextureJob> jobs;
    std::vector<ChannelMask> channels;  ///< that materials read of each job's texture
    std::vector<Texture> textures;      ///< `image` refers to `jobs`
    std::vector<Material> materials;    ///< of the scene, with slots that refer to `textures`
};

/// A metalness-roughness texture that is seen through the same coordinates as a normal map becomes one of
/// widened roughness, which contains the material's factor; a material with a normal map alone gets one of
/// its own.
[[nodiscard]] TexturePlan plan_textures(const Scene& scene);

}  // namespace rambla::assets
