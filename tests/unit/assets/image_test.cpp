#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "assets/export/image.h"
#include "assets/import/image.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Image noise(std::uint32_t width, std::uint32_t height, bool opaque) {
    std::mt19937 random{7};
    Image image{
        .name = "noise", .width = width, .height = height, .format = PixelFormat::rgba8, .texels = {}};
    for (std::size_t i = 0; i < std::size_t{width} * height * 4; ++i)
        image.texels.push_back(opaque && i % 4 == 3 ? std::byte{255}
                                                    : static_cast<std::byte>(random() & 0xff));
    return image;
}

Image floats(std::uint32_t width, std::uint32_t height, const std::vector<float>& values) {
    Image image{
        .name = "floats", .width = width, .height = height, .format = PixelFormat::rgba32f, .texels = {}};
    image.texels.resize(values.size() * sizeof(float));
    std::memcpy(image.texels.data(), values.data(), image.texels.size());
    return image;
}

std::vector<float> values_of(const Image& image) {
    std::vector<float> values(image.texels.size() / sizeof(float));
    std::memcpy(values.data(), image.texels.data(), image.texels.size());
    return values;
}

std::vector<int> texel(const Image& image, std::size_t index) {
    std::vector<int> out;
    for (std::size_t c = 0; c < 4; ++c)
        out.push_back(static_cast<int>(image.texels[4 * index + c]));
    return out;
}

