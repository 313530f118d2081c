#include "assets/process/optimise.h"

#include <meshoptimizer.h>

#include "assets/assert.h"
#include "assets/mesh_columns.h"
#include "assets/process/columns.h"

namespace rambla::assets {

void merge_identical_vertices(Mesh& mesh) {
    std::vector<ColumnBytes> columns;
    for_each_column(mesh, [&](const auto& column) {
        if (!column.empty()) columns.push_back(bytes_of(column));
    });
    const std::vector<std::uint32_t> first = first_identical(columns, mesh.positions.size());
    for (std::uint32_t& index : mesh.indices)
        index = first[index];
}

void order_triangles(std::span<std::uint32_t> indices, std::span<const glm::vec3> positions,
                     float overdraw_threshold) {
    RAMBLA_ASSERT(indices.size() % 3 == 0, "triangles have three corners");
    if (indices.empty()) return;
    std::vector<std::uint32_t> for_cache(indices.size());
    meshopt_optimizeVertexCache(for_cache.data(), indices.data(), indices.size(), positions.size());
    meshopt_optimizeOverdraw(indices.data(), for_cache.data(), for_cache.size(), &positions[0].x,
                             positions.size(), sizeof(glm::vec3), overdraw_threshold);
}

VertexOrder order_of_first_use(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
    VertexOrder order{.kept = {}, .now = std::vector(vertex_count, VertexOrder::k_dropped)};
    for (const std::uint32_t index : indices)
        if (order.now[index] == VertexOrder::k_dropped) {
            order.now[index] = static_cast<std::uint32_t>(order.kept.size());
            order.kept.push_back(index);
        }
    return order;
}

void order_vertices(Mesh& mesh, LodChain& chain) {
    const VertexOrder order = order_of_first_use(mesh.indices, mesh.positions.size());
    for_each_column(mesh, [&](auto& column) { column = gathered(column, order.kept); });
    for (std::uint32_t& index : mesh.indices)
        index = order.now[index];
    for (std::uint32_t& index : chain.indices) {
        RAMBLA_ASSERT(order.now[index] != VertexOrder::k_dropped, "levels use vertices of their mesh");
        index = order.now[index];
    }
}

void optimise(Mesh& mesh, LodChain& chain, float overdraw_threshold) {
    if (mesh.topology == Topology::triangles) {
        order_triangles(mesh.indices, mesh.positions, overdraw_threshold);
        for (const LodLevel& level : chain.levels)
            order_triangles(std::span{chain.indices}.subspan(level.range.first, level.range.count),
                            mesh.positions, overdraw_threshold);
    }
    order_vertices(mesh, chain);
}

}  // namespace rambla::assets
