#include "assets/process/shadow_mesh.h"

#include "assets/process/columns.h"
#include "assets/process/optimise.h"

namespace rambla::assets {

namespace {

std::vector<std::uint32_t> welded(const Mesh& mesh) {
    std::vector<std::vector<glm::vec3>> places{without_negative_zero(mesh.positions)};
    for (const MorphTarget& morph : mesh.morphs)
        if (!morph.positions.empty()) places.push_back(without_negative_zero(morph.positions));
    std::vector<ColumnBytes> columns;
    for (const std::vector<glm::vec3>& column : places)
        columns.push_back(bytes_of(column));
    if (!mesh.joints.empty()) columns.push_back(bytes_of(mesh.joints));
    if (!mesh.weights.empty()) columns.push_back(bytes_of(mesh.weights));
    return first_identical(columns, mesh.positions.size());
}

}  // namespace

ShadowMesh shadow_mesh(const Mesh& mesh, const LodChain& chain) {
    if (mesh.topology != Topology::triangles) return {};
    ShadowMesh shadow;
    const std::vector<std::uint32_t> first = welded(mesh);
    const auto append = [&](std::span<const std::uint32_t> triangles) {
        const std::size_t start = shadow.indices.size();
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
            const std::uint32_t a = first[triangles[i]];
            const std::uint32_t b = first[triangles[i + 1]];
            const std::uint32_t c = first[triangles[i + 2]];
            if (a != b && b != c && c != a) shadow.indices.insert(shadow.indices.end(), {a, b, c});
        }
        order_triangles(std::span{shadow.indices}.subspan(start), mesh.positions);
        shadow.levels.push_back(
            {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(shadow.indices.size() - start)});
    };
    append(mesh.indices);
    for (const LodLevel& level : chain.levels)
        append(std::span{chain.indices}.subspan(level.range.first, level.range.count));

    const VertexOrder order = order_of_first_use(shadow.indices, mesh.positions.size());
    for (std::uint32_t& index : shadow.indices)
        index = order.now[index];
    shadow.positions = gathered(mesh.positions, order.kept);
    shadow.joints = gathered(mesh.joints, order.kept);
    shadow.weights = gathered(mesh.weights, order.kept);
    for (const MorphTarget& morph : mesh.morphs)
        shadow.morph_positions.push_back(gathered(morph.positions, order.kept));
    return shadow;
}

}  // namespace rambla::assets
