#include "systems/simulate/animation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "systems/pipeline.h"
#include "systems/position.h"
#include "systems/saved_state.h"
#include "systems/simulate/deformation.h"
#include "systems/spawn.h"
#include "unit/systems/animated_scenes.h"
#include "unit/systems/worlds.h"

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Interpolation;
using assets::k_none;
using test::add_clip;
using test::add_node;
using test::bending_arm;
using test::box_scene;

/// Where an entity's own origin is, from the corner of the origin's cell.
glm::vec3 place(const ecs::World& world, ecs::Entity entity) {
    const WorldTransform& t = world.get<WorldTransform>(entity);
    return cell_offset_m({}, t.cell) + t.translation_m;
}

/// A root with a child: the root slides along x by 1 m/s for 2 s, the child grows from 1 to 3.
assets::Scene sliding_boxes() {
    assets::Scene scene = box_scene();
    assets::Transform local;
    local.translation_m = {0, 1, 0};
    const std::uint32_t root = add_node(scene, k_none, local);
    local.translation_m = {0, 5, 0};
    const std::uint32_t child = add_node(scene, root, local);
    scene.nodes[root].model = 0;
    scene.nodes[child].model = 0;
    add_clip(scene, "slide",
             {{root, AnimatedPath::translation, Interpolation::linear, 3, {0, 2}, {0, 1, 0, 2, 1, 0}},
              {child, AnimatedPath::scale, Interpolation::linear, 3, {0, 2}, {1, 1, 1, 3, 3, 3}}});
    add_clip(scene, "jump",
             {{root, AnimatedPath::translation, Interpolation::step, 3, {0, 1}, {0, 1, 0, 0, 9, 0}}});
    return scene;
}

TEST(Animation, MovesNodesAndWhatHangsFromThem) {
    const assets::Scene scene = sliding_boxes();
    ecs::World world;
    const WorldPosition origin{{3, 0, 0}, {100.0f, 0.0f, 7.0f}};
    const SpawnedScene spawned = spawn(world, scene, origin);
    EXPECT_EQ(place(world, spawned.nodes[0]), glm::vec3(868, 1, 7)) << "at rest until a clip is chosen";
    step(world);
    EXPECT_EQ(place(world, spawned.nodes[0]), glm::vec3(868, 1, 7));
    world.get_mut<AnimationPlayer>(spawned.player).playing.clip = 0;
    for (int i = 0; i < 60; ++i)
        step(world);
    EXPECT_NEAR(world.get<AnimationPlayer>(spawned.player).playing.time_s, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(place(world, spawned.nodes[0]), glm::vec3(869, 1, 7)), 0.0f, 1e-4f);
    EXPECT_NEAR(glm::distance(place(world, spawned.nodes[1]), glm::vec3(869, 6, 7)), 0.0f, 1e-4f);
    EXPECT_NEAR(world.get<WorldTransform>(spawned.nodes[1]).linear[0].x, 2.0f, 1e-6f);
    for (int i = 0; i < 90; ++i)
        step(world);
    EXPECT_NEAR(place(world, spawned.nodes[0]).x, 868.5f, 1e-3f) << "looped";
}

TEST(Animation, WhatTheClipDoesNotMoveIsAtRest) {
    const assets::Scene scene = sliding_boxes();
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    AnimationPlayer& player = world.get_mut<AnimationPlayer>(spawned.player);
    player.playing = {.clip = 0, .time_s = 1.0};
    settle_animation(world);
    EXPECT_EQ(place(world, spawned.nodes[0]), glm::vec3(1, 1, 0)) << "at once, without a step";
    EXPECT_EQ(world.get<PreviousWorldTransform>(spawned.nodes[0]).value.translation_m, glm::vec3(1, 1, 0));
    EXPECT_EQ(world.get<AnimationPlayer>(spawned.player).playing.time_s, 1.0) << "time stood still";
    world.get_mut<AnimationPlayer>(spawned.player).playing = {.clip = 1, .time_s = 1.0};
    settle_animation(world);
    EXPECT_EQ(place(world, spawned.nodes[0]), glm::vec3(0, 9, 0));
    EXPECT_EQ(world.get<WorldTransform>(spawned.nodes[1]).linear[0].x, 1.0f) << "slide made it grow";
    for (const std::uint32_t nobody : {k_none, 2u}) {
        world.get_mut<AnimationPlayer>(spawned.player).playing.clip = nobody;
        settle_animation(world);
        EXPECT_EQ(place(world, spawned.nodes[0]), glm::vec3(0, 1, 0));
    }
}

