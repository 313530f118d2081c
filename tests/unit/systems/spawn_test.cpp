#include "systems/spawn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ecs/query.h"
#include "systems/frame.h"
#include "systems/pipeline.h"
#include "systems/position.h"
#include "systems/simulate/gait.h"
#include "systems/simulate/paths.h"
#include "unit/systems/worlds.h"

namespace rambla::systems {
namespace {

using assets::k_none;
using test::add_node;
using test::box_scene;

assets::Light light(const char* name, assets::LightKind kind, glm::vec3 colour, float intensity) {
    assets::Light made;
    made.name = name;
    made.kind = kind;
    made.colour = colour;
    made.intensity = intensity;
    return made;
}

TEST(Spawn, BuildsTheHierarchyWithItsPlacesInTheWorld) {
    assets::Scene scene = box_scene();
    assets::Transform local;
    local.translation_m = {10, 0, 0};
    local.rotation = glm::angleAxis(1.5707963f, glm::vec3{0, 1, 0});
    local.scale = glm::vec3{2.0f};
    const std::uint32_t parent = add_node(scene, k_none, local);
    local = {};
    local.translation_m = {0, 1, 3};
    const std::uint32_t child = add_node(scene, parent, local);
    scene.nodes[child].model = 0;

    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {{5, 0, 0}, {250.0f, 0.0f, 100.0f}});
    const WorldTransform& placed = world.get<WorldTransform>(spawned.nodes[child]);
    // Half scale and a quarter turn bring (0, 1, 3) to (6, 2, 0) from the parent, which is 10 m east of the
    // origin.
    const glm::vec3 from_cell = offset_m({{5, 0, 0}, {}}, {placed.cell, placed.translation_m});
    EXPECT_NEAR(glm::distance(from_cell, glm::vec3(266, 2, 100)), 0.0f, 1e-4f);
    EXPECT_EQ(placed.cell, glm::ivec3(6, 0, 0)) << "in the cell where it lies";
    EXPECT_EQ(world.get<Parent>(spawned.nodes[child]).entity, spawned.nodes[parent]);
    EXPECT_FALSE(world.has<Parent>(spawned.nodes[parent]));
    EXPECT_EQ(world.get<Cell>(spawned.nodes[parent]).value, glm::ivec3(6, 0, 0));
    EXPECT_FALSE(world.has<PreviousWorldTransform>(spawned.nodes[child])) << "scenery rests";
    EXPECT_EQ(world.get<Renderable>(spawned.nodes[child]).mesh, 0u);
    EXPECT_EQ(world.get<LocalBounds>(spawned.nodes[child]).half_extents_m, glm::vec3(0.5f));
}

TEST(Spawn, LeavesOutNodesThatAreNotUnderARoot) {
    assets::Scene scene = box_scene();
    add_node(scene, k_none, {});
    scene.nodes.emplace_back().model = 0;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    ASSERT_EQ(spawned.nodes.size(), 2u);
    EXPECT_TRUE(world.alive(spawned.nodes[0]));
    EXPECT_EQ(spawned.nodes[1], ecs::Entity{});
    const ecs::Entity copy = spawn_prototype(world, scene, 1, {{0, 0, 0}, {3, 0, 0}}, Mobility::moving);
    EXPECT_EQ(world.get<WorldTransform>(copy).translation_m.x, 3.0f);
    EXPECT_TRUE(world.has<PreviousWorldTransform>(copy));
}

TEST(Spawn, SeveralPartsBecomeChildrenAndOneStaysOnTheNode) {
    assets::Scene scene = box_scene();
    scene.models.push_back({"two", {{0, 0}, {0, k_none}}});
    const std::uint32_t one = add_node(scene, k_none, {});
    const std::uint32_t two = add_node(scene, k_none, {});
    scene.nodes[one].model = 0;
    scene.nodes[two].model = 1;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    EXPECT_TRUE(world.has<Renderable>(spawned.nodes[one]));
    EXPECT_FALSE(world.has<Renderable>(spawned.nodes[two]));
    ecs::Query<const Parent, const Renderable> parts;
    EXPECT_EQ(parts.count(world), 2u);
    parts.each(world, [&](const Parent& parent, const Renderable&) {
        EXPECT_EQ(parent.entity, spawned.nodes[two]);
    });
}

TEST(Spawn, PipelinesFollowMaterialAndMesh) {
    assets::Scene scene = box_scene();
    assets::Material& glass = scene.materials.emplace_back();
    glass.alpha_mode = assets::AlphaMode::blend;
    glass.double_sided = true;
    glass.unlit = true;
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].topology = assets::Topology::lines;
    scene.models = {{"plain", {{0, 0}}}, {"glass", {{0, 1}}}, {"lines", {{1, k_none}}}};
    for (std::uint32_t model = 0; model < 3; ++model)
        scene.nodes[add_node(scene, k_none, {})].model = model;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    const auto pipeline = [&](int node) {
        return unpack_pipeline(world.get<Renderable>(spawned.nodes[static_cast<std::size_t>(node)]).pipeline);
    };
    EXPECT_EQ(pipeline(0), Pipeline{});
    EXPECT_EQ(pipeline(1), (Pipeline{.double_sided = true, .alpha = 2, .unlit = true}));
    EXPECT_EQ(pipeline(2), (Pipeline{.topology = 1}));
    EXPECT_FALSE(world.has<NoShadow>(spawned.nodes[0]));
    EXPECT_TRUE(world.has<NoShadow>(spawned.nodes[1]));
    EXPECT_TRUE(world.has<NoShadow>(spawned.nodes[2]));
}

