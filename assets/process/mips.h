#pragma once

#include <cstdint>
#include <vector>

#include "assets/image.h"
#include "assets/material.h"

namespace rambla::assets {

/// What a colour's alpha does.
enum class AlphaUse : std::uint8_t {
    ignored,  ///< nothing: colours count alike, whatever theirs is
    blended,  ///< transparent texels lend no colour to their neighbours
    tested    ///< likewise, and the share of the picture that passes the test shrinks in no level
};

struct ColourMips {
    ColourSpace colour_space = ColourSpace::srgb;  ///< of rgba8; rgba32f is linear light always
    AlphaUse alpha = AlphaUse::ignored;
    float cutoff = 0.5f;  ///< of the alpha test, in (0, 1]
};

/// All levels of a picture, itself first, down to 1×1: decoded, averaged over area in linear light, encoded.
[[nodiscard]] std::vector<Image> colour_mips(const Image& picture, const ColourMips& options);

/// All levels of a tangent-space normal map (rgb = ½ + ½ n), itself first: means of its unit normals, made
/// unit length again. Where normals cancel out, the level has (0, 0, 1).
[[nodiscard]] std::vector<Image> normal_mips(const Image& normals);

struct RoughnessMips {
    float roughness = 1.0f;     ///< factor of the green channel; it is contained in what comes out
    float normal_scale = 1.0f;  ///< factor of the normals' x and y
};

/// All levels of a metalness-roughness picture (roughness in green), whose roughness is widened by what the
/// mips of a normal map lose: a mean normal of length r stands for slopes of variance σ² = (1 − r)/r (Toksvig
/// 2005, "Mipmapping normal maps"), and variances of slopes add up: α'² = α² + 2σ² with α = roughness² (Olano
/// & Baker 2010, "LEAN mapping"). Within a level α² is averaged, for the same reason; other channels as they
/// are.
/// @param picture  rgba8; 1×1 for a constant, whose levels then are the normal map's size
/// @param normals  rgba8, seen through the same texture coordinates
[[nodiscard]] std::vector<Image> roughness_mips(const Image& picture, const Image& normals,
                                                const RoughnessMips& options);

}  // namespace rambla::assets
