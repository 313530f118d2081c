#pragma once

#include <span>
#include <vector>

#include "assets/processed.h"
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

/// What moves a vertex of a skinned mesh: 16 bytes.
struct PackedSkin {
    std::uint64_t joints;   ///< uint16 ×4
    std::uint64_t weights;  ///< unorm16 ×4, which sum to exactly 65535
};
static_assert(sizeof(PackedSkin) == 16);

/// Packs the joints of one vertex. What rounding leaves over goes to the largest weight; weights that are no
/// share of anything become the first joint's.
[[nodiscard]] PackedSkin pack_skin(const assets::Mesh& mesh, std::size_t vertex);

/// All meshes of a scene in one set of buffers. Skinned meshes come first, so that `skins` is as long as they
/// are.
struct SceneMeshes {
    gl::Buffer positions;
    gl::Buffer attributes;
    gl::Buffer skins;
    gl::Buffer indices;
    gl::VertexArray vertices;
    gl::VertexArray skinned_vertices;  ///< with joints and weights
    std::vector<MeshRange> ranges;     ///< as the scene counts its meshes
    MeshRange quad;                    ///< corners (±1, ±1, 0), counter-clockwise from +z
};

/// Uploads the finest level of each mesh.
[[nodiscard]] SceneMeshes upload_meshes(std::span<const assets::ProcessedMesh> meshes);

}  // namespace rambla::render
