#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace rambla::assets {

/// Nodes that move the vertices of skinned meshes (glTF 2.0, section 3.7.3). A skinned vertex is placed by
/// Σ weight · (scene_from_joint · joint_from_mesh); where the meshes' own node is does not matter.
struct Skeleton {
    std::string name;
    std::vector<std::uint32_t> joints;       ///< node indices
    std::vector<glm::mat4> joint_from_mesh;  ///< inverse bind matrices, one per joint, affine
};

}  // namespace rambla::assets
