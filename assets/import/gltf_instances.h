#pragma once

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// EXT_mesh_gpu_instancing: a node's model moves to new children of it, one for each instance, behind all
/// other nodes. Skeletons and morph weights go with it; nodes must have theirs already. @throws Error
void import_instances(Document& document, Scene& scene);

}  // namespace rambla::assets::gltf
