#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "assets/processed.h"
#include "render/gl/buffer.h"
#include "render/scene_textures.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/material.h"

namespace rambla::render {

/// Textures that a material may have.
inline constexpr std::size_t k_material_units = UNIT_BESIDE_MATERIALS;

/// Names to bind for one material, in the order of the units UNIT_BASE_COLOUR … UNIT_LIGHT_MAP.
struct MaterialSlots {
    std::array<GLuint, k_material_units> textures{};
    std::array<GLuint, k_material_units> samplers{};
};

/// Where an image is bound.
struct SlotOfImage {
    std::uint32_t material = 0;
    std::uint32_t unit = 0;
};

/// The materials of a scene, and behind them glTF's default.
struct SceneMaterials {
    std::vector<assets::Material> materials;
    std::vector<MaterialSlots> slots;
    std::vector<std::vector<SlotOfImage>> slots_of_images;
    gl::Buffer buffer;  ///< of shared::Material
};

/// @param normal_z_is_missing  of the normal texture
[[nodiscard]] shared::Material shader_material(const assets::Material& material, bool normal_z_is_missing);
[[nodiscard]] SceneMaterials upload_materials(const assets::ProcessedScene& scene,
                                              const SceneTextures& textures);

/// Binds another texture wherever an image is bound.
void rebind_image(SceneMaterials& materials, std::uint32_t image, GLuint texture);

}  // namespace rambla::render
