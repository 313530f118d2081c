#pragma once

#include <array>
#include <vector>

#include "assets/processed.h"
#include "render/gl/buffer.h"
#include "render/scene_textures.h"
#include "render/shaders/shared/material.h"

namespace rambla::render {

/// Names to bind for one material, in the order of the units UNIT_BASE_COLOUR … UNIT_EMISSIVE.
struct MaterialSlots {
    std::array<GLuint, 5> textures{};
    std::array<GLuint, 5> samplers{};
};

/// The materials of a scene, and behind them glTF's default.
struct SceneMaterials {
    std::vector<assets::Material> materials;
    std::vector<MaterialSlots> slots;
    gl::Buffer buffer;  ///< of shared::Material
};

/// @param normal_z_is_missing  of the normal texture
[[nodiscard]] shared::Material shader_material(const assets::Material& material, bool normal_z_is_missing);
[[nodiscard]] SceneMaterials upload_materials(const assets::ProcessedScene& scene,
                                              const SceneTextures& textures);

}  // namespace rambla::render
