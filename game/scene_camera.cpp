#include "game/scene_camera.h"

#include "game/framing.h"
#include "systems/look/observer.h"

namespace rambla::game {
namespace {

/// Rotation of a node's frame without its scale; cameras keep looking along −Z whatever scale stands above
/// them. A frame without extent has no rotation.
glm::quat rotation_of(const glm::mat3& world_from_node) {
    const glm::vec3 right = glm::cross(world_from_node[1], world_from_node[2]);
    if (!(glm::dot(right, right) > 0.0f)) return {1.0f, 0.0f, 0.0f, 0.0f};
    const glm::vec3 x = glm::normalize(right);
    const glm::vec3 z = glm::normalize(world_from_node[2]);
    return glm::normalize(glm::quat_cast(glm::mat3{x, glm::cross(z, x), z}));
}

}  // namespace

std::optional<std::uint32_t> find_camera(const assets::Scene& scene, std::uint32_t index) {
    for (const PlacedNode& placed : placed_nodes(scene)) {
        if (scene.nodes[placed.node].camera == assets::k_none || index-- > 0) continue;
        return placed.node;
    }
    return std::nullopt;
}

systems::Eye camera_eye(const Stage& stage, std::uint32_t node, float interpolation) {
    const ecs::Entity entity = stage.nodes.at(node);
    const auto& now = stage.world->get<systems::WorldTransform>(entity);
    const auto* const before = stage.world->try_get<systems::PreviousWorldTransform>(entity);
    const systems::Observer observer{stage.origin, interpolation};
    const systems::Placement place = before == nullptr ? systems::placement(now, observer)
                                                       : systems::placement(before->value, now, observer);
    const assets::Camera& camera = stage.scene->cameras[stage.scene->nodes[node].camera];
    systems::Eye eye;
    eye.place = systems::moved(stage.origin, glm::dvec3{place.translation_m});
    eye.rotation = rotation_of(place.linear);
    eye.kind = camera.kind;
    eye.vertical_fov_rad = camera.vertical_fov_rad;
    eye.half_height_m = camera.half_height_m;
    eye.near_m = camera.near_m;
    eye.far_m = camera.far_m;
    return eye;
}

}  // namespace rambla::game
