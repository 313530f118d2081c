#include "render/scene_textures.h"

#include <array>
#include <cstdint>
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

SceneTextures upload_textures(const assets::ProcessedScene& scene,
                              std::shared_ptr<assets::LevelSource> source) {
    SceneTextures result;
    // 128/255 is the byte nearest to zero of the usual 2x − 1; shaders leave the normal alone where a
    // material has no normal texture, so the half step is never seen.
    result.white_image = one_texel("white", {255, 255, 255, 255});
    result.flat_normal_image = one_texel("flat normal", {128, 128, 255, 255});
    const GLuint nearest = sampler_of({}, result.samplers);
    result.white = {assets::k_none, result.white_image.name(), nearest};
    result.flat_normal = {assets::k_none, result.flat_normal_image.name(), nearest};

    result.images = std::make_unique<TextureResidency>(scene.images, std::move(source));
    for (const assets::Texture& texture : scene.textures) {
        result.textures.push_back({texture.image, result.images->name(texture.image),
                                   sampler_of(describe(texture.sampler), result.samplers)});
    }
    return result;
}

}  // namespace rambla::render
