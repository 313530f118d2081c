#pragma once

#include <cstdint>
#include <vector>

#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/spawn_subtree.h"

namespace rambla::systems {

/// A part of a model whose vertices follow a skeleton.
struct SkinnedPart {
    assets::ModelPart part;
    std::uint32_t skeleton = assets::k_none;
    ecs::Entity node;   ///< whose model it is; it ends with it, but stands where the joints are
    ecs::Entity morph;  ///< null: it is not morphed
};

/// Makes skins and what they move, after all nodes of some subtrees have been made. A skeleton becomes one
/// Skin there, however many meshes it moves.
class SkinSpawner {
public:
    SkinSpawner(ecs::World& world, const assets::Scene& scene, const SpawnedSubtrees& subtrees);

    /// Joints that lie in no spawned subtree are warned about and stand at the skin's cell's corner.
    /// @return  what is drawn
    ecs::Entity add(const SkinnedPart& part);

private:
    [[nodiscard]] ecs::Entity skin_of(std::uint32_t skeleton);

    ecs::World& world_;
    const assets::Scene& scene_;
    ecs::Entity stand_;
    std::vector<ecs::Entity> nodes_;  ///< by node index
    std::vector<ecs::Entity> skins_;  ///< by skeleton index
};

/// How a part of a model is drawn.
[[nodiscard]] Renderable renderable_of(const assets::Scene& scene, const assets::ModelPart& part,
                                       bool skinned);
[[nodiscard]] bool casts_shadows(const assets::Scene& scene, const assets::ModelPart& part);

}  // namespace rambla::systems
