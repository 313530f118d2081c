#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assets/export/image.h"
#include "assets/import/image.h"
#include "assets/import/jpeg.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::HasSubstr;

std::string decoding_error(const std::string& bytes, const PictureLimits& limits = {}) {
    try {
        static_cast<void>(decode_image(std::as_bytes(std::span{bytes}), "picture", limits));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string flat_png(std::uint32_t size) {
    Image image{.name = "flat", .width = size, .height = size, .texels = {}};
    image.texels.assign(std::size_t{4} * size * size, std::byte{255});
    return text_of(encode_png(image));
}

/// The end of the named part of a file, which must be there.
std::size_t behind(const std::string& bytes, const std::string& part) {
    const std::size_t at = bytes.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return at + part.size();
}

std::string with_big_endian(std::string bytes, std::size_t at, std::uint32_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
        bytes[at + i] = static_cast<char>(value >> (8 * (size - 1 - i)) & 0xff);
    return bytes;
}

std::string with_little_endian(std::string bytes, std::size_t at, std::uint32_t value) {
    std::memcpy(&bytes[at], &value, sizeof value);
    return bytes;
}

/// A JPEG without data: enough for what is read before data.
std::string jpeg(std::uint32_t frame, std::uint32_t width, std::uint32_t height, int scans) {
    std::string bytes = bytes_of<std::uint8_t>(
        {0xff, 0xd8, 0xff, static_cast<std::uint8_t>(frame), 0, 11, 8, 0, 0, 0, 0, 1, 1, 0x11, 0});
    bytes = with_big_endian(with_big_endian(bytes, 7, height, 2), 9, width, 2);
    for (int i = 0; i < scans; ++i)
        bytes += bytes_of<std::uint8_t>({0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x12, 0xff, 0});
    return bytes + bytes_of<std::uint8_t>({0xff, 0xd9});
}

std::string exr() {
    Image image{.name = "e", .width = 3, .height = 2, .format = PixelFormat::rgba32f, .texels = {}};
    image.texels.resize(96);
    const ScratchFolder folder;
    write_image(folder.path() / "e.exr", image);
    std::ifstream in{folder.path() / "e.exr", std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

TEST(PictureLimits, TexelsAreHeldAgainstTheSizeOfTheFile) {
    const std::string png = flat_png(64);
    EXPECT_EQ(decoding_error(png), "");
    EXPECT_EQ(decoding_error(png, {.texel_bytes = 64 * 64 * 4}), "");
    EXPECT_THAT(decoding_error(png, {.texel_bytes = 64 * 64 * 4 - 1}), HasSubstr("16384 bytes of texels"));
    // 16384 x 16384 in a file of some hundred bytes: a gigabyte that is never asked for.
    std::string claims = with_big_endian(with_big_endian(png, 16, 16384, 4), 20, 16384, 4);
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<std::uint8_t>(claims[i]);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
    claims = with_big_endian(claims, 29, ~crc, 4);
    EXPECT_THAT(decoding_error(claims), HasSubstr("1073741824 bytes of texels, expected at most 268435456"));
    static_assert(most_texel_bytes(0) == 256u << 20 && most_texel_bytes(1 << 20) == 4200ull << 20);
}

TEST(PictureLimits, AJpegsFrameIsReadBeforeTheLibraryBelievesIt) {
    constexpr std::uint32_t k_progressive = 0xc2;
    EXPECT_THAT(decoding_error(jpeg(k_progressive, 65500, 20, 1)), HasSubstr("65500 x 20 pixels"));
    EXPECT_THAT(decoding_error(jpeg(k_progressive, 20, 65500, 1)), HasSubstr("20 x 65500 pixels"));
    EXPECT_THAT(decoding_error(jpeg(k_progressive, 8, 8, 101)), HasSubstr("100 scans"));
    // The library's words follow the picture's name, and do not repeat it.
    EXPECT_THAT(decoding_error(jpeg(k_progressive, 8, 8, 1).substr(0, 8)),
                HasSubstr("\"JPEG error: Premature end of JPEG file; JPEG error: Bogus marker length\""));
    EXPECT_THAT(decoding_error(jpeg(k_progressive, 8, 8, 100)), ::testing::Not(HasSubstr("scans")));
    // A frame inside of another segment, as in the preview that cameras store, is none.
    std::string preview = jpeg(0xc0, 8, 8, 1);
    preview.insert(2,
                   bytes_of<std::uint8_t>({0xff, 0xe1, 0, 11, 0xff, 0xc0, 0, 11, 8, 0xff, 0xff, 0xff, 0xff}));
    EXPECT_THAT(decoding_error(preview), ::testing::Not(HasSubstr("pixels")));
}

TEST(PictureLimits, RemarksInAJpegAreLeftOut) {
    const std::string soi = "\xff\xd8";
    const std::string jfif = bytes_of<std::uint8_t>({0xff, 0xe0, 0, 4, 1, 2});
    const std::string adobe = bytes_of<std::uint8_t>({0xff, 0xee, 0, 3, 9});
    const std::string exif = bytes_of<std::uint8_t>({0xff, 0xe1, 0, 6, 'E', 'x', 0xff, 0xee});
    const std::string comment = bytes_of<std::uint8_t>({0xff, 0xfe, 0, 3, 'c'});
    const std::string empty =
        bytes_of<std::uint8_t>({0xff, 0xed, 0, 0});  // less than the length itself takes
    const std::string rest = jpeg(0xc0, 8, 8, 1).substr(2);
    const auto essential = [](const std::string& bytes) {
        return text_of(essential_jpeg(std::as_bytes(std::span{bytes}), "picture", 100));
    };
    EXPECT_EQ(essential(soi + jfif + exif + adobe + comment + empty + rest + exif),
              soi + jfif + adobe + rest + exif)
        << "behind the end, nothing is looked at";
    EXPECT_EQ(essential(soi + comment + exif.substr(0, 5)), soi) << "cut inside";
    EXPECT_EQ(essential(soi + exif.substr(0, 2)), soi) << "cut before the length";
    EXPECT_EQ(essential(soi + jfif.substr(0, 5)), soi + jfif.substr(0, 5));
    EXPECT_EQ(essential(soi), soi);
}

TEST(PictureLimits, AnExrsAttributesAreReadBeforeTheLibraryBelievesThem) {
    const std::string whole = exr();
    EXPECT_EQ(decoding_error(whole), "");
    using namespace std::string_literals;
    const std::size_t compression = behind(whole, "compression\0compression\0"s);
    EXPECT_THAT(decoding_error(with_little_endian(whole, compression, 0x7fffffff)),
                HasSubstr("an attribute of 2147483647 bytes"));
    const std::size_t window = behind(whole, "dataWindow\0box2i\0"s) + 4;
    EXPECT_THAT(decoding_error(with_little_endian(whole, window + 12, 0x7fffffff)),
                HasSubstr("a window of 2147483648 pixels"));
    EXPECT_THAT(decoding_error(with_little_endian(whole, window, 0x80000000)),
                HasSubstr("a window of 2147483651"));
    EXPECT_THAT(decoding_error(with_little_endian(whole, window, 3)), HasSubstr("a window of 0 pixels"));
    EXPECT_THAT(decoding_error(with_little_endian(whole, 4, 0x802)), HasSubstr("deep"));
    // The library reads a number of the type's own size and goes on behind it.
    EXPECT_THAT(decoding_error(with_little_endian(whole, behind(whole, "pixelAspectRatio\0float\0"s), 8)),
                HasSubstr("a float of 8 bytes"));
    const std::size_t channels = behind(whole, "channels\0chlist\0"s);
    EXPECT_THAT(decoding_error(with_little_endian(whole, channels, 20)), HasSubstr("a chlist of 20 bytes"));
    for (std::size_t size = 0; size < window + 40; ++size)
        EXPECT_NE(decoding_error(whole.substr(0, size)), "") << size;
}

/// Many images of one small picture would be a thousand times its size in memory.
TEST(PictureLimits, ImagesOfOneDocumentShareWhatItsBytesMayBecome) {
    const std::string png = flat_png(2048);
    constexpr std::size_t k_images = 3000;
    std::string images;
    std::string textures;
    std::string materials;
    for (std::size_t i = 0; i < k_images; ++i) {
        const std::string comma = i == 0 ? "" : ",";
        images += comma + R"({"bufferView":0,"mimeType":"image/png"})";
        textures += comma + R"({"source":)" + std::to_string(i) + "}";
        materials += comma + R"({"normalTexture":{"index":)" + std::to_string(i) + "}}";
    }
    const std::string file =
        glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(png.size()) +
                R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(png.size()) +
                R"(}],"images":[)" + images + R"(],"textures":[)" + textures + R"(],"materials":[)" +
                materials + "]}",
            png);
    const ScratchFolder folder;
    const LogCapture log;
    const Scene scene = import_gltf(folder.write("many.glb", file));
    EXPECT_THAT(log.text(), HasSubstr("for a file of this size"));
    std::uint64_t texel_bytes = 0;
    for (const Image& image : scene.images)
        texel_bytes += image.texels.size();
    EXPECT_EQ(scene.images.size(), k_images);
    EXPECT_LE(texel_bytes, 2 * most_texel_bytes(file.size()));
    // One image alone is welcome.
    const std::string one =
        glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(png.size()) +
                R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(png.size()) +
                R"(}],"images":[{"bufferView":0}],"textures":[{"source":0}],
"materials":[{"normalTexture":{"index":0}}]})",
            png);
    EXPECT_EQ(import_gltf(folder.write("one.glb", one)).images[0].width, 2048u);
}

}  // namespace
}  // namespace rambla::assets::test
