#include "render/scene_textures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rambla::render {

namespace {

GLenum gl_wrap(assets::WrapMode mode) {
    switch (mode) {
        case assets::WrapMode::repeat:
            return GL_REPEAT;
        case assets::WrapMode::mirrored_repeat:
            return GL_MIRRORED_REPEAT;
        case assets::WrapMode::clamp_to_edge:
            return GL_CLAMP_TO_EDGE;
    }
    return GL_REPEAT;
}

GLenum gl_minify(const assets::Sampler& sampler) {
    const bool linear = sampler.minify == assets::Filter::linear;
    switch (sampler.mip) {
        case assets::MipFilter::none:
            return linear ? GL_LINEAR : GL_NEAREST;
        case assets::MipFilter::nearest:
            return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
        case assets::MipFilter::linear:
            return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_LINEAR;
}

gl::SamplerDesc describe(const assets::Sampler& sampler) {
    return {.minify = gl_minify(sampler),
            .magnify = sampler.magnify == assets::Filter::linear ? GLenum{GL_LINEAR} : GLenum{GL_NEAREST},
            .wrap_u = gl_wrap(sampler.wrap_u),
            .wrap_v = gl_wrap(sampler.wrap_v)};
}

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

// Row 0 of an image, its top, becomes the texture's first row, so that v = 0 is the top as glTF has it.
gl::Texture upload_image(const assets::TextureData& image) {
    const GLenum format = gl_format(image.format, image.colour_space == assets::ColourSpace::srgb);
    gl::Texture texture{image.name,
                        {.format = format,
                         .size = {image.levels[0].width, image.levels[0].height},
                         .levels = static_cast<std::uint32_t>(image.levels.size())}};
    const GLenum type = image.format == assets::TexelFormat::rgba32f ? GL_FLOAT : GL_UNSIGNED_BYTE;
    for (GLint number = 0; number < static_cast<GLint>(image.levels.size()); ++number) {
        const assets::TextureLevel& level = image.levels[static_cast<std::size_t>(number)];
        const auto width = static_cast<GLsizei>(level.width);
        const auto height = static_cast<GLsizei>(level.height);
        const std::byte* const bytes = image.bytes.data() + level.offset;
        if (gl::bytes_per_block(format) > 0) {
            glCompressedTextureSubImage2D(texture.name(), number, 0, 0, width, height, format,
                                          static_cast<GLsizei>(level.size), bytes);
        } else {
            glTextureSubImage2D(texture.name(), number, 0, 0, width, height, GL_RGBA, type, bytes);
        }
    }
    std::array<GLint, 4> swizzle{};
    std::transform(image.swizzle.begin(), image.swizzle.end(), swizzle.begin(), gl_source);
    glTextureParameteriv(texture.name(), GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
    return texture;
}

gl::Texture one_texel(const char* name, std::array<std::uint8_t, 4> value) {
    gl::Texture texture{name, {.format = GL_RGBA8, .size = glm::uvec2{1}}};
    glTextureSubImage2D(texture.name(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, value.data());
    return texture;
}

GLuint sampler_of(const gl::SamplerDesc& desc, std::vector<gl::Sampler>& samplers) {
    for (const gl::Sampler& sampler : samplers) {
        if (sampler.desc() == desc) return sampler.name();
    }
    samplers.emplace_back("material", desc);
    return samplers.back().name();
}

}  // namespace

SceneTextures upload_textures(const assets::ProcessedScene& scene) {
    SceneTextures result;
    // 128/255 is the byte nearest to zero of the usual 2x − 1; shaders leave the normal alone where a
    // material has no normal texture, so the half step is never seen.
    result.white_image = one_texel("white", {255, 255, 255, 255});
    result.flat_normal_image = one_texel("flat normal", {128, 128, 255, 255});
    const GLuint nearest = sampler_of({}, result.samplers);
    result.white = {result.white_image.name(), nearest};
    result.flat_normal = {result.flat_normal_image.name(), nearest};

    for (const assets::TextureData& image : scene.images)
        result.images.push_back(upload_image(image));
    for (const assets::Texture& texture : scene.textures) {
        result.textures.push_back(
            {result.images[texture.image].name(), sampler_of(describe(texture.sampler), result.samplers)});
    }
    return result;
}

}  // namespace rambla::render
