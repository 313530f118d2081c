#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.materials`, index for index. Their slots hold indices of the document's textures until
/// import_textures replaces them. @throws Error
void import_materials(const Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