TEST(Spawn, EmittersBecomeSourcesBesideWhatTheirNodeShows) {
    assets::Scene scene = box_scene();
    assets::Material& smoke = scene.materials.emplace_back();
    smoke.optical_depth = 1.0f;
    assets::Emitter& emitter = scene.emitters.emplace_back();
    emitter.material = 1;
    emitter.count = 5;
    emitter.lifetime_s = 2.0f;
    emitter.velocity_m_s = {0, 1, 0};
    scene.nodes[add_node(scene, k_none, {.translation_m = {1, 2, 3}})].model = 0;
    scene.nodes[0].emitter = 0;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    ecs::Query<const ParticleSource, const Renderable, const LocalBounds, const WorldTransform, const Parent,
               ecs::With<NoShadow>>
        query;
    ASSERT_EQ(query.count(world), 1u);
    query.each(world, [&](const ParticleSource& source, const Renderable& drawn, const LocalBounds& box,
                          const WorldTransform& at, const Parent& parent) {
        EXPECT_EQ(source.count, 5u);
        EXPECT_EQ(source.velocity_m_s, glm::vec3(0, 1, 0));
        EXPECT_EQ(drawn.mesh, k_none);
        EXPECT_EQ(drawn.material, 1u);
        EXPECT_TRUE(unpack_pipeline(drawn.pipeline).haze);
        EXPECT_EQ(at.translation_m, glm::vec3(1, 2, 3));
        EXPECT_EQ(parent.entity, spawned.nodes[0]);
        EXPECT_GT(box.half_extents_m.y, 1.9f);
    });
    EXPECT_EQ(world.get<Renderable>(spawned.nodes[0]).mesh, 0u);
}

TEST(Spawn, WalkersFadeBeforeTheEyeIsInThemAndCarsDoNot) {
    ecs::World world;
    spawn(world, test::small_place(2, 2), {}, 1);
    std::size_t of_walkers = 0;
    ecs::Query<ecs::Entity, const NearFade>{}.each(world, [&](ecs::Entity entity, const NearFade& fade) {
        EXPECT_LT(fade.gone_m, fade.whole_m);
        ecs::Entity root = entity;
        while (world.has<Parent>(root))
            root = world.get<Parent>(root).entity;
        EXPECT_TRUE(world.has<Gait>(root));
        ++of_walkers;
    });
    EXPECT_GT(of_walkers, 2u);
}

TEST(Spawn, LightsReachAsFarAsTheyMatter) {
    assets::Scene scene;
    scene.lights = {light("lamp", assets::LightKind::point, {1, 0.5f, 0.25f}, 4.0f),
                    light("ranged", assets::LightKind::spot, {1, 1, 1}, 4.0f),
                    light("glaring", assets::LightKind::point, {1, 1, 1}, 1e9f)};
    scene.lights[1].range_m = 7.0f;
    scene.lights[1].inner_cone_rad = 0.3f;
    scene.lights[1].outer_cone_rad = 1.0471976f;
    for (std::uint32_t light = 0; light < 3; ++light)
        scene.nodes[add_node(scene, k_none, {})].light = light;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    const LocalLight& lamp = world.get<LocalLight>(spawned.nodes[0]);
    EXPECT_EQ(lamp.intensity, glm::vec3(4, 2, 1));
    EXPECT_NEAR(4.0f / (lamp.radius_m * lamp.radius_m), k_light_threshold, 1e-6f);
    EXPECT_LT(lamp.cos_outer, -1.0f);
    const LocalLight& ranged = world.get<LocalLight>(spawned.nodes[1]);
    EXPECT_EQ(ranged.radius_m, 7.0f);
    EXPECT_NEAR(ranged.cos_outer, 0.5f, 1e-6f);
    EXPECT_NEAR(ranged.cos_inner, std::cos(0.3f), 1e-6f);
    EXPECT_EQ(world.get<LocalLight>(spawned.nodes[2]).radius_m, k_light_reach_m);
}

