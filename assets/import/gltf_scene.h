#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.cameras`, `scene.lights` and `scene.nodes`, index for index, with their levels of detail, and
/// the roots of the default scene. The models must be there already. @throws Error  for dangling references,
/// nodes with two parents, and loops
void import_nodes(const Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
