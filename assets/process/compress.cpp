#include "assets/process/compress.h"

#include <squish.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "assets/assert.h"
#include "assets/process/blocks.h"

namespace rambla::assets {

namespace {

constexpr int channel_count(TexelFormat format) {
    switch (format) {
        case TexelFormat::bc4:
            return 1;
        case TexelFormat::bc5:
            return 2;
        case TexelFormat::bc1:
            return 3;
        default:
            return 4;
    }
}

int squish_flags(TexelFormat format, CompressionEffort effort) {
    const int fit = effort == CompressionEffort::good ? squish::kColourClusterFit : squish::kColourRangeFit;
    switch (format) {
        case TexelFormat::bc1:
            return squish::kDxt1 | fit;
        case TexelFormat::bc3:
            return squish::kDxt5 | fit;
        case TexelFormat::bc4:
            return squish::kBc4;
        default:
            return squish::kBc5;
    }
}

/// A block of a picture, with the bits of those texels that lie in it.
struct MaskedBlock {
    BlockTexels texels{};
    int mask = 0;
};

MaskedBlock block_of(const Image& image, std::uint32_t block_x, std::uint32_t block_y, bool opaque) {
    MaskedBlock block;
    for (std::uint32_t i = 0; i < k_block_side * k_block_side; ++i) {
        const std::uint32_t x = block_x * k_block_side + i % k_block_side;
        const std::uint32_t y = block_y * k_block_side + i / k_block_side;
        if (x >= image.width || y >= image.height) continue;
        block.mask |= 1 << i;
        std::memcpy(&block.texels[4 * i], &image.texels[4 * (std::size_t{y} * image.width + x)], 4);
        // The library makes texels of little alpha transparent black in bc1.
        if (opaque) block.texels[4 * i + 3] = 255;
    }
    return block;
}

/// Root mean square difference over the first channels.
double difference(const Image& a, const Image& b, int channels) {
    std::uint64_t squared = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i) {
        const int apart = std::to_integer<int>(a.texels[i]) - std::to_integer<int>(b.texels[i]);
        if (static_cast<int>(i % 4) < channels) squared += static_cast<std::uint64_t>(apart * apart);
    }
    const double count = static_cast<double>(a.texels.size() / 4) * channels;
    return std::sqrt(static_cast<double>(squared) / count) / 255.0;
}

}  // namespace

CompressedImage compressed(const Image& image, TexelFormat format, CompressionEffort effort) {
    RAMBLA_ASSERT(image.format == PixelFormat::rgba8, "blocks hold bytes");
    RAMBLA_ASSERT(format != TexelFormat::rgba8 && format != TexelFormat::rgba32f, "a block format");
    CompressedImage out;
    out.bytes.resize(stored_size(format, image.width, image.height));
    const std::uint32_t across = block_count(image.width);
    const int flags = squish_flags(format, effort);
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>{0, block_count(image.height)}, [&](const auto& range) {
            for (std::uint32_t y = range.begin(); y < range.end(); ++y)
                for (std::uint32_t x = 0; x < across; ++x) {
                    const MaskedBlock block = block_of(image, x, y, format == TexelFormat::bc1);
                    squish::CompressMasked(block.texels.data(), block.mask,
                                           &out.bytes[(std::size_t{y} * across + x) * block_bytes(format)],
                                           flags);
                }
        });
    const Image back = decompressed(out.bytes, format, image.width, image.height);
    out.rms_error = difference(image, back, channel_count(format));
    return out;
}

double psnr_db(double rms_error) {
    return rms_error > 0.0 ? -20.0 * std::log10(rms_error) : std::numeric_limits<double>::infinity();
}

}  // namespace rambla::assets
