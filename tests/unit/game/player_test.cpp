#include "game/player.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "systems/position.h"

namespace rambla::game {
namespace {

using systems::WorldPosition;

/// A place inside a cell of 256 m is a float, known to 1.5e-5 m near its far side: 180 steps round it 180
/// times.
constexpr float k_rounded_walk_m = 180.0f * 1.6e-5f;

/// A closed box from `min` to `max`, as twelve triangles of one mesh.
assets::Mesh box_mesh(glm::vec3 min, glm::vec3 max) {
    assets::Mesh mesh;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back({(corner & 1u) != 0 ? max.x : min.x, (corner & 2u) != 0 ? max.y : min.y,
                                  (corner & 4u) != 0 ? max.z : min.z});
        mesh.bounds.expand(mesh.positions.back());
    }
    constexpr std::array<std::uint32_t, 24> k_quads{0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1,
                                                    2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3};
    for (std::size_t q = 0; q < k_quads.size(); q += 4) {
        for (const std::size_t i : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.indices.push_back(k_quads[q + i]);
    }
    return mesh;
}

/// A world of solid boxes that stand still.
struct Walk : testing::Test {
    ecs::World world;
    assets::Scene scene;
    WorldPosition origin;

    ecs::Entity add_box(glm::vec3 min, glm::vec3 max) {
        scene.meshes.push_back(box_mesh(min, max));
        return world.create(
            systems::WorldTransform{
                .cell = origin.cell, .linear = glm::mat3{1.0f}, .translation_m = origin.local_m},
            systems::Renderable{.mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1)},
            systems::LocalBounds{scene.meshes.back().bounds.centre(),
                                 scene.meshes.back().bounds.half_extents()});
    }
    void add_ground() { add_box({-50.0f, -1.0f, -50.0f}, {50.0f, 0.0f, 50.0f}); }

    glm::vec3 feet(const Player& player) const { return systems::offset_m(origin, player.feet); }

