#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// MSFT_lod: fills `coarser` and `screen_coverage` of the nodes. A node that stands in the scene on its own,
/// or serves another node already, cannot be a level: then the node's levels are left out with a warning.
/// Parents and roots must be known already.
/// @return  for each node, whether it is a level of another
/// @throws Error  for dangling references
[[nodiscard]] std::vector<bool> import_levels(const Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
