#include "render/level_upload.h"

#include <algorithm>
#include <array>

namespace rambla::render {

namespace {

constexpr std::uint32_t k_block_side = 4;

GLenum gl_format(assets::TexelFormat format, bool srgb) {
    switch (format) {
        case assets::TexelFormat::rgba8:
            return srgb ? GLenum{GL_SRGB8_ALPHA8} : GLenum{GL_RGBA8};
        case assets::TexelFormat::rgba32f:
            return GL_RGBA16F;
        case assets::TexelFormat::bc1:
            return srgb ? GLenum{GL_COMPRESSED_SRGB_S3TC_DXT1_EXT} : GLenum{GL_COMPRESSED_RGB_S3TC_DXT1_EXT};
        case assets::TexelFormat::bc3:
            return srgb ? GLenum{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}
                        : GLenum{GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};
        case assets::TexelFormat::bc4:
            return GL_COMPRESSED_RED_RGTC1;
        case assets::TexelFormat::bc5:
            return GL_COMPRESSED_RG_RGTC2;
    }
    return GL_RGBA8;
}

GLenum format_of(const assets::TextureData& image) {
    return gl_format(image.format, image.colour_space == assets::ColourSpace::srgb);
}

GLint gl_source(assets::ChannelSource source) {
    switch (source) {
        case assets::ChannelSource::red:
            return GL_RED;
        case assets::ChannelSource::green:
            return GL_GREEN;
        case assets::ChannelSource::blue:
            return GL_BLUE;
        case assets::ChannelSource::alpha:
            return GL_ALPHA;
        case assets::ChannelSource::zero:
            return GL_ZERO;
        case assets::ChannelSource::one:
            return GL_ONE;
    }
    return GL_ONE;
}

}  // namespace

gl::TextureDesc describe_levels(const assets::TextureData& image, std::uint32_t first) {
    return {.format = format_of(image),
            .size = {image.levels[first].width, image.levels[first].height},
            .levels = static_cast<std::uint32_t>(image.levels.size()) - first};
}

gl::Texture make_level_texture(const assets::TextureData& image, std::uint32_t first) {
    gl::Texture texture{image.name, describe_levels(image, first)};
    std::array<GLint, 4> swizzle{};
    std::transform(image.swizzle.begin(), image.swizzle.end(), swizzle.begin(), gl_source);
    glTextureParameteriv(texture.name(), GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
    return texture;
}

std::uint32_t row_step(const assets::TextureData& image) {
    return gl::bytes_per_block(format_of(image)) > 0 ? k_block_side : 1;
}

std::size_t row_step_bytes(const assets::TextureData& image, std::uint32_t level) {
    const assets::TextureLevel& of = image.levels[level];
    const std::uint32_t step = row_step(image);
    return of.size / ((of.height + step - 1) / step);
}

void upload_rows(const gl::Texture& texture, std::uint32_t first, const assets::TextureData& image,
                 std::uint32_t level, std::span<const std::byte> bytes, std::uint32_t first_row,
                 std::uint32_t row_count) {
    const assets::TextureLevel& of = image.levels[level];
    const std::uint32_t step = row_step(image);
    const std::uint32_t rows = std::min(row_count, of.height - first_row);
    const std::size_t row_bytes = row_step_bytes(image, level);
    const std::span<const std::byte> part =
        bytes.subspan(first_row / step * row_bytes, (rows + step - 1) / step * row_bytes);
    const auto number = static_cast<GLint>(level - first);
    const auto y = static_cast<GLint>(first_row);
    const auto width = static_cast<GLsizei>(of.width);
    const auto height = static_cast<GLsizei>(rows);
    if (step > 1) {
        glCompressedTextureSubImage2D(texture.name(), number, 0, y, width, height, texture.desc().format,
                                      static_cast<GLsizei>(part.size()), part.data());
    } else {
        const GLenum type = image.format == assets::TexelFormat::rgba32f ? GL_FLOAT : GL_UNSIGNED_BYTE;
        glTextureSubImage2D(texture.name(), number, 0, y, width, height, GL_RGBA, type, part.data());
    }
}

void copy_levels(const gl::Texture& from, std::uint32_t from_first, const gl::Texture& to,
                 std::uint32_t to_first, const assets::TextureData& image, std::uint32_t level) {
    for (; level < image.levels.size(); ++level) {
        glCopyImageSubData(from.name(), GL_TEXTURE_2D, static_cast<GLint>(level - from_first), 0, 0, 0,
                           to.name(), GL_TEXTURE_2D, static_cast<GLint>(level - to_first), 0, 0, 0,
                           static_cast<GLsizei>(image.levels[level].width),
                           static_cast<GLsizei>(image.levels[level].height), 1);
    }
}

}  // namespace rambla::render
