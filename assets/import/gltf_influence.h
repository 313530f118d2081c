#pragma once

#include "assets/import/gltf_vertices.h"
#include "assets/mesh.h"

namespace rambla::assets::gltf {

/// Whether a primitive names joints.
[[nodiscard]] bool is_skinned(const Attributes& attributes);

/// Fills `joints` and `weights` of a mesh from JOINTS_n and WEIGHTS_n. Of more than four joints the strongest
/// four stay, with a warning; weights are made to sum up to 1; a vertex without weights follows the joint
/// that it names first, with a warning. @throws Error
void read_influences(VertexReader& reader, const Attributes& attributes, Mesh& mesh);

}  // namespace rambla::assets::gltf
