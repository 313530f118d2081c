#include "systems/spawn.h"

#include <array>
#include <string_view>

#include "systems/position.h"
#include "systems/simulate/actors.h"
#include "systems/simulate/deformation.h"
#include "systems/simulate/gait.h"
#include "systems/simulate/movers.h"
#include "systems/simulate/paths.h"
#include "systems/simulate/random.h"
#include "systems/simulate/transform.h"
#include "systems/spawn_subtree.h"

namespace rambla::systems {
namespace {

struct NamedLimb {
    std::string_view name;
    LimbRole role;
    bool right;
};
constexpr std::array k_limbs{
    NamedLimb{"leg_l", LimbRole::leg, false},         NamedLimb{"leg_r", LimbRole::leg, true},
    NamedLimb{"shin_l", LimbRole::shin, false},       NamedLimb{"shin_r", LimbRole::shin, true},
    NamedLimb{"arm_l", LimbRole::arm, false},         NamedLimb{"arm_r", LimbRole::arm, true},
    NamedLimb{"forearm_l", LimbRole::forearm, false}, NamedLimb{"forearm_r", LimbRole::forearm, true},
    NamedLimb{"torso", LimbRole::torso, false},       NamedLimb{"head", LimbRole::head, false},
};
constexpr std::string_view k_wheel = "wheel_";

/// Draws of random numbers that are not made at turns count from here.
constexpr std::uint64_t k_first_phase_draw = std::uint64_t{1} << 32u;

/// Height of a node's origin above its actor's, at rest.
float height_in_actor_m(const assets::Scene& scene, std::uint32_t node, std::uint32_t actor) {
    glm::mat4 actor_from_node{1.0f};
    for (; node != actor; node = scene.nodes[node].parent) {
        actor_from_node = assets::matrix(scene.nodes[node].local) * actor_from_node;
    }
    return actor_from_node[3].y;
}

bool is_torso(const assets::Scene& scene, std::uint32_t node) {
    return node != assets::k_none && scene.nodes[node].name == "torso";
}

void add_limbs(ecs::World& world, const assets::Scene& scene, ecs::Entity actor,
               std::span<const SpawnedNode> parts, const Gait& gait) {
    for (const SpawnedNode& part : parts) {
        const assets::Node& node = scene.nodes[part.node];
        for (const NamedLimb& limb : k_limbs) {
            if (node.name != limb.name) continue;
            // A head turns back what the torso under it turns; on its own it would only shake.
            if (limb.role == LimbRole::head && !is_torso(scene, node.parent)) continue;
            glm::quat& rotation = world.get_mut<LocalTransform>(part.entity).rotation;
            const GaitLimb made{actor, limb.role, limb.right, rotation};
            rotation = limb_rotation(made, gait);
            world.add(part.entity, made);
        }
    }
}

float leg_length_m(const assets::Scene& scene, std::span<const SpawnedNode> parts) {
    for (const SpawnedNode& part : parts) {
        if (scene.nodes[part.node].name != "leg_l") continue;
        const float height = height_in_actor_m(scene, part.node, parts[0].node);
        if (height > 0.0f) return height;
    }
    return Gait{}.leg_length_m;
}

void add_wheels(ecs::World& world, const assets::Scene& scene, ecs::Entity actor,
                std::span<const SpawnedNode> parts) {
    for (const SpawnedNode& part : parts) {
        if (scene.nodes[part.node].name.rfind(k_wheel, 0) != 0) continue;
        const float radius = height_in_actor_m(scene, part.node, parts[0].node);
        if (!(radius > 0.0f)) continue;
        const glm::quat rest = world.get<LocalTransform>(part.entity).rotation;
        world.add(part.entity, WheelSpin{actor, radius, rest});
    }
}

void spawn_actor(ecs::World& world, const assets::Scene& scene, const assets::ActorStart& start,
                 std::uint32_t first_link, const WorldPosition& origin) {
    const Paths& paths = world.resource<Paths>();
    const bool car = start.kind == assets::ActorKind::car;
    const PathGraph& graph = car ? paths.lanes : paths.pavements;
    const PathFollower follower = starting(graph, first_link, start);
    const WorldPosition place = place_of(graph, follower);

    // Who walks into the eye must not show what they look like from within.
    constexpr NearFade k_walker_fade{.gone_m = 0.1f, .whole_m = 0.5f};
    const std::optional<NearFade> fade = car ? std::nullopt : std::optional{k_walker_fade};
    const SpawnedSubtrees spawned =
        spawn_subtrees(world, scene, std::span{&start.prototype, 1}, origin, Mobility::moving, fade);
    const std::vector<SpawnedNode>& parts = spawned.nodes;
    const ecs::Entity root = spawned.root();
    world.add(root, follower);
    world.get_mut<Cell>(root).value = place.cell;
    LocalTransform& local = world.get_mut<LocalTransform>(root);
    local.translation_m = place.local_m;
    local.rotation = facing(follower.heading);
    if (car) {
        add_wheels(world, scene, root, parts);
        return;
    }
    Gait gait;
    gait.leg_length_m = leg_length_m(scene, parts);
    gait.phase = unit_interval(random_bits(paths.seed, root.index, k_first_phase_draw));
    gait = advanced(gait, follower.speed_m_s, 0.0f, local.scale.y);
    local.translation_m.y -= pelvis_drop_m(gait) * local.scale.y;
    world.add(root, gait);
    add_limbs(world, scene, root, parts, gait);
}

/// Makes a mover of what was spawned to stand still.
void start_mover(ecs::World& world, ecs::Entity entity, const assets::MoverStart& start, float reach_m) {
    world.get_mut<LocalTransform>(entity).rotation = heading_rotation(start.heading_rad);
    world.add(entity, PreviousWorldTransform{world.get<WorldTransform>(entity)});
    world.add(entity, Mover{start.heading_rad, start.speed_m_s, reach_m});
}

}  // namespace

SpawnedScene spawn(ecs::World& world, const assets::Scene& scene, const WorldPosition& origin) {
    if (!world.has_resource<Sunlight>()) world.set_resource(Sunlight{assets::noon()});
    note_materials(world, scene);
    note_clips(world, scene);
    SpawnedScene spawned;
    spawned.nodes.resize(scene.nodes.size());
    const SpawnedSubtrees made = spawn_subtrees(world, scene, scene.roots, origin, Mobility::fixed);
    for (const SpawnedNode& one : made.nodes)
        spawned.nodes[one.node] = one.entity;
    if (made.stand != ecs::Entity{} && world.has<AnimationPlayer>(made.stand)) spawned.player = made.stand;
    settle_deformations(world);
    return spawned;
}

ecs::Entity spawn_prototype(ecs::World& world, const assets::Scene& scene, std::uint32_t node,
                            const WorldPosition& origin, Mobility mobility) {
    return spawn_subtrees(world, scene, std::span{&node, 1}, origin, mobility).root();
}

SpawnedScene spawn(ecs::World& world, const assets::Place& place, const WorldPosition& origin,
                   std::uint64_t seed) {
    world.set_resource(Sunlight{place.environment});
    SpawnedScene spawned = spawn(world, place.scene, origin);

    if (!world.has_resource<Paths>()) world.set_resource(Paths{});
    Paths& paths = world.resource<Paths>();
    paths.seed = seed;
    const std::uint32_t first_pavement = paths.pavements.add(place.pavements, origin);
    const std::uint32_t first_lane = paths.lanes.add(place.lanes, origin);
    for (const assets::ActorStart& start : place.actors) {
        const bool car = start.kind == assets::ActorKind::car;
        spawn_actor(world, place.scene, start, car ? first_lane : first_pavement, origin);
    }
    for (const assets::MoverStart& start : place.movers)
        start_mover(world, spawned.nodes.at(start.node), start, place.mover_reach_m);
    settle(world);
    settle_deformations(world);
    return spawned;
}

}  // namespace rambla::systems
