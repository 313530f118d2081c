#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.clips`, index for index. What can be is mended (see gltf_keys.h), with one warning for each
/// clip; channels without a node, without keys, with an unknown path, for a node and path that another
/// channel moves already, or for weights of a node without morph targets are left out. Nodes and models must
/// be there already. @throws Error  for dangling references and accessors of another form or length
void import_clips(Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