TEST(Animation, OnlyWhatMovesTakesPartInTheSteps) {
    assets::Scene scene = sliding_boxes();
    const std::uint32_t aside = add_node(scene, k_none, {});
    scene.nodes[aside].model = 0;
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    EXPECT_TRUE(world.has<PreviousWorldTransform>(spawned.nodes[0]));
    EXPECT_TRUE(world.has<PreviousWorldTransform>(spawned.nodes[1]));
    EXPECT_FALSE(world.has<PreviousWorldTransform>(spawned.nodes[aside]));
    EXPECT_FALSE(world.has<AnimatedNode>(spawned.nodes[aside]));
    ecs::World still;
    scene.clips.clear();
    const SpawnedScene unanimated = spawn(still, scene, {});
    EXPECT_EQ(unanimated.player, ecs::Entity{});
    EXPECT_FALSE(still.has<PreviousWorldTransform>(unanimated.nodes[0]));
    EXPECT_TRUE(still.has<Cell>(unanimated.nodes[0])) << "roots stay roots";
}

TEST(Animation, PlayersKeepTheirTimesAndFades) {
    const assets::Scene scene = sliding_boxes();
    const ClipLibrary library{scene};
    AnimationPlayer player;
    player.playing = {.clip = 0, .time_s = 1.5, .speed = -2.0f, .looping = false};
    player = advanced(library, player, 0.25);
    EXPECT_EQ(player.playing.time_s, 1.0);
    player = advanced(library, player, 5.0);
    EXPECT_EQ(player.playing.time_s, 0.0) << "held at the beginning";

    AnimatedNode node;
    node.node = 0;
    node.rest.translation_m = {0, 1, 0};
    player.playing = {.clip = 0, .time_s = 1.0, .speed = 0.0f};
    cross_fade(player, {.clip = 1, .time_s = 1.0, .speed = 0.0f}, 0.5f);
    EXPECT_EQ(posed(library, player, node).translation_m, glm::vec3(1, 1, 0)) << "the old one, at first";
    player = advanced(library, player, 0.125);
    EXPECT_EQ(posed(library, player, node).translation_m, glm::vec3(0.75f, 3, 0));
    player = advanced(library, player, 1.0);
    EXPECT_EQ(posed(library, player, node).translation_m, glm::vec3(0, 9, 0)) << "the new one, after all";
    cross_fade(player, {.clip = 0, .time_s = 1.0, .speed = 0.0f}, 0.0f);
    EXPECT_EQ(posed(library, player, node).translation_m, glm::vec3(1, 1, 0)) << "at once";
}

TEST(Animation, FadesTurnAlongTheShorterArc) {
    assets::Scene scene = box_scene();
    const std::uint32_t node = add_node(scene, k_none, {});
    const auto still = [&](const char* name, glm::quat q) {
        add_clip(scene, name,
                 {{node, AnimatedPath::rotation, Interpolation::linear, 4, {0}, {q.x, q.y, q.z, q.w}}});
    };
    const glm::quat quarter = glm::angleAxis(1.5707963f, glm::vec3{0, 1, 0});
    still("ahead", {1, 0, 0, 0});
    still("left", -quarter);
    AnimationPlayer player;
    player.playing.clip = 0;
    cross_fade(player, {.clip = 1}, 1.0f);
    player.fade_left_s = 0.5f;
    AnimatedNode animated;
    animated.node = node;
    const glm::quat half = glm::angleAxis(0.78539816f, glm::vec3{0, 1, 0});
    const ClipLibrary library{scene};
    EXPECT_NEAR(std::fabs(glm::dot(posed(library, player, animated).rotation, half)), 1.0f, 1e-6f);
}

