#pragma once

#include <cstdint>
#include <vector>

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills an empty scene with all that a document holds.
/// @return  for each of the scene's images the document's image that it shows, k_none for a placeholder
/// @throws Error
std::vector<std::uint32_t> convert(Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
