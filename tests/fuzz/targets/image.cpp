#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "assets/error.h"
#include "assets/import/image.h"
#include "fuzz/target.h"

namespace rambla::fuzz {
namespace {

constexpr std::uint32_t k_largest_px = 2048;

void decode(Bytes bytes, const char* name) {
    try {
        const assets::Image image = assets::decode_image(bytes, name, {.size_px = k_largest_px});
        const std::size_t expected =
            std::size_t{image.width} * image.height * assets::bytes_per_texel(image.format);
        if (image.width == 0 || image.height == 0 || image.width > k_largest_px ||
            image.height > k_largest_px)
            broken("a picture keeps to the limits of its size");
        if (image.texels.size() != expected) broken("a picture has as many texels as its size says");
    } catch (const assets::Error& error) {
        if (std::string_view{error.what()}.find('\n') != std::string_view::npos)
            broken("an error is one line");
    }
}

/// CRC-32 of ISO 3309, bit by bit.
std::uint32_t crc(Bytes bytes) {
    std::uint32_t c = 0xffffffffu;
    for (const std::byte byte : bytes) {
        c ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            c = (c >> 1) ^ ((c & 1) != 0 ? 0xedb88320u : 0u);
    }
    return ~c;
}

std::uint32_t word(Bytes bytes, std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4; ++i)
        out = out << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return out;
}

/// The same PNG with right check sums, without which no mutation would get past them.
std::vector<std::byte> with_sums(Bytes bytes) {
    std::vector<std::byte> out{bytes.begin(), bytes.end()};
    for (std::size_t at = 8; at + 12 <= out.size();) {
        const std::uint64_t length = word(out, at);
        if (length > out.size() - at - 12) break;
        const std::uint32_t sum = crc(Bytes{out}.subspan(at + 4, length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            out[at + 8 + length + i] = static_cast<std::byte>(sum >> (24 - 8 * i) & 0xff);
        at += length + 12;
    }
    return out;
}

/// The input is a picture file.
void run(Bytes bytes) {
    constexpr std::string_view k_png = "\x89PNG\r\n\x1a\n";
    decode(bytes, "input");
    if (bytes.size() >= k_png.size() && std::memcmp(bytes.data(), k_png.data(), k_png.size()) == 0)
        decode(with_sums(bytes), "input");
    decode(bytes, "input.tga");
}

void write(const SeedTaker& take, const char* format, int channels, OIIO::TypeDesc type, const char* option,
           const char* value) {
    OIIO::ImageSpec spec{5, 4, channels, type};
    if (option != nullptr) spec.attribute(option, value);
    std::vector<float> values(static_cast<std::size_t>(5 * 4 * channels));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i * 37 % 101) / 100.0f;
    auto output = OIIO::ImageOutput::create(format);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory{bytes};
    const std::string name = std::string{format} + "-" + std::to_string(channels) + "-" + type.c_str() + "-" +
                             (value == nullptr ? "plain" : value);
    if (!output || !output->set_ioproxy(&memory) || !output->open(name, spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !output->close())
        broken("a seed can be written: " + name + ": " + OIIO::geterror());
    take(name, std::as_bytes(std::span{bytes}));
}

void seeds(const SeedTaker& take) {
    using OIIO::TypeDesc;
    for (const int channels : {1, 2, 3, 4})
        for (const TypeDesc type : {TypeDesc::UINT8, TypeDesc::UINT16})
            write(take, "png", channels, type, nullptr, nullptr);
    for (const int channels : {1, 3})
        write(take, "jpeg", channels, TypeDesc::UINT8, nullptr, nullptr);
    for (const char* const compression : {"none", "rle", "zip", "piz", "pxr24", "b44", "dwaa"})
        write(take, "openexr", 4, TypeDesc::HALF, "compression", compression);
    for (const char* const compression : {"none", "lzw", "zip", "packbits"})
        write(take, "tiff", 3, TypeDesc::UINT8, "compression", compression);
    write(take, "tiff", 1, TypeDesc::FLOAT, nullptr, nullptr);
    for (const char* const compression : {"none", "rle"})
        write(take, "targa", 4, TypeDesc::UINT8, "compression", compression);
}

const Registration k_image{{"image", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
