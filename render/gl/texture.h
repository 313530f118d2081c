#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

#include "render/gl/object.h"

namespace rambla::render::gl {

struct DeleteTexture {
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct DeleteSampler {
    static void destroy(GLuint name) { glDeleteSamplers(1, &name); }
};

/// Size and format of a texture: textures with equal descriptions can stand in for each other.
struct TextureDesc {
    GLenum target = GL_TEXTURE_2D;  ///< GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY
    GLenum format = GL_RGBA8;       ///< sized internal format
    glm::uvec2 size{1};
    std::uint32_t layers = 1;
    std::uint32_t levels = 1;

    bool operator==(const TextureDesc&) const = default;
};

/// Bytes of one texel of an uncompressed sized format; asserts on formats that the renderer does not use.
[[nodiscard]] std::uint32_t bytes_per_texel(GLenum format);
/// Bytes of one block of 4×4 texels of a block-compressed format; 0 for all other formats.
[[nodiscard]] std::uint32_t bytes_per_block(GLenum format);
/// Bytes of all levels and layers.
[[nodiscard]] std::uint64_t storage_bytes(const TextureDesc& desc);
/// Levels of a full mip chain.
[[nodiscard]] std::uint32_t full_levels(glm::uvec2 size);
[[nodiscard]] bool is_depth(GLenum format);
/// Of unsigned integers, which shaders read by a usampler.
[[nodiscard]] bool is_integer(GLenum format);

/// Immutable storage.
class Texture {
public:
    Texture() = default;
    Texture(std::string_view name, const TextureDesc& desc);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] const TextureDesc& desc() const { return desc_; }
    [[nodiscard]] std::uint64_t bytes() const { return object_.bytes(); }
    /// Unique in the process, where GL names are used again: a safe key for caches.
    [[nodiscard]] std::uint64_t id() const { return id_; }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(object_); }

private:
    Object<DeleteTexture> object_;
    TextureDesc desc_;
    std::uint64_t id_ = 0;
};

struct SamplerDesc {
    GLenum minify = GL_NEAREST;
    GLenum magnify = GL_NEAREST;
    GLenum wrap_u = GL_CLAMP_TO_EDGE;
    GLenum wrap_v = GL_CLAMP_TO_EDGE;
    GLenum compare = GL_NONE;  ///< GL_NONE, or the function of a depth comparison such as GL_GEQUAL

    bool operator==(const SamplerDesc&) const = default;
};

class Sampler {
public:
    Sampler() = default;
    Sampler(std::string_view name, const SamplerDesc& desc);

    [[nodiscard]] GLuint name() const { return object_.name(); }
    [[nodiscard]] const SamplerDesc& desc() const { return desc_; }

private:
    Object<DeleteSampler> object_;
    SamplerDesc desc_;
};

}  // namespace rambla::render::gl