TEST(Spawn, TheFirstDirectionalLightIsTheSunAndOthersShineWithoutShadows) {
    assets::Scene scene;
    scene.lights = {light("sun", assets::LightKind::directional, {1, 1, 0.5f}, 3.0f),
                    light("other", assets::LightKind::directional, {1, 1, 1}, 9.0f)};
    assets::Transform down;
    down.rotation = glm::angleAxis(-1.5707963f, glm::vec3{1, 0, 0});  // −Z turned to −Y
    for (std::uint32_t light = 0; light < 2; ++light)
        scene.nodes[add_node(scene, k_none, down)].light = light;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    const assets::Environment& environment = world.resource<Sunlight>().environment;
    EXPECT_FALSE(world.has<DirectionalLight>(spawned.nodes[0]));
    EXPECT_EQ(world.get<DirectionalLight>(spawned.nodes[1]).illuminance, glm::vec3(9.0f));
    EXPECT_NEAR(glm::distance(environment.direction_to_sun, glm::vec3(0, 1, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(environment.sun_illuminance, glm::vec3(3, 3, 1.5f));
    EXPECT_EQ(environment.sky_zenith_radiance, assets::noon().sky_zenith_radiance);
}

TEST(Spawn, ASceneWithoutLightGetsNoonAndKeepsAnyLightThatTheWorldHas) {
    ecs::World world;
    spawn(world, assets::Scene{}, {});
    EXPECT_EQ(world.resource<Sunlight>().environment.sun_illuminance, assets::noon().sun_illuminance);
    world.resource<Sunlight>().environment.sun_illuminance = glm::vec3{0.0f};
    spawn(world, assets::Scene{}, {});
    EXPECT_EQ(world.resource<Sunlight>().environment.sun_illuminance, glm::vec3(0.0f));
}

TEST(Spawn, ActorsStandOnTheirPathsWithLimbsAndWheels) {
    const assets::Place place = test::small_place(4, 2);
    ecs::World world;
    spawn(world, place, {{1, 0, 0}, {}}, 11);
    ecs::Query<const PathFollower, const LocalTransform, const Cell, const WorldTransform,
               const PreviousWorldTransform>
        actors;
    EXPECT_EQ(actors.count(world), 6u);
    actors.each(world, [](const PathFollower&, const LocalTransform& local, const Cell& cell,
                          const WorldTransform& now, const PreviousWorldTransform& before) {
        EXPECT_EQ(now.cell, cell.value);
        EXPECT_EQ(now.translation_m, local.translation_m);
        EXPECT_EQ(before.value.translation_m, now.translation_m);
    });
    EXPECT_EQ((ecs::Query<const GaitLimb>{}.count(world)), 4u * 10u);
    EXPECT_EQ((ecs::Query<const WheelSpin>{}.count(world)), 2u * 4u);
    ecs::Query<const Gait> gaits;
    gaits.each(world, [](const Gait& gait) { EXPECT_FLOAT_EQ(gait.leg_length_m, 0.9f); });
    ecs::Query<const WheelSpin> wheels;
    wheels.each(world, [](const WheelSpin& wheel) { EXPECT_FLOAT_EQ(wheel.radius_m, 0.3f); });
}

TEST(Spawn, AWalkersSoleStaysWhereItIsPut) {
    // The whole chain at once – path, gait, hierarchy: the sole of the standing leg, seen in the world.
    assets::Place place = test::small_place(1, 0);
    place.actors[0].along = 0.1f;
    ecs::World world;
    spawn(world, place, {}, 3);
    ecs::Query<ecs::Entity, const GaitLimb, const WorldTransform> limbs;
    ecs::Query<const Gait> gaits;
    glm::vec3 planted{0.0f};
    int standing_steps = 0;
    float last_phase = 2.0f;
    for (int i = 0; i < 200; ++i) {
        step(world);
        float phase = 0.0f;
        gaits.each(world, [&](const Gait& gait) { phase = gait.phase; });
        limbs.each(world, [&](ecs::Entity, const GaitLimb& limb, const WorldTransform& at) {
            if (limb.role != LimbRole::shin || limb.right || phase >= 0.5f) return;
            const glm::vec3 sole =
                offset_m({}, {at.cell, at.linear * glm::vec3{0.0f, -0.45f, 0.0f} + at.translation_m});
            if (phase > last_phase) {
                EXPECT_NEAR(glm::distance(sole, planted), 0.0f, 0.001f) << "step " << i;  // a millimetre
                EXPECT_NEAR(sole.y, 0.0f, 0.001f);
                ++standing_steps;
            }
            planted = sole;
        });
        last_phase = phase;
    }
    EXPECT_GT(standing_steps, 60);
}

}  // namespace
}  // namespace rambla::systems
