#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assets/image.h"
#include "assets/texture_data.h"

namespace rambla::assets {

enum class CompressionEffort : std::uint8_t { fast, good };

/// Blocks with what they cost.
struct CompressedImage {
    std::vector<std::byte> bytes;
    double rms_error =
        0.0;  ///< over the format's channels, as shares of white, in the picture's own encoding
};

/// Block compression (libsquish: cluster fit where the effort is good, range fit where it is fast). Texels
/// that fill a block up beyond the picture's rim have no influence. The error is measured by decoding.
/// @param image   rgba8; bc1 does not look at its alpha, bc4 takes red, bc5 red and green
/// @param format  one of the block formats
[[nodiscard]] CompressedImage compressed(const Image& image, TexelFormat format, CompressionEffort effort);

/// Peak signal-to-noise ratio of a root mean square error, with white as the peak; infinite for 0. Decibels.
[[nodiscard]] double psnr_db(double rms_error);

}  // namespace rambla::assets