TEST(Animation, GivesMorphWeightsAndTheirBounds) {
    assets::Scene scene = box_scene();
    assets::Mesh& mesh = scene.meshes[0];
    mesh.morphs.resize(2);
    mesh.morphs[0].positions.assign(8, {4, 0, 0});
    mesh.morphs[1].positions.assign(8, {0, -3, 0});
    scene.models[0].morph_weights = {0.5f, 0};
    const std::uint32_t node = add_node(scene, k_none, {});
    scene.nodes[node].model = 0;
    add_clip(scene, "morph", {{node, AnimatedPath::weights, Interpolation::linear, 2, {0, 1}, {0, 0, 1, 2}}});
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    const auto box = [&] {
        const LocalBounds& b = world.get<LocalBounds>(spawned.nodes[node]);
        return assets::Bounds{b.centre_m - b.half_extents_m, b.centre_m + b.half_extents_m};
    };
    EXPECT_EQ(box().max, glm::vec3(2.5f, 0.5f, 0.5f)) << "the model's own weights";
    AnimationPlayer& player = world.get_mut<AnimationPlayer>(spawned.player);
    player.playing = {.clip = 0, .time_s = 0.5, .speed = 0.0f};
    settle_animation(world);
    const Deformations& poses = world.resource<Deformations>();
    const MorphPose& morph = *poses.morph(spawned.nodes[node]);
    EXPECT_EQ(poses.weights(morph)[0], 0.5f);
    EXPECT_EQ(poses.weights(morph)[1], 1.0f);
    EXPECT_EQ(poses.previous_weights(morph)[1], 1.0f);
    EXPECT_EQ(box().max, glm::vec3(2.5f, 0.5f, 0.5f));
    EXPECT_EQ(box().min, glm::vec3(-0.5f, -3.5f, -0.5f));
    world.get_mut<AnimationPlayer>(spawned.player).playing.time_s = 1.0;
    step(world);
    EXPECT_EQ(poses.weights(morph)[1], 2.0f);
    EXPECT_EQ(poses.previous_weights(morph)[1], 1.0f) << "pictures lie between the two";
    EXPECT_EQ(box().max.x, 4.5f) << "of both";
    EXPECT_EQ(box().min.y, -6.5f);
}

TEST(Animation, ASkinStandsWhereItsJointsAreWhateverItsNodeDoes) {
    const assets::Scene scene = bending_arm();
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {{-2, 0, 5}, {10, 20, 30}});
    world.get_mut<AnimationPlayer>(spawned.player).playing = {.clip = 0, .time_s = 1.0, .speed = 0.0f};
    settle_animation(world);
    ecs::Query<const Skinned> skinned;
    ASSERT_EQ(skinned.count(world), 1u);
    const Deformations& poses = world.resource<Deformations>();
    skinned.each(world, [&](const Skinned& of) {
        const SkinPose& pose = *poses.skin(of.skin);
        EXPECT_EQ(pose.cell, glm::ivec3(-2, 0, 5));
        // The elbow, 1 m up, has turned by a quarter about z: the hand, 2 m up at rest, points along −x.
        const Placement& forearm = poses.joints(pose)[1];
        const glm::vec3 hand = forearm.linear * glm::vec3{0, 2, 0} + forearm.translation_m;
        EXPECT_NEAR(glm::distance(hand, glm::vec3(9, 21, 30)), 0.0f, 1e-5f);
        const Placement& upper = poses.joints(pose)[0];
        EXPECT_NEAR(
            glm::distance(upper.linear * glm::vec3{0, 1, 0} + upper.translation_m, glm::vec3(10, 21, 30)),
            0.0f, 1e-5f);
    });
}

