#include "assets/process/blocks.h"

#include <cstring>

#include "assets/assert.h"

namespace rambla::assets {

namespace {

using Bytes4 = std::array<std::uint8_t, 4>;

std::uint64_t little_endian(const std::byte* bytes, int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return value;
}

std::uint8_t mixed(int a, int b, int of_b, int all) {
    return static_cast<std::uint8_t>((a * (all - of_b) + b * of_b + all / 2) / all);
}

Bytes4 from_565(std::uint64_t bits) {
    const auto expand = [](std::uint64_t value, int width) {
        return static_cast<std::uint8_t>((value << (8 - width)) | (value >> (2 * width - 8)));
    };
    return {expand((bits >> 11) & 31, 5), expand((bits >> 5) & 63, 6), expand(bits & 31, 5), 255};
}

/// Colours of a block: two of 5, 6 and 5 bits and two between them; where the first is not the greater one,
/// and the format allows it, one between them and black.
void decode_colours(const std::byte* block, bool always_four, BlockTexels& texels) {
    const std::uint64_t first = little_endian(block, 2);
    const std::uint64_t second = little_endian(block + 2, 2);
    std::array<Bytes4, 4> palette{from_565(first), from_565(second), {}, {}};
    const bool four = always_four || first > second;
    for (std::size_t c = 0; c < 3; ++c) {
        palette[2][c] =
            four ? mixed(palette[0][c], palette[1][c], 1, 3) : mixed(palette[0][c], palette[1][c], 1, 2);
        palette[3][c] = four ? mixed(palette[0][c], palette[1][c], 2, 3) : std::uint8_t{0};
    }
    const std::uint64_t indices = little_endian(block + 4, 4);
    for (std::size_t i = 0; i < k_block_side * k_block_side; ++i)
        std::memcpy(&texels[4 * i], palette[(indices >> (2 * i)) & 3].data(), 3);
}

/// One channel of a block: two values and six between them, or four between them, 0 and 255.
void decode_channel(const std::byte* block, std::size_t channel, BlockTexels& texels) {
    const int first = std::to_integer<int>(block[0]);
    const int second = std::to_integer<int>(block[1]);
    std::array<std::uint8_t, 8> palette{
        static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second), 0, 0, 0, 0, 0, 255};
    const int between = first > second ? 6 : 4;
    for (int i = 1; i <= between; ++i)
        palette[static_cast<std::size_t>(i) + 1] = mixed(first, second, i, between + 1);
    const std::uint64_t indices = little_endian(block + 2, 6);
    for (std::size_t i = 0; i < k_block_side * k_block_side; ++i)
        texels[4 * i + channel] = palette[(indices >> (3 * i)) & 7];
}

BlockTexels decoded(const std::byte* block, TexelFormat format) {
    BlockTexels texels{};
    for (std::size_t i = 0; i < k_block_side * k_block_side; ++i)
        texels[4 * i + 3] = 255;
    switch (format) {
        case TexelFormat::bc1:
            decode_colours(block, false, texels);
            break;
        case TexelFormat::bc3:
            decode_channel(block, 3, texels);
            decode_colours(block + 8, true, texels);
            break;
        case TexelFormat::bc5:
            decode_channel(block + 8, 1, texels);
            [[fallthrough]];
        default:
            decode_channel(block, 0, texels);
    }
    return texels;
}

}  // namespace

std::size_t stored_size(TexelFormat format, std::uint32_t width, std::uint32_t height) {
    if (format == TexelFormat::rgba8) return std::size_t{4} * width * height;
    if (format == TexelFormat::rgba32f) return std::size_t{16} * width * height;
    return std::size_t{block_count(width)} * block_count(height) * block_bytes(format);
}

Image decompressed(std::span<const std::byte> bytes, TexelFormat format, std::uint32_t width,
                   std::uint32_t height) {
    RAMBLA_ASSERT(bytes.size() == stored_size(format, width, height), "all blocks are there");
    Image image{.name = {}, .width = width, .height = height, .texels = {}};
    image.texels.resize(std::size_t{4} * width * height);
    for (std::uint32_t block_y = 0; block_y < block_count(height); ++block_y)
        for (std::uint32_t block_x = 0; block_x < block_count(width); ++block_x) {
            const std::size_t number = std::size_t{block_y} * block_count(width) + block_x;
            const BlockTexels texels = decoded(&bytes[number * block_bytes(format)], format);
            for (std::uint32_t i = 0; i < k_block_side * k_block_side; ++i) {
                const std::uint32_t x = block_x * k_block_side + i % k_block_side;
                const std::uint32_t y = block_y * k_block_side + i / k_block_side;
                if (x >= width || y >= height) continue;
                std::memcpy(&image.texels[4 * (std::size_t{y} * width + x)], &texels[4 * i], 4);
            }
        }
    return image;
}

}  // namespace rambla::assets
