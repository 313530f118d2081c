#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "assets/image.h"
#include "assets/import/picture_limits.h"

namespace rambla::assets {

/// Reads a picture: 8- and 16-bit files as rgba8 in their own encoding, float files (HDR, EXR) as rgba32f.
/// Files are not trusted: what a head claims is held against the limits, and against most_texel_bytes of the
/// file's own size, before anything believes it.
/// @throws Error  naming the file and what is wrong with it
[[nodiscard]] Image read_image(const std::filesystem::path& file, const PictureLimits& limits = {});

/// Decodes a picture that lies in memory; `name` stands for the file in errors.
[[nodiscard]] Image decode_image(std::span<const std::byte> bytes, const std::string& name,
                                 const PictureLimits& limits = {});

/// The format that the content shows: "png", "jpeg", "hdr", "openexr", "tiff", "dds", for names of Targa
/// files "targa", otherwise "unknown".
[[nodiscard]] std::string picture_format(std::span<const std::byte> bytes, const std::string& name);

/// What a picture file says of itself.
struct PictureFacts {
    std::string format;  ///< as picture_format
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::string> channels;  ///< their names, such as R, G, B, A
    std::string sample;                 ///< type of one value: "uint8", "uint16", "half", "float" …
    std::uint64_t file_bytes = 0;
};

struct ImageWithFacts {
    Image image;
    PictureFacts facts;
};

/// The image that read_image returns, and the file's own facts. @throws Error
[[nodiscard]] ImageWithFacts read_image_with_facts(const std::filesystem::path& file,
                                                   const PictureLimits& limits = {});

/// The checkerboard that stands in for a picture that cannot be read: magenta and black, impossible to miss.
[[nodiscard]] Image placeholder_image(const std::string& name);

}  // namespace rambla::assets
