#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assets/processed.h"
#include "assets/texture_levels.h"
#include "render/gl/texture.h"
#include "render/texture_residency.h"

namespace rambla::render {

/// A texture and how it is sampled, as names to bind.
struct BoundTexture {
    std::uint32_t image = assets::k_none;  ///< whose levels come and go, and the name with them; or none
    GLuint texture = 0;
    GLuint sampler = 0;
};

/// The textures of a scene, each image once.
struct SceneTextures {
    std::unique_ptr<TextureResidency> images;
    std::vector<gl::Sampler> samplers;
    std::vector<BoundTexture> textures;  ///< by assets::ProcessedScene::textures, as at first
    gl::Texture white_image;
    gl::Texture flat_normal_image;
    BoundTexture white;        ///< neutral for everything but normals
    BoundTexture flat_normal;  ///< (0, 0, 1)
};

/// @param source  of the levels that the scene does not hold; none: those do not come
[[nodiscard]] SceneTextures upload_textures(const assets::ProcessedScene& scene,
                                            std::shared_ptr<assets::LevelSource> source);

}  // namespace rambla::render
