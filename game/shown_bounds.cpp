#include "game/shown_bounds.h"

#include <algorithm>
#include <span>
#include <vector>

#include "ecs/query.h"
#include "systems/pack/particles.h"
#include "systems/position.h"
#include "systems/simulate/deformation.h"

namespace rambla::game {
namespace {

assets::Bounds moved(const systems::LocalBounds& bounds, const systems::Placement& place) {
    const glm::mat3& linear = place.linear;
    const glm::mat3 magnitude{glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])};
    const glm::vec3 centre = linear * bounds.centre_m + place.translation_m;
    const glm::vec3 half = magnitude * bounds.half_extents_m;
    return {centre - half, centre + half};
}

std::vector<glm::vec3> morphed(const assets::Mesh& mesh, std::span<const float> weights) {
    std::vector<glm::vec3> positions = mesh.positions;
    for (std::size_t target = 0; target < std::min(weights.size(), mesh.morphs.size()); ++target) {
        const std::vector<glm::vec3>& deltas = mesh.morphs[target].positions;
        for (std::size_t v = 0; v < deltas.size(); ++v)
            positions[v] += weights[target] * deltas[v];
    }
    return positions;
}

glm::vec3 skinned(const assets::Mesh& mesh, std::size_t v, glm::vec3 position,
                  std::span<const systems::Placement> joints) {
    glm::vec3 sum{0.0f};
    for (int i = 0; i < 4; ++i) {
        if (!(mesh.weights[v][i] > 0.0f)) continue;
        const systems::Placement& joint = joints[mesh.joints[v][i]];
        sum += mesh.weights[v][i] * (joint.linear * position + joint.translation_m);
    }
    return sum;
}

}  // namespace

assets::Bounds shown_bounds(const ecs::World& world, const assets::Scene& scene,
                            const systems::WorldPosition& origin) {
    assets::Bounds box;
    const systems::Observer observer{origin};
    ecs::Query<const systems::WorldTransform, const systems::LocalBounds,
               ecs::Optional<const systems::ParticleSource>, ecs::With<systems::Renderable>,
               ecs::Without<systems::Skinned>, ecs::Without<systems::Morphed>>
        rigid;
    rigid.each(world, [&](const systems::WorldTransform& transform, const systems::LocalBounds& bounds,
                          const systems::ParticleSource* source) {
        // Of a source that somebody has changed, the bounds that it was made with say nothing.
        const systems::LocalBounds local = source == nullptr ? bounds : systems::particle_bounds(*source);
        box.expand(moved(local, placement(transform, observer)));
    });
    if (!world.has_resource<systems::Deformations>()) return box;

    const auto& poses = world.resource<systems::Deformations>();
    ecs::Query<ecs::Entity, const systems::Renderable, ecs::AnyOf<systems::Skinned, systems::Morphed>>
        deformed;
    deformed.each(world, [&](ecs::Entity entity, const systems::Renderable& drawn) {
        const assets::Mesh& mesh = scene.meshes[drawn.mesh];
        const auto* const morph = world.try_get<systems::Morphed>(entity);
        const systems::MorphPose* const weights = morph == nullptr ? nullptr : poses.morph(morph->morph);
        const std::vector<glm::vec3> positions =
            morphed(mesh, weights == nullptr ? std::span<const float>{} : poses.weights(*weights));
        const auto* const skin = world.try_get<systems::Skinned>(entity);
        const systems::SkinPose* const pose = skin == nullptr ? nullptr : poses.skin(skin->skin);
        const systems::Placement place = placement(world.get<systems::WorldTransform>(entity), observer);
        for (std::size_t v = 0; v < positions.size(); ++v) {
            box.expand(pose == nullptr ? place.linear * positions[v] + place.translation_m
                                       : skinned(mesh, v, positions[v], poses.joints(*pose)) +
                                             systems::offset_m(origin, {pose->cell, glm::vec3{0.0f}}));
        }
    });
    return box;
}

}  // namespace rambla::game
