#include "assets/process/compress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "assets/process/blocks.h"

namespace rambla::assets::test {
namespace {

std::vector<std::byte> bytes(std::initializer_list<int> values) {
    std::vector<std::byte> out;
    for (const int value : values)
        out.push_back(static_cast<std::byte>(value));
    return out;
}

std::array<int, 4> texel(const Image& image, std::size_t i) {
    std::array<int, 4> out{};
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = std::to_integer<int>(image.texels[4 * i + c]);
    return out;
}

using Texel = std::array<int, 4>;

TEST(Blocks, AreReadAsTheFormatSays) {
    // Worked out by hand from the format's description. Red 31 (0xf800) and blue 31 (0x001f): the first is
    // greater, so there are two mixtures; row 0 uses the indices 0, 1, 2, 3.
    const Image four = decompressed(bytes({0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0}), TexelFormat::bc1, 4, 4);
    EXPECT_EQ(texel(four, 0), (Texel{255, 0, 0, 255}));
    EXPECT_EQ(texel(four, 1), (Texel{0, 0, 255, 255}));
    EXPECT_EQ(texel(four, 2), (Texel{170, 0, 85, 255}));
    EXPECT_EQ(texel(four, 3), (Texel{85, 0, 170, 255}));
    EXPECT_EQ(texel(four, 4), (Texel{255, 0, 0, 255}));
    // The other way round: one mixture and black.
    const Image three = decompressed(bytes({0x1f, 0x00, 0x00, 0xf8, 0xe4, 0, 0, 0}), TexelFormat::bc1, 4, 4);
    EXPECT_EQ(texel(three, 2), (Texel{128, 0, 128, 255}));
    EXPECT_EQ(texel(three, 3), (Texel{0, 0, 0, 255}));
    // Green of six bits: 21 is (21 << 2) | (21 >> 4) = 85.
    EXPECT_EQ(texel(decompressed(bytes({0xa0, 0x02, 0, 0, 0, 0, 0, 0}), TexelFormat::bc1, 4, 4), 0),
              (Texel{0, 85, 0, 255}));
    // One channel, 210 above 0: index i of 2 … 7 is (210 · (8 − i))/7. Indices 0 … 7 in the first 24 bits.
    const Image eight = decompressed(bytes({210, 0, 0x88, 0xc6, 0xfa, 0, 0, 0}), TexelFormat::bc4, 4, 4);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(texel(eight, i)[0], i == 0 ? 210 : i == 1 ? 0 : 30 * (8 - static_cast<int>(i)));
    // 0 below 250: four mixtures, then 0 and 255.
    const Image six = decompressed(bytes({0, 250, 0x88, 0xc6, 0xfa, 0, 0, 0}), TexelFormat::bc4, 4, 4);
    const std::array expected{0, 250, 50, 100, 150, 200, 0, 255};
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(texel(six, i)[0], expected[i]);
    // Two channels are two such blocks, red first; bc3 is alpha's block and a colour block of four always.
    const Image two =
        decompressed(bytes({9, 9, 0, 0, 0, 0, 0, 0, 77, 77, 0, 0, 0, 0, 0, 0}), TexelFormat::bc5, 4, 4);
    EXPECT_EQ(texel(two, 5), (Texel{9, 77, 0, 255}));
    const Image all = decompressed(bytes({33, 33, 0, 0, 0, 0, 0, 0, 0x1f, 0x00, 0x00, 0xf8, 0xe4, 0, 0, 0}),
                                   TexelFormat::bc3, 4, 4);
    EXPECT_EQ(texel(all, 2), (Texel{85, 0, 170, 33}));
}

/// Soft shapes and some noise, as textures have.
Image picture(std::uint32_t width, std::uint32_t height) {
    std::mt19937 random{8};
    std::uniform_int_distribution<int> noise{0, 12};
    Image image{.name = {}, .width = width, .height = height, .texels = {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const double wave = std::sin(0.11 * x) * std::cos(0.07 * y);
            for (const double value : {120 + 90 * wave, 100 + 70 * wave, 60 + 40 * std::sin(0.05 * x),
                                       128 + 120 * std::sin(0.09 * (x + y))})
                image.texels.push_back(
                    static_cast<std::byte>(std::min(255, static_cast<int>(value) + noise(random))));
        }
    return image;
}

double measured_rms(const Image& a, const Image& b, std::size_t channels) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.texels.size() / 4; ++i)
        for (std::size_t c = 0; c < channels; ++c)
            sum += std::pow((texel(a, i)[c] - texel(b, i)[c]) / 255.0, 2.0);
    return std::sqrt(sum / static_cast<double>(a.texels.size() / 4 * channels));
}

TEST(Compression, StatesTheErrorThatDecodingFinds) {
    const Image image = picture(96, 64);
    for (const auto& [format, channels, least_psnr] : {std::tuple{TexelFormat::bc1, std::size_t{3}, 34.0},
                                                       {TexelFormat::bc3, std::size_t{4}, 34.0},
                                                       {TexelFormat::bc4, std::size_t{1}, 42.0},
                                                       {TexelFormat::bc5, std::size_t{2}, 42.0}}) {
        for (const CompressionEffort effort : {CompressionEffort::fast, CompressionEffort::good}) {
            const CompressedImage blocks = compressed(image, format, effort);
            ASSERT_EQ(blocks.bytes.size(), stored_size(format, 96, 64));
            const Image back = decompressed(blocks.bytes, format, 96, 64);
            EXPECT_NEAR(blocks.rms_error, measured_rms(image, back, channels), 1e-9);
            EXPECT_GT(psnr_db(blocks.rms_error), least_psnr) << static_cast<int>(format);
            RecordProperty("psnr_db_" + std::to_string(static_cast<int>(format)) +
                               (effort == CompressionEffort::good ? "_good" : "_fast"),
                           std::to_string(psnr_db(blocks.rms_error)));
        }
        EXPECT_LE(compressed(image, format, CompressionEffort::good).rms_error,
                  compressed(image, format, CompressionEffort::fast).rms_error);
    }
}

TEST(Compression, SizesThatAreNoMultipleOfABlock) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 7u}, {5u, 4u}, {13u, 3u}, {6u, 10u}}) {
        EXPECT_EQ(stored_size(TexelFormat::bc1, width, height),
                  std::size_t{(width + 3) / 4} * ((height + 3) / 4) * 8);
        // Two colours only, which five and six bits hold exactly: what fills the last blocks up, black in
        // memory, must not become a third.
        Image image = picture(width, height);
        for (std::size_t i = 0; i < image.texels.size(); ++i)
            image.texels[i] = static_cast<std::byte>(i / 4 % 2 == 0 ? 255 : i % 4 == 1 ? 130 : 132);
        for (const TexelFormat format :
             {TexelFormat::bc1, TexelFormat::bc3, TexelFormat::bc4, TexelFormat::bc5}) {
            const CompressedImage blocks = compressed(image, format, CompressionEffort::good);
            EXPECT_EQ(blocks.bytes.size(), stored_size(format, width, height));
            EXPECT_LT(blocks.rms_error, 1e-9);
        }
    }
}

TEST(Compression, AlphaDoesNotHarmOpaqueColours) {
    Image image = picture(16, 16);
    Image opaque = image;
    for (std::size_t i = 3; i < image.texels.size(); i += 4) {
        image.texels[i] = std::byte{0};
        opaque.texels[i] = std::byte{255};
    }
    EXPECT_EQ(compressed(image, TexelFormat::bc1, CompressionEffort::good).bytes,
              compressed(opaque, TexelFormat::bc1, CompressionEffort::good).bytes);
}

TEST(Compression, PsnrOfKnownErrors) {
    EXPECT_NEAR(psnr_db(0.1), 20.0, 1e-12);
    EXPECT_NEAR(psnr_db(1.0 / 255.0), 48.1308, 1e-4);
    EXPECT_TRUE(std::isinf(psnr_db(0.0)));
}

}  // namespace
}  // namespace rambla::assets::test
