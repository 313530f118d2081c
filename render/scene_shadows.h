#pragma once

#include <span>
#include <vector>

#include "assets/processed.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"
#include "render/scene_store.h"

namespace rambla::render {

/// The shadow meshes of a scene: what opaque triangles need in depth-only passes.
struct SceneShadows {
    gl::Buffer positions;
    gl::Buffer indices;
    gl::VertexArray vertices;
    std::vector<MeshRange> ranges;  ///< as the scene counts its meshes; empty ones for lines and points
};

/// Uploads the finest level of each.
[[nodiscard]] SceneShadows upload_shadows(std::span<const assets::ProcessedMesh> meshes);

}  // namespace rambla::render
