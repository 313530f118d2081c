#pragma once

#include <vector>

#include "assets/processed.h"
#include "render/gl/texture.h"

namespace rambla::render {

/// A texture and how it is sampled, as names to bind.
struct BoundTexture {
    GLuint texture = 0;
    GLuint sampler = 0;
};

/// The textures of a scene, each image once, with the mip levels that it has.
struct SceneTextures {
    std::vector<gl::Texture> images;  ///< by assets::ProcessedScene::images
    std::vector<gl::Sampler> samplers;
    std::vector<BoundTexture> textures;  ///< by assets::ProcessedScene::textures
    gl::Texture white_image;
    gl::Texture flat_normal_image;
    BoundTexture white;        ///< neutral for everything but normals
    BoundTexture flat_normal;  ///< (0, 0, 1)
};

[[nodiscard]] SceneTextures upload_textures(const assets::ProcessedScene& scene);

}  // namespace rambla::render
