#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rambla::assets {

/// Limits on untrusted pictures; most_texel_bytes holds besides.
struct PictureLimits {
    std::uint32_t size_px = 16'384;                                         ///< width and height
    std::uint64_t texel_bytes = std::numeric_limits<std::uint64_t>::max();  ///< in memory
};

/// Texels that so many bytes of picture files may become: the best compression of real pictures, a surface of
/// one colour in a PNG, reaches 4128 to 1; small files may be better still.
[[nodiscard]] constexpr std::uint64_t most_texel_bytes(std::uint64_t encoded_bytes) {
    constexpr std::uint64_t k_ratio = 4200;
    constexpr std::uint64_t k_at_least = 256ull << 20;
    return std::max(k_at_least, k_ratio * encoded_bytes);
}

}  // namespace rambla::assets
