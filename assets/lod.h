#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace rambla::assets {

/// Part of an index list.
struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// A coarser form of a mesh over the mesh's own vertices. Errors are measured in the pose of the mesh's
/// positions, neither skinned nor morphed.
struct LodLevel {
    IndexRange range;      ///< of LodChain::indices
    float error_m = 0.0f;  ///< no point of either surface, this or the mesh's, is farther from the other one
    float normal_error_deg =
        0.0f;               ///< root mean square over the mesh's surface, between interpolated normals
    float uv_error = 0.0f;  ///< likewise, between first texture coordinates; times texels per picture
    bool sloppy = false;    ///< made without regard to seams and holes, for small objects only
};

/// Coarser levels of a mesh, finest first; errors do not decrease. Level 0, the mesh itself with error 0, is
/// not among them.
struct LodChain {
    std::vector<LodLevel> levels;
    std::vector<std::uint32_t> indices;  ///< triangle lists of all levels, one behind the other
};

/// What a depth-only pass needs of a mesh: vertices that differ only in what is shaded are one. Columns are
/// empty where the mesh's are. Alpha-tested meshes cast shadows with their full columns instead.
struct ShadowMesh {
    std::vector<glm::vec3> positions;                     ///< metres
    std::vector<glm::u16vec4> joints;                     ///< as Mesh::joints
    std::vector<glm::vec4> weights;                       ///< as Mesh::weights
    std::vector<std::vector<glm::vec3>> morph_positions;  ///< of each morph target, empty or one per position
    std::vector<IndexRange> levels;  ///< of `indices`: the mesh itself, then each level of its LodChain
    std::vector<std::uint32_t> indices;
};

}  // namespace rambla::assets
