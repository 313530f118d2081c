#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "assets/material.h"

namespace rambla::assets {

enum class TexelFormat : std::uint8_t {
    rgba8,
    rgba32f,  ///< linear light
    bc1,      ///< RGB, 8 bytes a block
    bc3,      ///< RGBA, 16
    bc4,      ///< R, 8
    bc5       ///< RG, 16
};

/// Where a channel comes from that a shader reads.
enum class ChannelSource : std::uint8_t { red, green, blue, alpha, zero, one };
using Swizzle = std::array<ChannelSource, 4>;
inline constexpr Swizzle k_no_swizzle{ChannelSource::red, ChannelSource::green, ChannelSource::blue,
                                      ChannelSource::alpha};

struct TextureLevel {
    std::uint32_t width = 0;   ///< texels, not rounded up to blocks
    std::uint32_t height = 0;  ///< texels
    std::size_t offset = 0;    ///< of TextureData::bytes; 0 where those are not there
    std::size_t size = 0;      ///< bytes; blocks of 4×4 texels, those at the rim whole
    /// Root mean square difference that compression made, over the channels that are used, in the picture's
    /// own encoding with white as 1.
    float rms_error = 0.0f;
};

/// A picture with its mip levels as the graphics card takes them. Row 0 is on top.
struct TextureData {
    std::string name;
    TexelFormat format = TexelFormat::rgba8;
    ColourSpace colour_space = ColourSpace::linear;
    Swizzle swizzle = k_no_swizzle;
    bool normal_map = false;           ///< x and y alone are certain: z = √(1 − x² − y²)
    std::vector<TextureLevel> levels;  ///< finest first, down to 1×1
    std::uint32_t first_stored = 0;    ///< of finer levels than this one the bytes are not here
    std::vector<std::byte> bytes;
};

}  // namespace rambla::assets
