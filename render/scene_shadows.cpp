#include "render/scene_shadows.h"

#include <cstdint>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

namespace {

std::span<const std::uint32_t> finest_level(const assets::ShadowMesh& shadow) {
    if (shadow.levels.empty()) return {};
    return std::span{shadow.indices}.subspan(shadow.levels[0].first, shadow.levels[0].count);
}

}  // namespace

SceneShadows upload_shadows(std::span<const assets::ProcessedMesh> meshes) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    SceneShadows result;
    result.ranges.reserve(meshes.size());
    for (const assets::ProcessedMesh& processed : meshes) {
        const assets::ShadowMesh& shadow = processed.shadow;
        const std::span<const std::uint32_t> finest = finest_level(shadow);
        result.ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                                 .index_count = static_cast<std::uint32_t>(finest.size()),
                                 .base_vertex = static_cast<std::int32_t>(positions.size()),
                                 .topology = assets::Topology::triangles});
        positions.insert(positions.end(), shadow.positions.begin(), shadow.positions.end());
        indices.insert(indices.end(), finest.begin(), finest.end());
    }
    result.positions = gl::Buffer{"shadow positions", positions.size() * sizeof(glm::vec3), positions.data()};
    result.indices = gl::Buffer{"shadow indices", indices.size() * sizeof(std::uint32_t), indices.data()};
    result.vertices = gl::VertexArray{"shadow meshes"};
    constexpr GLuint k_position_stream = 0;
    result.vertices.attribute({.location = ATTRIBUTE_POSITION, .binding = k_position_stream});
    result.vertices.vertex_buffer(k_position_stream, result.positions.name(), sizeof(glm::vec3));
    result.vertices.index_buffer(result.indices.name());
    return result;
}

}  // namespace rambla::render
