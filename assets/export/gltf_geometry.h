#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "assets/export/gltf_buffer.h"
#include "assets/scene.h"

namespace rambla::assets {

/// Writes the geometry of a scene into a glTF buffer, each mesh once.
class GltfGeometry {
public:
    GltfGeometry(const Scene& scene, GltfBuffer& buffer) : scene_{scene}, buffer_{buffer} {}

    /// What a model shows as a mesh of glTF; null for one without triangles, lines or points, which glTF does
    /// not have.
    [[nodiscard]] nlohmann::json mesh_of(const Model& model);

private:
    nlohmann::json primitive(std::uint32_t mesh, std::size_t morphs);
    nlohmann::json attributes(const Mesh& mesh);
    nlohmann::json morph_target(const Mesh& mesh, std::size_t index);
    std::size_t add_positions(const std::vector<glm::vec3>& positions);
    std::size_t add_joints(const Mesh& mesh);
    std::size_t add_indices(const Mesh& mesh);

    const Scene& scene_;
    GltfBuffer& buffer_;
    std::map<std::pair<std::uint32_t, std::size_t>, nlohmann::json> primitives_;  ///< by mesh and morphs
};

}  // namespace rambla::assets