    /// Walks ahead (along −Z at first) for some seconds.
    Player walked(Player player, Surroundings& surroundings, float seconds,
                  PlayerIntent intent = {.move = {0.0f, 1.0f}}) {
        for (int i = 0; i < static_cast<int>(seconds * 60.0f); ++i)
            step(player, intent, surroundings);
        return player;
    }
};

TEST_F(Walk, TwoMetresASecondOnOpenGround) {
    add_ground();
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    const glm::vec3 end = feet(walked(start, surroundings, 3.0f));
    EXPECT_NEAR(end.z, -6.0f, k_rounded_walk_m);
    EXPECT_NEAR(end.x, 0.0f, 1e-4f);
    EXPECT_NEAR(end.y, 0.0f, 1e-4f);
}

TEST_F(Walk, AWallIsNotEnteredAndDoesNotHoldWhoWalksAlongIt) {
    add_ground();
    add_box({-10.0f, 0.0f, -6.0f}, {10.0f, 5.0f, -4.0f});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    EXPECT_NEAR(feet(walked(start, surroundings, 5.0f)).z, -4.0f + Walker{}.radius_m, 1e-3f);
    const glm::vec3 slid = feet(walked(start, surroundings, 5.0f, {.move = {0.7071f, 0.7071f}}));
    EXPECT_NEAR(slid.z, -4.0f + Walker{}.radius_m, 1e-2f);
    EXPECT_NEAR(slid.x, 5.0f * 2.0f * 0.7071f, 1e-2f) << "the wall takes no speed along it";
}

TEST_F(Walk, NobodyGetsOutOfAClosedRoomWhateverTheyTry) {
    add_ground();
    add_box({-4.0f, 0.0f, -4.0f}, {4.0f, 5.0f, -3.0f});
    add_box({-4.0f, 0.0f, 3.0f}, {4.0f, 5.0f, 4.0f});
    add_box({-4.0f, 0.0f, -4.0f}, {-3.0f, 5.0f, 4.0f});
    add_box({3.0f, 0.0f, -4.0f}, {4.0f, 5.0f, 4.0f});
    std::mt19937 random{11};
    std::uniform_real_distribution<float> any{-1.0f, 1.0f};
    Surroundings surroundings{world, scene};
    Player player =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    PlayerIntent intent;
    for (int i = 0; i < 6000; ++i) {
        if (i % 40 == 0)
            intent = {.move = {any(random), 1.0f},
                      .turn_rad = 0.05f * any(random),
                      .run = true,
                      .jump = i % 80 == 0};
        step(player, intent, surroundings);
        const glm::vec3 at = feet(player);
        ASSERT_LE(std::max(std::abs(at.x), std::abs(at.z)), 3.0f - Walker{}.radius_m + 1e-2f) << "step " << i;
        ASSERT_GE(at.y, -1e-3f) << "step " << i;
    }
}

TEST_F(Walk, AKerbIsClimbedAndAWallOfHalfAMetreIsNot) {
    add_ground();
    add_box({-5.0f, 0.0f, -20.0f}, {0.0f, 0.15f, -2.0f});
    add_box({0.0f, 0.0f, -20.0f}, {5.0f, 0.5f, -2.0f});
    Surroundings surroundings{world, scene};
    const Player left =
        player_at(origin, {-2.0f, k_eye_height_m, 0.0f}, {-2.0f, k_eye_height_m, -1.0f}, surroundings);
    const Player right =
        player_at(origin, {2.0f, k_eye_height_m, 0.0f}, {2.0f, k_eye_height_m, -1.0f}, surroundings);
    EXPECT_NEAR(feet(walked(left, surroundings, 3.0f)).y, 0.15f, 1e-4f);
    EXPECT_NEAR(feet(walked(left, surroundings, 3.0f)).z, -6.0f, k_rounded_walk_m);
    EXPECT_NEAR(feet(walked(right, surroundings, 3.0f)).y, 0.0f, 1e-4f);
    EXPECT_GT(feet(walked(right, surroundings, 3.0f)).z, -2.0f);
}

TEST_F(Walk, TheEyeClimbsAKerbSmoothly) {
    add_ground();
    add_box({-5.0f, 0.0f, -20.0f}, {5.0f, 0.15f, -1.0f});
    Surroundings surroundings{world, scene};
    Player player =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    float before = k_eye_height_m;
    for (int i = 0; i < 120; ++i) {
        step(player, {.move = {0.0f, 1.0f}}, surroundings);
        const float eye = systems::offset_m(origin, eye_of(player, player, 1.0f).place).y;
        // A fifth of the kerb is the most that one step shows.
        EXPECT_LE(std::abs(eye - before), 0.15f * 0.2f + 1e-4f);
        before = eye;
    }
    EXPECT_NEAR(before, k_eye_height_m + 0.15f, 1e-3f);
}

TEST_F(Walk, AJumpRisesAsFarAsItsSpeedSaysAndLands) {
    add_ground();
    Surroundings surroundings{world, scene};
    Player player =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    float highest = 0.0f;
    step(player, {.jump = true}, surroundings);
    for (int i = 0; i < 90; ++i) {
        highest = std::max(highest, feet(player).y);
        step(player, {}, surroundings);
    }
    // v²/2g = 0.589 m; Euler steps of 1/60 s lose v·dt/2 = 0.028 m of it.
    EXPECT_NEAR(highest, 0.589f, 0.03f);
    EXPECT_NEAR(feet(player).y, 0.0f, 1e-4f);
    EXPECT_TRUE(player.on_ground);
}

TEST_F(Walk, TheWorldsEndIsAWallToo) {
    add_box({-5.0f, -1.0f, -5.0f}, {5.0f, 0.0f, 5.0f});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    const glm::vec3 end = feet(walked(start, surroundings, 10.0f));
    EXPECT_GE(end.z, -5.0f - 1e-3f);
    EXPECT_NEAR(end.y, 0.0f, 1e-4f);
}

TEST_F(Walk, AThousandKilometresAwayTheWayIsTheSame) {
    origin = systems::moved({}, glm::dvec3{1.0e6, 0.0, -1.0e6});
    add_ground();
    add_box({-10.0f, 0.0f, -6.0f}, {10.0f, 5.0f, -4.0f});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    // A place inside a cell is known to 3e-5 m, and each of 300 steps rounds it once.
    EXPECT_NEAR(feet(walked(start, surroundings, 5.0f)).z, -4.0f + Walker{}.radius_m, 1e-2f);
}

TEST_F(Walk, WhatMovesIsNotSolid) {
    add_ground();
    const ecs::Entity car = add_box({-10.0f, 0.0f, -6.0f}, {10.0f, 5.0f, -4.0f});
    world.add(car, systems::PreviousWorldTransform{});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    EXPECT_NEAR(feet(walked(start, surroundings, 5.0f)).z, -10.0f, 1e-2f);
}

TEST_F(Walk, HazeIsNotSolid) {
    add_ground();
    world.create(systems::WorldTransform{.linear = glm::mat3{1.0f}}, systems::Renderable{},
                 systems::LocalBounds{{0, 1, -5}, glm::vec3{2.0f}}, systems::ParticleSource{});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    EXPECT_NEAR(feet(walked(start, surroundings, 5.0f)).z, -10.0f, 1e-2f);
}

TEST_F(Walk, FarWallsAreFoundWhenOneGetsThere) {
    add_ground();
    add_box({-10.0f, 0.0f, -46.0f}, {10.0f, 5.0f, -44.0f});
    Surroundings surroundings{world, scene};
    const Player start =
        player_at(origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, k_eye_height_m, -1.0f}, surroundings);
    EXPECT_NEAR(feet(walked(start, surroundings, 30.0f)).z, -44.0f + Walker{}.radius_m, 1e-3f);
}

TEST(Player, LooksWhereItIsTurned) {
    Player player;
    player.yaw_rad = glm::radians(90.0f);
    const systems::Eye left = eye_of(player, player, 1.0f);
    EXPECT_LT(glm::distance(left.rotation * glm::vec3{0.0f, 0.0f, -1.0f}, glm::vec3{-1.0f, 0.0f, 0.0f}),
              1e-5f);
    player.pitch_rad = glm::radians(30.0f);
    EXPECT_NEAR((eye_of(player, player, 1.0f).rotation * glm::vec3{0.0f, 0.0f, -1.0f}).y, 0.5f, 1e-5f);
}

TEST(Player, BetweenTwoStepsTheShortWayAroundIsTaken) {
    Player before;
    Player now;
    before.yaw_rad = glm::radians(179.0f);
    now.yaw_rad = glm::radians(-179.0f);
    const glm::vec3 ahead = eye_of(before, now, 0.5f).rotation * glm::vec3{0.0f, 0.0f, -1.0f};
    EXPECT_LT(glm::distance(ahead, glm::vec3{0.0f, 0.0f, 1.0f}), 1e-4f);
}

}  // namespace
}  // namespace rambla::game
