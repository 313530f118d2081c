#include "systems/simulate/deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/deformed_vertices.h"
#include "systems/pipeline.h"
#include "systems/position.h"
#include "systems/simulate/animation.h"
#include "systems/spawn.h"

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Interpolation;

/// A chain of four joints, each a metre above the one before, with random vertices around it that follow up
/// to four of them and one morph target. A clip turns, shifts and scales all joints at random, four keys a
/// second.
assets::Scene random_creature(std::mt19937& engine, float scale_least) {
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    std::uniform_real_distribution<float> scale{scale_least, 2.0f};
    assets::Scene scene;
    scene.materials.emplace_back();
    assets::Mesh& mesh = scene.meshes.emplace_back();
    mesh.morphs.resize(1);
    for (int i = 0; i < 60; ++i) {
        mesh.positions.push_back({unit(engine), 2.0f + 3.0f * unit(engine), unit(engine)});
        mesh.joints.push_back({engine() % 4, engine() % 4, engine() % 4, engine() % 4});
        glm::vec4 weights{1.0f + unit(engine), i % 3 == 0 ? 0.0f : 1.0f + unit(engine), 0.1f, 0.0f};
        mesh.weights.push_back(weights / (weights.x + weights.y + weights.z));
        mesh.morphs[0].positions.push_back({unit(engine), unit(engine), unit(engine)});
        mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    scene.models.push_back({"creature", {{0, 0}}, {}});
    scene.skeletons.emplace_back();
    assets::Clip& clip = scene.clips.emplace_back();
    clip.duration_s = 2.0f;
    const std::vector<float> times{0, 0.25f, 0.5f, 0.75f, 1, 1.25f, 1.5f, 1.75f, 2};
    const auto values = [&](std::uint32_t width, auto&& value) {
        std::vector<float> list;
        for (std::size_t i = 0; i < times.size() * width; ++i)
            list.push_back(value());
        return list;
    };
    for (std::uint32_t j = 0; j < 4; ++j) {
        assets::Node& node = scene.nodes.emplace_back();
        node.local.translation_m = {0, j == 0 ? 0.0f : 1.0f, 0};
        if (j > 0) node.parent = j - 1;
        if (j > 0) scene.nodes[j - 1].children.push_back(j);
        scene.skeletons[0].joints.push_back(j);
        glm::mat4 bind{1.0f};
        bind[3].y = -static_cast<float>(j);
        scene.skeletons[0].joint_from_mesh.push_back(bind);
        clip.channels.push_back({j, AnimatedPath::rotation, Interpolation::linear, 4, times,
                                 values(4, [&] { return unit(engine); })});
        clip.channels.push_back({j, AnimatedPath::scale, Interpolation::linear, 3, times,
                                 values(3, [&] { return scale(engine); })});
        clip.channels.push_back({j, AnimatedPath::translation, Interpolation::linear, 3, times,
                                 values(3, [&] { return 2.0f * unit(engine); })});
    }
    clip.channels.push_back({4, AnimatedPath::weights, Interpolation::linear, 1, times,
                             values(1, [&] { return 2.0f * unit(engine); })});
    assets::Node& shown = scene.nodes.emplace_back();
    shown.model = 0;
    shown.skeleton = 0;
    scene.roots = {0, 4};
    return scene;
}

/// As test::farthest_outside; infinite if the creature is not drawn.
double farthest_outside(ecs::World& world, const assets::Scene& scene, const Eye& eye, float interpolation) {
    const test::Outside found = test::farthest_outside(world, scene, eye, interpolation);
    return found.vertices == scene.meshes[0].positions.size() ? found.distance_m
                                                              : std::numeric_limits<double>::infinity();
}

TEST(DeformationStability, NoVertexLeavesItsBoundsInAnyPose) {
    std::mt19937 engine{1};
    for (const float scale_least : {0.5f, 0.0f, -2.0f}) {
        const assets::Scene scene = random_creature(engine, scale_least);
        ecs::World world;
        const WorldPosition origin{{40, -3, 7}, {12.5f, 3.0f, 77.0f}};
        const SpawnedScene spawned = spawn(world, scene, origin);
        world.get_mut<AnimationPlayer>(spawned.player).playing = {.clip = 0, .speed = 1.3f};
        // Wide enough to see everything, so that there is an instance to look at.
        const Eye eye{.place = moved(origin, {0, 3, 60}), .vertical_fov_rad = 2.5f};
        double worst = -1e30, tightest = -1e30;
        for (int i = 0; i < 300; ++i) {
            step(world);
            for (const float interpolation : {0.0f, 0.3f, 1.0f}) {
                const double outside = farthest_outside(world, scene, eye, interpolation);
                worst = std::max(worst, outside);
                tightest = std::max(tightest, outside);
            }
        }
        EXPECT_LE(worst, 0.0) << "scales from " << scale_least;
        EXPECT_GT(tightest, -3.0) << "and the box is no barn";
    }
}

TEST(DeformationStability, HoldsAMillionMetresFromTheOriginOfItsCell) {
    // Where a float counts in sixteenths of a metre: coarse, but finite and inside the bounds.
    std::mt19937 engine{2};
    assets::Scene scene = random_creature(engine, 0.5f);
    scene.nodes[0].local.translation_m = {1e6f, 0, 0};
    for (assets::Channel& channel : scene.clips[0].channels) {
        if (channel.node != 0 || channel.path != AnimatedPath::translation) continue;
        for (std::size_t i = 0; i < channel.values.size(); i += 3)
            channel.values[i] += 1e6f;
    }
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    world.get_mut<AnimationPlayer>(spawned.player).playing.clip = 0;
    const Eye eye{.place = moved({}, {1e6, 3, 60}), .vertical_fov_rad = 2.5f};
    for (int i = 0; i < 60; ++i) {
        step(world);
        EXPECT_LE(farthest_outside(world, scene, eye, 0.5f), 0.0) << i;
    }
}

TEST(DeformationStability, JointsOfNoSizeAndBrokenTimesStayFinite) {
    std::mt19937 engine{3};
    assets::Scene scene = random_creature(engine, 0.5f);
    for (assets::Channel& channel : scene.clips[0].channels) {
        if (channel.path == AnimatedPath::scale && channel.node >= 1) {
            for (float& value : channel.values)
                value = 0.0f;
        }
    }
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    const Eye eye{.place = moved({}, {0, 3, 60}), .vertical_fov_rad = 2.5f};
    for (const double time : {k_infinity, -k_infinity, k_nan, 1e300, -1e300, 0.0}) {
        for (const float speed :
             {0.0f, -1.0f, 1e38f, -1e38f, static_cast<float>(k_nan), static_cast<float>(k_infinity)}) {
            for (const bool looping : {false, true}) {
                AnimationPlayer& player = world.get_mut<AnimationPlayer>(spawned.player);
                player.playing = {.clip = 0, .time_s = time, .speed = speed, .looping = looping};
                cross_fade(player, player.playing, speed);  // as long a fade as it is quick
                for (int i = 0; i < 3; ++i) {
                    step(world);
                    EXPECT_LE(farthest_outside(world, scene, eye, 0.5f), 0.0)
                        << "time " << time << ", speed " << speed;
                }
            }
        }
    }
}

TEST(DeformationStability, ClipsWithoutLengthOrKeysPlayWithoutHarm) {
    std::mt19937 engine{4};
    assets::Scene scene = random_creature(engine, 0.5f);
    assets::Clip moment{"moment", 0.0f, {}};
    moment.channels.push_back({0, AnimatedPath::translation, Interpolation::linear, 3, {0}, {7, 8, 9}});
    scene.clips.push_back(moment);
    scene.clips.push_back({"nothing", 0.0f, {}});
    assets::Clip broken{"broken", 1.0f, {}};
    broken.channels.push_back({0, AnimatedPath::translation, Interpolation::linear, 3, {}, {}});
    broken.channels.push_back({0, AnimatedPath::rotation, Interpolation::linear, 3, {0}, {0, 0, 0}});
    broken.channels.push_back({99, AnimatedPath::scale, Interpolation::linear, 3, {0}, {1, 1, 1}});
    broken.channels.push_back({0, AnimatedPath::scale, Interpolation::cubic_spline, 3, {0}, {1, 1, 1}});
    scene.clips.push_back(broken);
    ecs::World world;
    const SpawnedScene spawned = spawn(world, scene, {});
    for (const std::uint32_t clip : {1u, 2u, 3u}) {
        world.get_mut<AnimationPlayer>(spawned.player).playing = {.clip = clip, .time_s = 3.0};
        step(world);
        step(world);
        const glm::vec3 expected = clip == 1 ? glm::vec3{7, 8, 9} : glm::vec3{0};
        EXPECT_EQ(world.get<WorldTransform>(spawned.nodes[0]).translation_m, expected) << clip;
        const double time_s = world.get<AnimationPlayer>(spawned.player).playing.time_s;
        EXPECT_NEAR(time_s, clip == 3 ? 2.0 * k_step_s : 0.0, 1e-12) << clip;
    }
}

}  // namespace
}  // namespace rambla::systems
