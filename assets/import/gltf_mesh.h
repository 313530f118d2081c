#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.meshes` and `scene.models`: one model for each mesh of the document, so that indices agree.
/// Primitives of the same accessors share one mesh. The materials must be there already. @throws Error
void import_meshes(Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
