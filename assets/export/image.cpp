#include "assets/export/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fstream>

#include "assets/error.h"

namespace rambla::assets {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_channels = 4;

/// Frames are written by the hundred: the size gained above this level is not worth the time.
constexpr int k_png_level = 4;

void check_texels(const Image& image, const std::string& name) {
    const std::size_t expected = std::size_t{image.width} * image.height * bytes_per_texel(image.format);
    if (expected == 0 || image.texels.size() != expected)
        throw Error{name, "", std::to_string(image.texels.size()) + " bytes of texels",
                    std::to_string(expected) + " for " + std::to_string(image.width) + " x " +
                        std::to_string(image.height)};
}

bool is_opaque(const Image& image) {
    for (std::size_t i = k_channels - 1; i < image.texels.size(); i += k_channels)
        if (image.texels[i] != std::byte{255}) return false;
    return true;
}

std::vector<std::byte> encode(const char* format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                              const void* texels, std::size_t texel_stride, const std::string& name) {
    auto output = OIIO::ImageOutput::create(format);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory{bytes};
    const bool written = output && output->set_ioproxy(&memory) && output->open(name, spec) &&
                         output->write_image(type, texels, static_cast<OIIO::stride_t>(texel_stride)) &&
                         output->close();
    if (!written) {
        // Taken even if not used, so that OpenImageIO does not print it at exit.
        const std::string global = OIIO::geterror();
        throw Error{name, "", "cannot be encoded: " + (output ? output->geterror() : global), ""};
    }
    const auto* const first = reinterpret_cast<const std::byte*>(bytes.data());
    return {first, first + bytes.size()};
}

std::vector<std::byte> encode_exr(const Image& image, const std::string& name) {
    if (image.format != PixelFormat::rgba32f)
        throw Error{name, "", "an image of bytes", "one of floats for EXR"};
    check_texels(image, name);
    constexpr float k_largest_half = 65504.0f;
    std::vector<float> values(image.texels.size() / sizeof(float));
    std::memcpy(values.data(), image.texels.data(), image.texels.size());
    for (float& value : values)
        if (std::abs(value) > k_largest_half) value = std::copysign(k_largest_half, value);
    OIIO::ImageSpec spec{static_cast<int>(image.width), static_cast<int>(image.height),
                         static_cast<int>(k_channels), OIIO::TypeDesc::HALF};
    spec.attribute("compression", "zip");
    return encode("openexr", spec, OIIO::TypeDesc::FLOAT, values.data(), k_channels * sizeof(float), name);
}

fs::path temporary_beside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    fs::path name = file;
    name += fmt::format(".{}-{}.tmp", ::getpid(), counter++);
    return name;
}

}  // namespace

std::vector<std::byte> encode_png(const Image& image) {
    const std::string name = image.name.empty() ? "image.png" : image.name;
    if (image.format != PixelFormat::rgba8)
        throw Error{name, "", "an image of floats", "one of bytes for PNG"};
    check_texels(image, name);
    const int channels = is_opaque(image) ? 3 : 4;
    OIIO::ImageSpec spec{static_cast<int>(image.width), static_cast<int>(image.height), channels,
                         OIIO::TypeDesc::UINT8};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("png:compressionLevel", k_png_level);
    return encode("png", spec, OIIO::TypeDesc::UINT8, image.texels.data(), k_channels, name);
}

void write_image(const fs::path& file, const Image& image) {
    const std::string extension = file.extension().string();
    if (extension == ".png") {
        Image named = image;
        named.name = file.string();
        write_bytes(file, encode_png(named));
    } else if (extension == ".exr") {
        write_bytes(file, encode_exr(image, file.string()));
    } else {
        throw Error{file.string(), "", fmt::format("the extension \"{}\"", extension), ".png or .exr"};
    }
}

void write_text(const fs::path& file, const std::string& text) {
    write_bytes(file, std::as_bytes(std::span{text}));
}

void write_bytes(const fs::path& file, std::span<const std::byte> bytes) {
    std::error_code failed;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), failed);
    const fs::path temporary = temporary_beside(file);
    {
        std::ofstream stream{temporary, std::ios::binary};
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) {
            fs::remove(temporary, failed);
            throw Error{file.string(), "", "cannot be written", "a writable folder with room"};
        }
    }
    fs::rename(temporary, file, failed);
    if (!failed) return;
    const std::string reason = failed.message();
    fs::remove(temporary, failed);
    throw Error{file.string(), "", "cannot be written: " + reason, ""};
}

}  // namespace rambla::assets
