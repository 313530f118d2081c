#include "systems/simulate/movers.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "ecs/query.h"
#include "systems/pipeline.h"
#include "systems/simulate/trigonometry.h"
#include "systems/spawn.h"
#include "unit/systems/worlds.h"

namespace rambla::systems {
namespace {

constexpr float k_step = 1.0f / 60.0f;
constexpr auto k_pi_f = static_cast<float>(k_pi);

/// Movers that are children of one node, each on a course of its own.
assets::Place field(int movers) {
    assets::Place place;
    place.scene = test::box_scene();
    const std::uint32_t stand = test::add_node(place.scene, assets::k_none, {});
    place.mover_reach_m = 190.0f;
    for (int i = 0; i < movers; ++i) {
        assets::Transform at;
        at.translation_m = {static_cast<float>(i % 380) - 189.5f, 0.0f, static_cast<float>(i / 380) - 20.0f};
        const std::uint32_t node = test::add_node(place.scene, stand, at);
        place.scene.nodes[node].model = 0;
        place.movers.push_back({node, 0.37f * static_cast<float>(i), 1.0f + 0.001f * static_cast<float>(i)});
    }
    return place;
}

TEST(Movers, GoStraightAhead) {
    const Course east = advanced({1.0f, 2.0f, 0.0f}, 3.0f, 190.0f, k_step);
    EXPECT_NEAR(east.x_m, 1.05f, 1e-6f);
    EXPECT_NEAR(east.z_m, 2.0f, 1e-6f);
    const Course south = advanced({1.0f, 2.0f, 0.5f * k_pi_f}, 3.0f, 190.0f, k_step);
    EXPECT_NEAR(south.x_m, 1.0f, 1e-6f);
    EXPECT_NEAR(south.z_m, 2.05f, 1e-6f);
    EXPECT_EQ(south.heading_rad, 0.5f * k_pi_f);
}

TEST(Movers, AreMirroredByTheWalls) {
    const Course x = advanced({189.99f, 0.0f, 0.3f}, 5.0f, 190.0f, k_step);
    EXPECT_EQ(x.x_m, 190.0f);
    EXPECT_EQ(x.heading_rad, k_pi_f - 0.3f);
    EXPECT_NEAR(x.z_m, std::sin(0.3f) * 5.0f * k_step, 1e-6f);
    const Course z = advanced({0.0f, -189.99f, -0.3f}, 50.0f, 190.0f, k_step);
    EXPECT_EQ(z.z_m, -190.0f);
    EXPECT_EQ(z.heading_rad, 0.3f);
    const Course corner = advanced({189.99f, 189.99f, 0.8f}, 5.0f, 190.0f, k_step);
    EXPECT_EQ(corner.heading_rad, -(k_pi_f - 0.8f)) << "x first, then z";
    // Afterwards it leaves the wall, and is not mirrored again.
    EXPECT_LT(advanced(x, 5.0f, 190.0f, k_step).x_m, 190.0f);
    EXPECT_EQ(advanced(x, 5.0f, 190.0f, k_step).heading_rad, x.heading_rad);
}

TEST(Movers, LookWhereTheyGo) {
    for (const float heading : {-4.0f, -0.5f, 0.0f, 1.0f, 2.5f, 7.0f}) {
        const glm::vec3 ahead = heading_rotation(heading) * glm::vec3{1, 0, 0};
        EXPECT_NEAR(ahead.x, std::cos(heading), 1e-6f);
        EXPECT_NEAR(ahead.y, 0.0f, 1e-6f);
        EXPECT_NEAR(ahead.z, std::sin(heading), 1e-6f);
    }
}

TEST(Movers, OfAPlaceMoveInTheStepAndStayWithinTheirWalls) {
    const assets::Place place = field(1000);
    const WorldPosition origin{{3, 0, -2}, {17.0f, 5.0f, 200.0f}};
    ecs::World world;
    const SpawnedScene spawned = spawn(world, place, origin, 1);
    Course expected{place.scene.nodes[place.movers[7].node].local.translation_m.x,
                    place.scene.nodes[place.movers[7].node].local.translation_m.z,
                    place.movers[7].heading_rad};
    for (int i = 0; i < 600; ++i) {
        step(world);
        expected = advanced(expected, place.movers[7].speed_m_s, 190.0f, k_step);
    }
    const ecs::Entity seventh = spawned.nodes[place.movers[7].node];
    EXPECT_EQ(world.get<LocalTransform>(seventh).translation_m, glm::vec3(expected.x_m, 0.0f, expected.z_m));
    const WorldTransform& there = world.get<WorldTransform>(seventh);
    EXPECT_EQ(there.cell, origin.cell);
    // Sums of coordinates below 512 are rounded to 2⁻¹⁵ m.
    EXPECT_NEAR(
        glm::distance(there.translation_m, origin.local_m + glm::vec3(expected.x_m, 0.0f, expected.z_m)),
        0.0f, 1e-4f);
    ecs::Query<const Mover, const LocalTransform> movers;
    EXPECT_EQ(movers.count(world), 1000u);
    movers.each(world, [](const Mover&, const LocalTransform& local) {
        EXPECT_LE(std::abs(local.translation_m.x), 190.0f);
        EXPECT_LE(std::abs(local.translation_m.z), 190.0f);
    });
}

TEST(Movers, AreTheSameForAnyNumberOfThreads) {
    const assets::Place place = field(3000);
    const auto hash_with = [&](std::size_t threads) {
        const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, threads};
        ecs::World world;
        spawn(world, place, {}, 1);
        for (int i = 0; i < 100; ++i)
            step(world);
        return state_hash(world);
    };
    const std::uint64_t one = hash_with(1);
    EXPECT_EQ(one, hash_with(2));
    EXPECT_EQ(one, hash_with(7));
    ecs::World rest;
    spawn(rest, place, {}, 1);
    EXPECT_NE(one, state_hash(rest));
}

}  // namespace
}  // namespace rambla::systems
