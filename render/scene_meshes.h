#pragma once

#include <span>
#include <vector>

#include "assets/mesh.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"
#include "render/scene_store.h"

namespace rambla::render {

/// Everything of a vertex but its position: 40 bytes.
struct PackedAttributes {
    std::uint64_t normal;   ///< snorm16 ×4, w unused
    std::uint64_t tangent;  ///< snorm16 ×4, w: handedness; all zero: none
    glm::vec2 uv0;
    glm::vec2 uv1;
    std::uint64_t colour;  ///< half ×4, linear
};
static_assert(sizeof(PackedAttributes) == 40);

/// Packs one vertex; what the mesh lacks becomes neutral: normal +Y, no tangent, uv (0, 0), white.
[[nodiscard]] PackedAttributes pack_attributes(const assets::Mesh& mesh, std::size_t vertex);

/// All meshes of a scene in one set of buffers.
struct SceneMeshes {
    gl::Buffer positions;
    gl::Buffer attributes;
    gl::Buffer indices;
    gl::VertexArray vertices;
    std::vector<MeshRange> ranges;
};

[[nodiscard]] SceneMeshes upload_meshes(std::span<const assets::Mesh> meshes);

}  // namespace rambla::render
