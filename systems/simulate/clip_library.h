#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "assets/bounds.h"
#include "assets/scene.h"

namespace rambla::systems {

/// Box of the vertices that a joint moves, in the mesh's own space.
struct JointBox {
    std::uint32_t joint = 0;
    assets::Bounds box;
};

/// What deforming needs to know of a mesh that is skinned or morphed; of others nothing is kept.
struct DeformableMesh {
    assets::Bounds rest;
    std::vector<JointBox> joint_boxes;        ///< ascending; of the joints that move any vertex
    std::vector<assets::Bounds> morph_reach;  ///< by target: box of what it adds at weight 1, and of nothing
    std::uint32_t first_target =
        0;  ///< of this mesh, where the targets of all the scene's meshes are counted
};

/// Resource: the clips, skeletons and deformable meshes of the world's scene, laid out for playing. Indices
/// are the scene's.
class ClipLibrary {
public:
    ClipLibrary() = default;
    /// Channels that do not hold what they say (no keys, too few values, another width than their path has)
    /// are left out with a warning that names them.
    explicit ClipLibrary(const assets::Scene& scene);

    [[nodiscard]] std::uint32_t clip_count() const { return static_cast<std::uint32_t>(clips_.size()); }
    [[nodiscard]] const std::string& clip_name(std::uint32_t clip) const { return clips_[clip].clip.name; }
    /// 0 for clips that there are not.
    [[nodiscard]] double duration_s(std::uint32_t clip) const;
    /// What a clip says about a property of a node, or null.
    [[nodiscard]] const assets::Channel* channel(std::uint32_t clip, std::uint32_t node,
                                                 assets::AnimatedPath path) const;
    /// Whether any clip moves, turns or scales the node.
    [[nodiscard]] bool moves(std::uint32_t node) const { return node < moves_.size() && moves_[node] != 0; }
    /// Whether any clip changes the node's morph weights.
    [[nodiscard]] bool morphs(std::uint32_t node) const {
        return node < morphs_.size() && morphs_[node] != 0;
    }

    [[nodiscard]] std::uint32_t skeleton_count() const {
        return static_cast<std::uint32_t>(joint_from_mesh_.size());
    }
    /// Inverse bind matrices.
    [[nodiscard]] std::span<const glm::mat4> joint_from_mesh(std::uint32_t skeleton) const {
        return joint_from_mesh_[skeleton];
    }
    [[nodiscard]] const DeformableMesh& mesh(std::uint32_t mesh) const { return meshes_[mesh]; }
    [[nodiscard]] std::uint32_t mesh_count() const { return static_cast<std::uint32_t>(meshes_.size()); }

private:
    /// Channels by path, as indices; k_none where there is none.
    using NodeChannels = std::array<std::uint32_t, 4>;
    struct IndexedClip {
        assets::Clip clip;
        std::uint32_t first_node = 0;
        std::vector<NodeChannels> nodes;  ///< from first_node on
    };

    void add_clip(const assets::Clip& clip, std::size_t node_count);

    std::vector<IndexedClip> clips_;
    std::vector<std::uint8_t> moves_;
    std::vector<std::uint8_t> morphs_;
    std::vector<std::vector<glm::mat4>> joint_from_mesh_;
    std::vector<DeformableMesh> meshes_;
};

}  // namespace rambla::systems
