#include "render/scene_textures.h"

#include <array>
#include <cstdint>
#include <map>
#include <utility>

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

// Row 0 of an image, its top, becomes the texture's first row, so that v = 0 is the top as glTF has it.
gl::Texture upload_image(const assets::Image& image, assets::ColourSpace space) {
    const bool is_float = image.format == assets::PixelFormat::rgba32f;
    GLenum format = GL_RGBA8;
    if (is_float) {
        format = GL_RGBA16F;
    } else if (space == assets::ColourSpace::srgb) {
        format = GL_SRGB8_ALPHA8;
    }
    const glm::uvec2 size{image.width, image.height};
    gl::Texture texture{image.name, {.format = format, .size = size, .levels = gl::full_levels(size)}};
    glTextureSubImage2D(texture.name(), 0, 0, 0, static_cast<GLsizei>(size.x), static_cast<GLsizei>(size.y),
                        GL_RGBA, is_float ? GL_FLOAT : GL_UNSIGNED_BYTE, image.texels.data());
    glGenerateTextureMipmap(texture.name());
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

SceneTextures upload_textures(const assets::Scene& scene) {
    SceneTextures result;
    // 128/255 is the byte nearest to zero of the usual 2x − 1; shaders leave the normal alone where a
    // material has no normal texture, so the half step is never seen.
    result.white_image = one_texel("white", {255, 255, 255, 255});
    result.flat_normal_image = one_texel("flat normal", {128, 128, 255, 255});
    const GLuint nearest = sampler_of({}, result.samplers);
    result.white = {result.white_image.name(), nearest};
    result.flat_normal = {result.flat_normal_image.name(), nearest};

    std::map<std::pair<std::uint32_t, assets::ColourSpace>, GLuint> uploaded;
    for (const assets::Texture& texture : scene.textures) {
        BoundTexture bound = result.white;
        if (texture.image != assets::k_none && scene.images[texture.image].width > 0) {
            GLuint& name = uploaded[{texture.image, texture.colour_space}];
            if (name == 0) {
                result.images.push_back(upload_image(scene.images[texture.image], texture.colour_space));
                name = result.images.back().name();
            }
            bound = {name, sampler_of(describe(texture.sampler), result.samplers)};
        }
        result.textures.push_back(bound);
    }
    return result;
}

}  // namespace rambla::render
