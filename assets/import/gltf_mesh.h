#pragma once

#include <span>
#include <vector>

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

inline constexpr int k_no_tangents = -1;

/// What must be computed for a mesh, beside normals where it has none.
struct MissingColumns {
    int tangents_for_uv_set = k_no_tangents;
};

/// Fills `scene.meshes` with what the file holds, and `scene.models`: one model for each mesh of the
/// document, so that indices agree. Primitives of the same accessors share one mesh. The materials must be
/// there already.
/// @return  for each mesh, what complete_meshes has to do
/// @throws Error
[[nodiscard]] std::vector<MissingColumns> import_meshes(Document& document, Scene& scene);

/// Computes missing normals and tangents, and the bounds, on all threads.
void complete_meshes(Scene& scene, std::span<const MissingColumns> missing);

}  // namespace rambla::assets::gltf
