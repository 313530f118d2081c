#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.skeletons`, index for index, and `Node::skeleton`. Missing inverse bind matrices are
/// identity, one that is not affine is mended with a warning. Meshes and nodes must be there already.
/// @throws Error  for joints that are no node, and vertices that follow a joint that the skin has not
void import_skins(const Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
