#pragma once

#include <vector>

#include "assets/scene.h"
#include "render/gl/texture.h"

namespace rambla::render {

/// A texture and how it is sampled, as names to bind.
struct BoundTexture {
    GLuint texture = 0;
    GLuint sampler = 0;
};

/// The textures of a scene. An image that is used in both colour spaces is uploaded once for each.
struct SceneTextures {
    std::vector<gl::Texture> images;
    std::vector<gl::Sampler> samplers;
    std::vector<BoundTexture> textures;  ///< by assets::Scene::textures
    gl::Texture white_image;
    gl::Texture flat_normal_image;
    BoundTexture white;        ///< neutral for everything but normals
    BoundTexture flat_normal;  ///< (0, 0, 1)
};

[[nodiscard]] SceneTextures upload_textures(const assets::Scene& scene);

}  // namespace rambla::render
