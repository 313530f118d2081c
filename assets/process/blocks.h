#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "assets/image.h"
#include "assets/texture_data.h"

namespace rambla::assets {

inline constexpr std::uint32_t k_block_side = 4;  ///< texels

/// RGBA bytes of one block, row by row.
using BlockTexels = std::array<std::uint8_t, 4 * k_block_side * k_block_side>;

/// Blocks along a side of so many texels, the last one perhaps not full.
[[nodiscard]] constexpr std::uint32_t block_count(std::uint32_t texels) {
    return texels / k_block_side + (texels % k_block_side != 0 ? 1 : 0);
}

/// Of one block of a block format.
[[nodiscard]] constexpr std::size_t block_bytes(TexelFormat format) {
    return format == TexelFormat::bc1 || format == TexelFormat::bc4 ? 8 : 16;
}

/// Bytes of a picture of so many texels, its rim filled up to whole blocks where the format has blocks.
[[nodiscard]] std::size_t stored_size(TexelFormat format, std::uint32_t width, std::uint32_t height);

/// Texels of a block-compressed picture as a graphics card reads them, alpha 255 and other channels 0 where
/// the format has none (Khronos Data Format 1.3, chapters 18 and 19).
/// @param bytes  stored_size(format, width, height) of them
[[nodiscard]] Image decompressed(std::span<const std::byte> bytes, TexelFormat format, std::uint32_t width,
                                 std::uint32_t height);

}  // namespace rambla::assets
