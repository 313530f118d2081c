#include "render/gl/texture.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "assets/assert.h"

namespace rambla::render::gl {

std::uint32_t bytes_per_texel(GLenum format) {
    switch (format) {
        case GL_R8:
            return 1;
        case GL_RG8:
        case GL_R16:
        case GL_R16F:
        case GL_DEPTH_COMPONENT16:
            return 2;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_RGB10_A2:
        case GL_R11F_G11F_B10F:
        case GL_RG16:
        case GL_RG16F:
        case GL_R32F:
        case GL_R32UI:
        case GL_DEPTH_COMPONENT32F:
            return 4;
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_RG32F:
        case GL_RG32UI:
            return 8;
        case GL_RGBA32F:
            return 16;
        default:
            RAMBLA_ASSERT(false, "every format in use stands in this table");
            return 0;
    }
}

std::uint32_t bytes_per_block(GLenum format) {
    switch (format) {
        case GL_COMPRESSED_RGB_S3TC_DXT1_EXT:
        case GL_COMPRESSED_SRGB_S3TC_DXT1_EXT:
        case GL_COMPRESSED_RED_RGTC1:
            return 8;
        case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT:
        case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT:
        case GL_COMPRESSED_RG_RGTC2:
            return 16;
        default:
            return 0;
    }
}

std::uint64_t storage_bytes(const TextureDesc& desc) {
    constexpr std::uint32_t k_block_side = 4;
    const std::uint32_t block_bytes = bytes_per_block(desc.format);
    std::uint64_t units = 0;  // blocks, or else texels
    for (std::uint32_t level = 0; level < desc.levels; ++level) {
        glm::uvec2 size{std::max(desc.size.x >> level, 1u), std::max(desc.size.y >> level, 1u)};
        if (block_bytes > 0) size = (size + k_block_side - 1u) / k_block_side;
        units += std::uint64_t{size.x} * size.y;
    }
    return units * desc.layers * (block_bytes > 0 ? block_bytes : bytes_per_texel(desc.format));
}

std::uint32_t full_levels(glm::uvec2 size) {
    return static_cast<std::uint32_t>(std::bit_width(std::max({size.x, size.y, 1u})));
}

bool is_depth(GLenum format) {
    return format == GL_DEPTH_COMPONENT16 || format == GL_DEPTH_COMPONENT32F;
}

bool is_integer(GLenum format) {
    return format == GL_R32UI || format == GL_RG32UI;
}

namespace {

GLuint create_texture(GLenum target) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return name;
}

GLuint create_sampler() {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    return name;
}

std::uint64_t next_id() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace

Texture::Texture(std::string_view name, const TextureDesc& desc)
    : object_{create_texture(desc.target), storage_bytes(desc)}, desc_{desc}, id_{next_id()} {
    const auto width = static_cast<GLsizei>(desc.size.x);
    const auto height = static_cast<GLsizei>(desc.size.y);
    const auto levels = static_cast<GLsizei>(desc.levels);
    if (desc.target == GL_TEXTURE_2D) {
        glTextureStorage2D(object_.name(), levels, desc.format, width, height);
    } else {
        glTextureStorage3D(object_.name(), levels, desc.format, width, height,
                           static_cast<GLsizei>(desc.layers));
    }
    label(GL_TEXTURE, object_.name(), name);
}

Sampler::Sampler(std::string_view name, const SamplerDesc& desc) : object_{create_sampler()}, desc_{desc} {
    const auto set = [&](GLenum parameter, GLenum value) {
        glSamplerParameteri(object_.name(), parameter, static_cast<GLint>(value));
    };
    set(GL_TEXTURE_MIN_FILTER, desc.minify);
    set(GL_TEXTURE_MAG_FILTER, desc.magnify);
    set(GL_TEXTURE_WRAP_S, desc.wrap_u);
    set(GL_TEXTURE_WRAP_T, desc.wrap_v);
    if (desc.compare != GL_NONE) {
        set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        set(GL_TEXTURE_COMPARE_FUNC, desc.compare);
    }
    label(GL_SAMPLER, object_.name(), name);
}

}  // namespace rambla::render::gl
