#include "unit/systems/worlds.h"

namespace rambla::test {
namespace {

using assets::k_none;

std::uint32_t add_part(assets::Scene& scene, const char* name, std::uint32_t parent, glm::vec3 at) {
    assets::Node node;
    node.name = name;
    node.parent = parent;
    node.local.translation_m = at;
    node.model = 0;
    const auto index = static_cast<std::uint32_t>(scene.nodes.size());
    scene.nodes.push_back(node);
    if (parent != k_none) scene.nodes[parent].children.push_back(index);
    return index;
}

/// Legs of 0.9 m with knees in the middle.
std::uint32_t add_walker(assets::Scene& scene) {
    const std::uint32_t root = add_part(scene, "walker", k_none, {});
    const std::uint32_t torso = add_part(scene, "torso", root, {0, 0.9f, 0});
    add_part(scene, "head", torso, {0, 0.6f, 0});
    add_part(scene, "forearm_l", add_part(scene, "arm_l", torso, {-0.2f, 0.5f, 0}), {0, -0.3f, 0});
    add_part(scene, "forearm_r", add_part(scene, "arm_r", torso, {0.2f, 0.5f, 0}), {0, -0.3f, 0});
    add_part(scene, "shin_l", add_part(scene, "leg_l", root, {-0.1f, 0.9f, 0}), {0, -0.45f, 0});
    add_part(scene, "shin_r", add_part(scene, "leg_r", root, {0.1f, 0.9f, 0}), {0, -0.45f, 0});
    return root;
}

std::uint32_t add_car(assets::Scene& scene) {
    const std::uint32_t root = add_part(scene, "car", k_none, {});
    add_part(scene, "wheel_fl", root, {-0.8f, 0.3f, -1.2f});
    add_part(scene, "wheel_fr", root, {0.8f, 0.3f, -1.2f});
    add_part(scene, "wheel_rl", root, {-0.8f, 0.3f, 1.2f});
    add_part(scene, "wheel_rr", root, {0.8f, 0.3f, 1.2f});
    return root;
}

}  // namespace

assets::Scene box_scene() {
    assets::Scene scene;
    scene.materials.emplace_back();
    assets::Mesh& mesh = scene.meshes.emplace_back();
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back(glm::vec3{corner & 1, (corner >> 1) & 1, corner >> 2} - 0.5f);
        mesh.bounds.expand(mesh.positions.back());
    }
    scene.models.push_back({"box", {{0, 0}}});
    return scene;
}

std::uint32_t add_node(assets::Scene& scene, std::uint32_t parent, const assets::Transform& local) {
    const auto index = static_cast<std::uint32_t>(scene.nodes.size());
    assets::Node& node = scene.nodes.emplace_back();
    node.parent = parent;
    node.local = local;
    if (parent == k_none) {
        scene.roots.push_back(index);
    } else {
        scene.nodes[parent].children.push_back(index);
    }
    return index;
}

assets::Place small_place(int walkers, int cars) {
    assets::Place place;
    place.environment = assets::noon();
    place.scene = box_scene();
    assets::Scene& scene = place.scene;
    scene.materials.emplace_back().alpha_mode = assets::AlphaMode::blend;
    scene.models.push_back({"glass", {{0, 1}}});
    scene.lights.emplace_back().intensity = 2.0f;
    for (const float x : {-20.0f, 20.0f}) {
        for (const float z : {-20.0f, 20.0f}) {
            assets::Transform local;
            local.translation_m = {x, 5, z};
            local.scale = {10, 10, 10};
            scene.nodes[add_node(scene, k_none, local)].model = 0;
        }
    }
    assets::Transform local;
    local.translation_m = {2, 2, -8};
    scene.nodes[add_node(scene, k_none, local)].model = 1;
    local.translation_m = {0, 4, -6};
    scene.nodes[add_node(scene, k_none, local)].light = 0;

    place.pavements.points = {{0, 0, 0}, {30, 0, 0}, {-30, 0, 0}, {0, 0, 30}, {0, 0, -30}};
    for (std::uint32_t end = 1; end < 5; ++end)
        place.pavements.links.push_back({0, end, 1.5f, true});
    place.lanes.points = {{-40, 0, -40}, {40, 0, -40}, {40, 0, 40}, {-40, 0, 40}};
    for (std::uint32_t i = 0; i < 4; ++i)
        place.lanes.links.push_back({i, (i + 1) % 4, 0.5f, false});
    const std::uint32_t walker = add_walker(scene);
    const std::uint32_t car = add_car(scene);
    for (int i = 0; i < walkers; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(walkers);
        place.actors.push_back({assets::ActorKind::walker, walker, static_cast<std::uint32_t>(i) % 4, share,
                                0.3f, 1.0f + 0.6f * share, i % 3 == 1});
    }
    for (int i = 0; i < cars; ++i) {
        place.actors.push_back(
            {assets::ActorKind::car, car, static_cast<std::uint32_t>(i) % 4, 0.5f, 0.0f, 6.0f, false});
    }
    return place;
}

}  // namespace rambla::test
