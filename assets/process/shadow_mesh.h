#pragma once

#include "assets/lod.h"
#include "assets/mesh.h"

namespace rambla::assets {

/// Positions, and what moves them, without the seams of normals, texture coordinates and colours. Triangles
/// that have no area for want of three different vertices are left out; the others are ordered for the vertex
/// cache.
/// @param mesh  triangles; other topologies cast no shadow and give nothing
[[nodiscard]] ShadowMesh shadow_mesh(const Mesh& mesh, const LodChain& chain);

}  // namespace rambla::assets