TEST(Animation, OfASavedWorldContinuesWithTheSameBits) {
    const assets::Scene scene = bending_arm();
    const SavedPlace where{"arm", 0, {}};
    const auto started = [&] {
        auto world = std::make_unique<ecs::World>();
        const SpawnedScene spawned = spawn(*world, scene, {});
        AnimationPlayer& player = world->get_mut<AnimationPlayer>(spawned.player);
        player.playing = {.clip = 0, .speed = 0.7f};
        cross_fade(player, {.clip = 1, .speed = 1.3f}, 3.0f);
        return world;
    };
    const auto straight = started();
    const auto saved = started();
    for (int i = 0; i < 50; ++i) {
        step(*straight);
        step(*saved);
    }
    const auto fresh = started();
    const auto restored = load_state(save_state(*saved, where), *fresh, where);
    EXPECT_EQ(state_hash(*restored), state_hash(*straight));
    Frame a, b;
    build_frame(*straight, {.place = {{}, {0, 1, 9}}}, 0.25f, a);
    build_frame(*restored, {.place = {{}, {0, 1, 9}}}, 0.25f, b);
    ASSERT_EQ(a.joints.size(), 2u);
    ASSERT_EQ(b.joints.size(), 2u) << "before any step";
    EXPECT_EQ(a.joints[1].row0, b.joints[1].row0);
    for (int i = 0; i < 200; ++i) {
        step(*straight);
        step(*restored);
        ASSERT_EQ(state_hash(*restored), state_hash(*straight)) << i;
    }
    const std::uint64_t moving = state_hash(*straight);
    ecs::Query<AnimationPlayer>{}.each(*straight, [](AnimationPlayer& p) { p.playing.time_s += 0.01; });
    EXPECT_NE(state_hash(*straight), moving) << "a player's time is state";
}

TEST(Animation, OfADamagedSaveIsRefused) {
    const assets::Scene scene = bending_arm();
    const SavedPlace where{"arm", 0, {}};
    ecs::World world;
    spawn(world, scene, {});
    ecs::Query<Skin>{}.each(world, [](Skin& skin) { skin.skeleton = 1; });
    const std::vector<std::byte> bytes = save_state(world, where);
    ecs::World fresh;
    spawn(fresh, scene, {});
    EXPECT_THROW((void)load_state(bytes, fresh, where), ecs::SnapshotError);
}

TEST(Animation, SteadyStepsAllocateNothing) {
    const assets::Scene scene = bending_arm();
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    cross_fade(world.get_mut<AnimationPlayer>(spawned.player), {.clip = 0}, 100.0f);
    Frame frame;
    const Eye eye{.place = {{}, {0, 1, 9}}};
    for (int i = 0; i < 5; ++i) {
        step(world);
        build_frame(world, eye, 0.5f, frame);
    }
    const std::size_t before = test::allocation_count();
    for (int i = 0; i < 20; ++i) {
        step(world);
        build_frame(world, eye, 0.5f, frame);
    }
    EXPECT_EQ(test::allocation_count(), before);
}

TEST(Animation, OnlyWhatIsSeenOrCastsHasItsJointsInTheFrame) {
    const assets::Scene scene = bending_arm();
    ecs::World world;
    world.set_resource(Sunlight{});
    spawn(world, scene, {});
    Frame frame;
    build_frame(world, {.place = {{}, {0, 1, 9}}}, 1.0f, frame);
    EXPECT_EQ(frame.joints.size(), 2u);
    ASSERT_EQ(frame.opaque.size(), 1u);
    EXPECT_TRUE(unpack_pipeline(frame.opaque[0].pipeline).skinned);
    EXPECT_TRUE(frame.visible.min.z < -8.5f && frame.visible.max.z < -7.0f);
    build_frame(world, {.place = {{}, {0, 1, -9}}}, 1.0f, frame);
    EXPECT_TRUE(frame.joints.empty()) << "behind the eye, without a sun";
    EXPECT_TRUE(frame.opaque.empty());
    EXPECT_TRUE(frame.visible.empty());
}

}  // namespace
}  // namespace rambla::systems
