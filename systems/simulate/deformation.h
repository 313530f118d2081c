#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "assets/bounds.h"
#include "ecs/res.h"
#include "ecs/view.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/look/observer.h"
#include "systems/simulate/clip_library.h"

namespace rambla::systems {

/// Where the joints of a skin lie in Deformations.
struct SkinPose {
    ecs::Entity entity;
    std::uint32_t skeleton = 0;
    std::uint32_t first = 0;  ///< row of the first joint
    std::uint32_t count = 0;
    glm::ivec3 cell{0};  ///< whose corner the matrices count from
};

/// Where the weights of a morph lie in Deformations.
struct MorphPose {
    ecs::Entity entity;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Resource: what moves vertices, gathered into rows from the entities that say so, for this step and the one
/// before. Follows from the components: not saved, and made anew in every step. Keeps its memory.
class Deformations {
public:
    /// Null for entities that are no skins (no morphs), or were not when this was last made.
    [[nodiscard]] const SkinPose* skin(ecs::Entity skin) const;
    [[nodiscard]] const MorphPose* morph(ecs::Entity morph) const;
    /// Number of skins; each has an index below.
    [[nodiscard]] std::uint32_t skin_count() const { return static_cast<std::uint32_t>(skins_.size()); }
    [[nodiscard]] std::uint32_t skin_index(const SkinPose& pose) const {
        return static_cast<std::uint32_t>(&pose - skins_.data());
    }

    /// From the space of skinned meshes to the corner of the pose's cell. Skinning sums these rows by weight.
    [[nodiscard]] std::span<const Placement> joints(const SkinPose& pose) const {
        return std::span{joints_}.subspan(pose.first, pose.count);
    }
    [[nodiscard]] std::span<const Placement> previous_joints(const SkinPose& pose) const {
        return std::span{previous_joints_}.subspan(pose.first, pose.count);
    }
    [[nodiscard]] std::span<const float> weights(const MorphPose& pose) const {
        return std::span{weights_}.subspan(pose.first, pose.count);
    }
    [[nodiscard]] std::span<const float> previous_weights(const MorphPose& pose) const {
        return std::span{previous_weights_}.subspan(pose.first, pose.count);
    }

private:
    friend void gather_deformations(ecs::View<ecs::Entity, const Skin>, ecs::View<const SkinJoint>,
                                    ecs::View<ecs::Entity, const Morph>, ecs::View<const MorphWeight>,
                                    ecs::Lookup<const WorldTransform, const PreviousWorldTransform>,
                                    ecs::Res<ClipLibrary>, ecs::ResMut<Deformations>);

    std::vector<std::uint32_t> row_of_skin_;  ///< by the entity's index; others' hold anything
    std::vector<std::uint32_t> row_of_morph_;
    std::vector<SkinPose> skins_;
    std::vector<MorphPose> morphs_;
    std::vector<Placement> joints_;
    std::vector<Placement> previous_joints_;
    std::vector<float> weights_;
    std::vector<float> previous_weights_;
};

/// System: fills Deformations, after the transform system.
void gather_deformations(ecs::View<ecs::Entity, const Skin> skins, ecs::View<const SkinJoint> joints,
                         ecs::View<ecs::Entity, const Morph> morphs, ecs::View<const MorphWeight> weights,
                         ecs::Lookup<const WorldTransform, const PreviousWorldTransform> nodes,
                         ecs::Res<ClipLibrary> library, ecs::ResMut<Deformations> deformations);

/// System: bounds of what is morphed but not skinned.
void bound_morphed(ecs::View<const Morphed, const Renderable, LocalBounds, ecs::Without<Skinned>> renderables,
                   ecs::Res<ClipLibrary> library, ecs::Res<Deformations> deformations);

/// System: bounds of what is skinned, and its WorldTransform: the middle of them, turned inside out where the
/// skin is.
void bound_skinned(
    ecs::View<const Skinned, ecs::Optional<const Morphed>, const Renderable, WorldTransform, LocalBounds>
        renderables,
    ecs::Res<ClipLibrary> library, ecs::Res<Deformations> deformations);

/// Box that morph weights add to every vertex of a mesh: the sum of its targets' reaches, by weight.
[[nodiscard]] assets::Bounds morph_reach(const DeformableMesh& mesh, std::span<const float> weights);

/// Box of a skinned mesh. A skinned vertex is a mean, by weights ≥ 0 of sum 1, of where its joints would
/// bring it alone; so it lies in the hull, hence in the box, of the joints' boxes, each moved by its joint.
/// @param reach  what morphing adds to the vertices before that
[[nodiscard]] assets::Bounds skinned_bounds(const DeformableMesh& mesh, std::span<const Placement> joints,
                                            const assets::Bounds& reach);

/// Makes Deformations and what depends on them fit the world as it is: after spawning, loading or a leap.
void settle_deformations(ecs::World& world);

}  // namespace rambla::systems
