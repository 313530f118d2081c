#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "assets/image.h"

namespace rambla::assets {

/// Writes a picture in the format that the file name's extension names: .png (rgba8, bytes as they are) or
/// .exr (rgba32f, as half floats; larger values become the largest half). Missing folders are made. The file
/// appears whole or not at all. @throws Error  naming the file
void write_image(const std::filesystem::path& file, const Image& image);

/// Writes text in the same manner. @throws Error
void write_text(const std::filesystem::path& file, const std::string& text);

/// Writes bytes in the same manner. @throws Error
void write_bytes(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// A picture as the bytes of a PNG file, without an alpha channel where all of it is opaque.
/// @param image  rgba8  @throws Error  naming the image
[[nodiscard]] std::vector<std::byte> encode_png(const Image& image);

}  // namespace rambla::assets