std::string error_of(const std::filesystem::path& file, const PictureLimits& limits = {}) {
    try {
        static_cast<void>(read_image(file, limits));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(ImageFiles, PngKeepsEveryByteWithAndWithoutAlpha) {
    const ScratchFolder folder;
    for (const bool opaque : {true, false}) {
        const Image image = noise(37, 23, opaque);
        write_image(folder.path() / "deep/er/noise.png", image);
        const Image back = read_image(folder.path() / "deep/er/noise.png");
        EXPECT_EQ(back.width, 37u);
        EXPECT_EQ(back.height, 23u);
        EXPECT_EQ(back.format, PixelFormat::rgba8);
        // Transparent colours too: nothing is premultiplied on the way.
        EXPECT_TRUE(back.texels == image.texels) << "opaque: " << opaque;
    }
}

TEST(ImageFiles, ExrHoldsHalvesAndLimitsWhatTheyCannotHold) {
    const ScratchFolder folder;
    const Image image = floats(2, 1, {0.5f, -2.0f, 1000.0f, 1.0f, 1e9f, 0.1f, -1e9f, 0.25f});
    write_image(folder.path() / "light.exr", image);
    const std::vector<float> back = values_of(read_image(folder.path() / "light.exr"));
    ASSERT_EQ(back.size(), 8u);
    for (const std::size_t exact : {0u, 1u, 2u, 3u, 7u})
        EXPECT_EQ(back[exact], values_of(image)[exact]);
    EXPECT_EQ(back[4], 65504.0f);
    EXPECT_EQ(back[6], -65504.0f);
    EXPECT_NEAR(back[5], 0.1f, 0.1f / 2048.0f);  // half floats have 11 significant bits
}

TEST(ImageFiles, GreyAndGreyAlphaSpreadToRgba) {
    // PGM is not read; a 2x1 grey Targa (type 3, 8 bit, origin at the top) is simple to write by hand.
    const ScratchFolder folder;
    const auto header = [](std::uint8_t type, std::uint8_t bits) {
        return bytes_of<std::uint8_t>({0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, bits, 0x20});
    };
    const Image grey = read_image(folder.write("grey.tga", header(3, 8) + bytes_of<std::uint8_t>({10, 200})));
    EXPECT_EQ(texel(grey, 0), (std::vector<int>{10, 10, 10, 255}));
    EXPECT_EQ(texel(grey, 1), (std::vector<int>{200, 200, 200, 255}));
    const Image colour =
        read_image(folder.write("bgr.tga", header(2, 24) + bytes_of<std::uint8_t>({1, 2, 3, 4, 5, 6})));
    EXPECT_EQ(texel(colour, 0), (std::vector<int>{3, 2, 1, 255}));
}

TEST(ImageFiles, SixteenBitPngBecomesEightBit) {
    // A 1x1 grey 16-bit PNG of 0x8080, made by zlib's documented layout: value 0x8080 / 0xffff = 128 / 255.
    const std::string png = bytes_of<std::uint8_t>(
        {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a, 0, 0,   0,    13,   'I',  'H',  'D',  'R',  0,    0,
         0,    1,   0,   0,   0,    1,    16,   0,    0, 0,   0,    0x6a, 0xee, 0x47, 0x16, 0,    0,    0,
         14,   'I', 'D', 'A', 'T',  0x78, 0x01, 0x01, 3, 0,   0xfc, 0xff, 0,    0x80, 0x80, 0x01, 0x83, 0x01,
         0x01, 0,   0,   0,   0,    0,    0,    0,    0, 'I', 'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82});
    const ScratchFolder folder;
    std::string fixed = png;
    const auto put_crc = [&](std::size_t from, std::size_t length) {
        std::uint32_t crc = 0xffffffffu;
        for (std::size_t i = from; i < from + length; ++i) {
            crc ^= static_cast<std::uint8_t>(fixed[i]);
            for (int bit = 0; bit < 8; ++bit)
                crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
        }
        crc = ~crc;
        for (std::size_t i = 0; i < 4; ++i)
            fixed[from + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xff);
    };
    put_crc(12, 17);
    put_crc(37, 18);
    const Image image = read_image(folder.write("deep.png", fixed));
    EXPECT_EQ(image.format, PixelFormat::rgba8);
    EXPECT_EQ(texel(image, 0), (std::vector<int>{128, 128, 128, 255}));
}

TEST(ImageFiles, ContentDecidesNotTheName) {
    const ScratchFolder folder;
    write_image(folder.path() / "a.png", noise(4, 4, true));
    std::filesystem::rename(folder.path() / "a.png", folder.path() / "a.jpg");
    EXPECT_EQ(read_image(folder.path() / "a.jpg").width, 4u);
}

TEST(ImageFiles, BrokenOnesAreErrorsThatNameTheFileAndNothingIsPrinted) {
    const ScratchFolder folder;
    ::testing::internal::CaptureStderr();
    write_image(folder.path() / "whole.png", noise(64, 64, false));
    std::ifstream stream{folder.path() / "whole.png", std::ios::binary};
    const std::string whole{std::istreambuf_iterator<char>{stream}, {}};
    for (const std::size_t size : {std::size_t{0}, std::size_t{8}, std::size_t{20}, whole.size() / 2})
        EXPECT_THAT(error_of(folder.write("cut.png", whole.substr(0, size))), HasSubstr("cut.png")) << size;
    EXPECT_THAT(error_of(folder.write("text.png", "hello")), HasSubstr("unknown picture format"));
    EXPECT_THAT(error_of(folder.path() / "no.png"), HasSubstr("no such file"));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(ImageFiles, SizeIsCheckedBeforeTexelsAreMade) {
    const ScratchFolder folder;
    write_image(folder.path() / "a.png", noise(33, 5, true));
    EXPECT_EQ(error_of(folder.path() / "a.png", {.size_px = 33}), "");
    EXPECT_THAT(error_of(folder.path() / "a.png", {.size_px = 32}),
                AllOf(HasSubstr("33 x 5"), HasSubstr("1 to 32")));
}

TEST(ImageFiles, WrongFormatForTheExtensionIsRefusedAndLeavesNothing) {
    const ScratchFolder folder;
    EXPECT_THROW(write_image(folder.path() / "a.exr", noise(2, 2, true)), Error);
    EXPECT_THROW(write_image(folder.path() / "a.png", floats(1, 1, {0, 0, 0, 0})), Error);
    EXPECT_THROW(write_image(folder.path() / "a.jpg", noise(2, 2, true)), Error);
    Image torn = noise(2, 2, true);
    torn.texels.pop_back();
    EXPECT_THROW(write_image(folder.path() / "a.png", torn), Error);
    EXPECT_THROW(write_text("/proc/nowhere/a.txt", "x"), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ImageFiles, PlaceholderIsMagentaAndBlack) {
    const Image image = placeholder_image("lost.png");
    EXPECT_EQ(image.name, "lost.png");
    EXPECT_EQ(texel(image, 0), (std::vector<int>{255, 0, 255, 255}));
    EXPECT_EQ(texel(image, 8), (std::vector<int>{0, 0, 0, 255}));
    EXPECT_EQ(texel(image, std::size_t{8} * image.width), (std::vector<int>{0, 0, 0, 255}));
}

TEST(ImageFiles, EnvironmentMapsOfTheCorpusAreFloats) {
    const std::filesystem::path folder = corpus("ImageFiles.EnvironmentMapsOfTheCorpusAreFloats: 4 files");
    if (folder.empty()) return;
    for (const char* name : {"spiaggia_di_mondello_1k.hdr", "studio.exr", "city.exr", "night.exr"}) {
        const Image image = read_image(folder / "env" / name);
        const bool is_hdr = std::string{name}.ends_with(".hdr");
        EXPECT_EQ(image.width, is_hdr ? 1024u : 512u) << name;
        EXPECT_EQ(image.format, PixelFormat::rgba32f) << name;
        const std::vector<float> values = values_of(image);
        const float brightest = *std::max_element(values.begin(), values.end());
        EXPECT_TRUE(std::isfinite(brightest)) << name;
        EXPECT_GT(brightest, 1.0f) << name;
        EXPECT_EQ(values[3], 1.0f) << name;
    }
}

}  // namespace
}  // namespace rambla::assets::test
