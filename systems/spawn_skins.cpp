#include "systems/spawn_skins.h"

#include <spdlog/spdlog.h>

#include "systems/frame.h"

namespace rambla::systems {
namespace {

const assets::Material& material_of(const assets::Scene& scene, const assets::ModelPart& part) {
    static const assets::Material k_default;
    return part.material == assets::k_none ? k_default : scene.materials.at(part.material);
}

}  // namespace

SkinSpawner::SkinSpawner(ecs::World& world, const assets::Scene& scene, const SpawnedSubtrees& subtrees)
    : world_{world},
      scene_{scene},
      stand_{subtrees.stand},
      nodes_(scene.nodes.size()),
      skins_(scene.skeletons.size()) {
    for (const SpawnedNode& made : subtrees.nodes)
        nodes_[made.node] = made.entity;
}

ecs::Entity SkinSpawner::add(const SkinnedPart& part) {
    const ecs::Entity skin = skin_of(part.skeleton);
    const ecs::Entity shown =
        world_.create(WorldTransform{world_.get<WorldTransform>(stand_)}, LocalBounds{},
                      renderable_of(scene_, part.part, true), Skinned{skin}, Parent{part.node});
    if (part.morph != ecs::Entity{}) world_.add(shown, Morphed{part.morph});
    if (!casts_shadows(scene_, part.part)) world_.add(shown, NoShadow{});
    return shown;
}

ecs::Entity SkinSpawner::skin_of(std::uint32_t skeleton) {
    ecs::Entity& skin = skins_[skeleton];
    if (skin != ecs::Entity{}) return skin;
    const std::vector<std::uint32_t>& joints = scene_.skeletons[skeleton].joints;
    skin = world_.create(Skin{skeleton, nodes_.at(joints.front())}, Parent{stand_});
    for (std::uint32_t i = 0; i < joints.size(); ++i) {
        const ecs::Entity node = nodes_.at(joints[i]);
        if (node == ecs::Entity{}) {
            spdlog::warn("scene '{}': joint {} of skeleton '{}' is no part of what is shown", scene_.name, i,
                         scene_.skeletons[skeleton].name);
            continue;
        }
        world_.create(SkinJoint{skin, node, i}, Parent{skin});
    }
    return skin;
}

Renderable renderable_of(const assets::Scene& scene, const assets::ModelPart& part, bool skinned) {
    const assets::Material& material = material_of(scene, part);
    const assets::Mesh& mesh = scene.meshes.at(part.mesh);
    return {part.mesh, part.material,
            pack({.double_sided = material.double_sided,
                  .mirrored = false,
                  .alpha = static_cast<std::uint8_t>(assets::drawn_as(material)),
                  .topology = static_cast<std::uint8_t>(mesh.topology),
                  .unlit = material.unlit,
                  .skinned = skinned,
                  .morphed = !mesh.morphs.empty()})};
}

bool casts_shadows(const assets::Scene& scene, const assets::ModelPart& part) {
    return assets::drawn_as(material_of(scene, part)) != assets::AlphaMode::blend &&
           scene.meshes.at(part.mesh).topology == assets::Topology::triangles;
}

}  // namespace rambla::systems
