#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/lod.h"
#include "assets/mesh.h"

namespace rambla::assets {

/// Lets indices of vertices that are equal in every column, bit for bit, name the first of them. No vertex is
/// dropped: order_vertices does that.
void merge_identical_vertices(Mesh& mesh);

/// Reorders the triangles of a list for the vertex cache, then against overdraw (meshoptimizer; Sander et al.
/// 2007, "Fast triangle reordering for vertex locality and reduced overdraw").
/// @param overdraw_threshold  how much worse than the best the vertex cache may do, ≥ 1; 1.05 is 5 %
void order_triangles(std::span<std::uint32_t> indices, std::span<const glm::vec3> positions,
                     float overdraw_threshold = 1.05f);

/// New places for vertices, in the order of their first use, and none for those that are not used.
struct VertexOrder {
    std::vector<std::uint32_t> kept;  ///< old index of each new vertex
    std::vector<std::uint32_t> now;   ///< new index of each old vertex; k_dropped where it is not used
    static constexpr std::uint32_t k_dropped = 0xffffffffu;
};
[[nodiscard]] VertexOrder order_of_first_use(std::span<const std::uint32_t> indices,
                                             std::size_t vertex_count);

/// Puts vertices into the order in which the mesh's indices first use them and drops the others, in all
/// columns. Works for every topology. The levels of `chain` may use no vertex that the mesh itself does not.
void order_vertices(Mesh& mesh, LodChain& chain);

/// Orders triangles, of the mesh and of each level of its chain, and then vertices; meshes of lines and
/// points keep their order of elements. The picture is the same up to the order of triangles.
void optimise(Mesh& mesh, LodChain& chain, float overdraw_threshold = 1.05f);

}  // namespace rambla::assets
