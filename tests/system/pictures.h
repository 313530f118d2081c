#pragma once

#include <cstdint>
#include <filesystem>

#include "assets/image.h"

namespace rambla::system_test {

[[nodiscard]] assets::Image picture(const std::filesystem::path& file);

/// Byte of an rgba8 picture.
[[nodiscard]] int byte_at(const assets::Image& image, std::uint32_t x, std::uint32_t y,
                          std::uint32_t channel);

/// Mean over pixels and colours, 0 to 255.
[[nodiscard]] double mean_byte(const assets::Image& image);
/// Mean absolute difference over pixels and colours of two rgba8 pictures of one size, 0 to 255.
[[nodiscard]] double mean_difference(const assets::Image& a, const assets::Image& b);
/// Share of pixels whose red and blue stand far above their green.
[[nodiscard]] double magenta_share(const assets::Image& image);
/// Texels of an rgba32f picture with a colour that is infinite or no number.
[[nodiscard]] std::size_t non_finite_texels(const assets::Image& image);

}  // namespace rambla::system_test
