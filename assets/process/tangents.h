#pragma once

#include <cstdint>

#include "assets/mesh.h"

namespace rambla::assets {

/// Fills `normals` of a triangle mesh with area-weighted smooth normals over shared indices; degenerate
/// triangles contribute nothing, isolated vertices get +Y.
void compute_normals(Mesh& mesh);

/// Splits every triangle's vertices and gives each triangle its own normal, as glTF asks for where normals
/// are missing. Degenerate triangles get +Y. Indices afterwards count up from 0. Morph targets get what
/// their positions at weight 1 do to these normals.
void compute_flat_normals(Mesh& mesh);

/// Fills `tangents` from texture coordinates by Gram–Schmidt (Fahlén 2005, eq. 6.2–6.5); where they are
/// degenerate or absent, any unit vector perpendicular to the normal. Conventions of MikkTSpace (Mikkelsen
/// 2008): faces weigh by their angle at the vertex, seen along its normal; vertices of equal position,
/// normal, texture coordinates and handedness share a tangent, whatever their indices; and w · (normal ×
/// tangent) points along decreasing v of the image (v grows downwards), as glTF has it. Other than there,
/// such vertices share it even where no edge joins their faces. A vertex that faces with mirrored and
/// unmirrored coordinates share is split in two in all columns, the new one appended.
/// @param mesh    triangles with normals
/// @param uv_set  0 or 1
void compute_tangents(Mesh& mesh, std::uint32_t uv_set = 0);

/// Some unit vector perpendicular to a unit vector. Duff et al. 2017, "Building an orthonormal basis,
/// revisited".
[[nodiscard]] glm::vec3 any_perpendicular(glm::vec3 normal);

}  // namespace rambla::assets
