#pragma once

#include <cstdint>
#include <vector>

#include "assets/import/gltf_document.h"
#include "assets/import/gltf_mesh.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills an empty scene with what a document says, without what is computed from it: pictures are not
/// decoded, textures not imported (the materials' slots hold the document's indices), missing columns and
/// bounds of meshes not filled.
/// @return  for each of the scene's meshes, what complete_meshes has to do
/// @throws Error
[[nodiscard]] std::vector<MissingColumns> convert_data(Document& document, Scene& scene);

/// Fills an empty scene with all that a document holds.
/// @return  for each of the scene's images the document's image that it shows, k_none for a placeholder
/// @throws Error
std::vector<std::uint32_t> convert(Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
