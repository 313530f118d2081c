#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace rambla::assets {

enum class PixelFormat : std::uint8_t {
    rgba8,   ///< four unsigned bytes
    rgba32f  ///< four floats, linear light
};

[[nodiscard]] constexpr std::size_t bytes_per_texel(PixelFormat format) {
    return format == PixelFormat::rgba8 ? 4 : 16;
}

/// A picture in memory: row-major, row 0 on top (v = 0 in glTF), four channels, no padding.
struct Image {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    PixelFormat format = PixelFormat::rgba8;
    std::vector<std::byte> texels;  ///< width · height · bytes_per_texel(format) bytes
};

}  // namespace rambla::assets
