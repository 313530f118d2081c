#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "assets/image.h"

namespace rambla::assets {

/// Reads a picture: 8- and 16-bit files as rgba8 in their own encoding, float files (HDR, EXR) as rgba32f.
/// @throws Error  naming the file and what is wrong with it
[[nodiscard]] Image read_image(const std::filesystem::path& file, std::uint32_t max_size_px = 16'384);

/// Decodes a picture that lies in memory; `name` stands for the file in errors.
[[nodiscard]] Image decode_image(std::span<const std::byte> bytes, const std::string& name,
                                 std::uint32_t max_size_px = 16'384);

/// The checkerboard that stands in for a picture that cannot be read: magenta and black, impossible to miss.
[[nodiscard]] Image placeholder_image(const std::string& name);

}  // namespace rambla::assets
