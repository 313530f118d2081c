#include "systems/pack/particles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "systems/frame.h"
#include "systems/pipeline.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

using test::Random;

ParticleSource fountain() {
    return {.count = 40,
            .lifetime_s = 2.5f,
            .spread_m = 0.3f,
            .velocity_m_s = {0.5f, 6.0f, -0.2f},
            .velocity_spread_m_s = 0.4f,
            .acceleration_m_s2 = {0.1f, -9.81f, 0.0f},
            .start_radius_m = 0.05f,
            .end_radius_m = 0.4f,
            .seed = 7};
}

TEST(Particles, FollowFromTheTimeAlone) {
    const ParticleSource source = fountain();
    for (const double time : {0.0, 0.3, 17.25, 1e6, -3.7}) {
        const Particle once = particle_at(source, 3, time), again = particle_at(source, 3, time);
        EXPECT_EQ(once.centre_m, again.centre_m);
        EXPECT_EQ(once.opacity, again.opacity);
        EXPECT_TRUE(std::isfinite(once.centre_m.x + once.centre_m.y + once.centre_m.z)) << time;
    }
    ParticleSource other = source;
    other.seed = 8;
    EXPECT_NE(particle_at(source, 3, 0.3).centre_m, particle_at(other, 3, 0.3).centre_m);
    EXPECT_NE(particle_at(source, 3, 0.3).centre_m, particle_at(source, 4, 0.3).centre_m);
}

TEST(Particles, FallAlongAParabolaFromWhereTheyBegan) {
    ParticleSource source = fountain();
    source.velocity_spread_m_s = 0.0f;
    source.spread_m = 0.0f;
    source.count = 1;
    // Where it is at an age is known; its age follows from its radius, which grows evenly.
    for (double time = 0.0; time < 5.0; time += 0.09) {
        const Particle p = particle_at(source, 0, time);
        const double share = (static_cast<double>(p.radius_m) - 0.05) / 0.35;
        const double age = share * 2.5;
        EXPECT_NEAR(p.centre_m.x, 0.5 * age + 0.05 * age * age, 1e-4);
        EXPECT_NEAR(p.centre_m.y, 6.0 * age - 4.905 * age * age, 1e-4);
        EXPECT_NEAR(p.centre_m.z, -0.2 * age, 1e-4);
        // 27/4·s·(1 − s)²: 0 at both ends, 1 at a third.
        EXPECT_NEAR(p.opacity, 6.75 * share * (1.0 - share) * (1.0 - share), 1e-4);
    }
}

TEST(Particles, AppearAndDissolveWithoutAJump) {
    const ParticleSource source = fountain();
    constexpr double k_step_s = 1e-3;
    // 27/4·s·(1 − s)² is steepest at birth: 6.75 a lifetime.
    const float largest_step = static_cast<float>(6.75 * k_step_s / 2.5) * 1.01f;
    for (std::uint32_t number = 0; number < 5; ++number) {
        float before = particle_at(source, number, 0.0).opacity;
        float most = 0.0f;
        for (double time = k_step_s; time < 8.0; time += k_step_s) {
            const Particle now = particle_at(source, number, time);
            ASSERT_LE(std::abs(now.opacity - before), largest_step) << number << " at " << time;
            before = now.opacity;
            most = std::max(most, now.opacity);
        }
        EXPECT_NEAR(most, 1.0f, 1e-3f);
    }
}

TEST(Particles, EachBirthDrawsAnotherPlace) {
    ParticleSource source = fountain();
    source.velocity_spread_m_s = 0.0f;
    source.velocity_m_s = source.acceleration_m_s2 = glm::vec3{0.0f};
    std::set<float> places;
    float farthest = 0.0f;
    float nearest = 1.0f;
    for (int generation = 0; generation < 400; ++generation) {
        const Particle p = particle_at(source, 0, 2.5 * generation);
        places.insert(p.centre_m.x);
        const float from_middle = std::hypot(p.centre_m.x, p.centre_m.z);
        EXPECT_EQ(p.centre_m.y, 0.0f);
        farthest = std::max(farthest, from_middle);
        nearest = std::min(nearest, from_middle);
    }
    EXPECT_EQ(places.size(), 400u);
    EXPECT_LE(farthest, 0.3001f);
    EXPECT_GT(farthest, 0.29f);
    EXPECT_LT(nearest, 0.05f);
}

TEST(Particles, BoundsHoldThemAtAnyTime) {
    Random random{4};
    for (int i = 0; i < 300; ++i) {
        ParticleSource source;
        source.count = 1 + random.below(20);
        source.lifetime_s = i % 7 == 0 ? 0.0f : random.uniform(0.1f, 20.0f);
        source.spread_m = random.uniform(0, 3);
        source.velocity_m_s = random.point(5);
        source.velocity_spread_m_s = i % 3 == 0 ? 0.0f : random.uniform(0, 2);
        source.acceleration_m_s2 = i % 5 == 0 ? glm::vec3{0.0f} : random.point(4);
        source.start_radius_m = random.uniform(0.01f, 1);
        source.end_radius_m = random.uniform(0.01f, 2);
        source.seed = static_cast<std::uint32_t>(i);
        const LocalBounds box = particle_bounds(source);
        // Both sides are sums of three terms of this size, in floats.
        const glm::vec3 slack = 1e-6f * (glm::abs(box.centre_m) + box.half_extents_m);
        for (int k = 0; k < 200; ++k) {
            const Particle p = particle_at(source, random.below(source.count), random.uniform(-50, 500));
            const glm::vec3 beyond =
                glm::abs(p.centre_m - box.centre_m) + p.radius_m - box.half_extents_m - slack;
            ASSERT_LE(std::max({beyond.x, beyond.y, beyond.z}), 0.0f) << i;
        }
    }
}

TEST(Particles, BoundsAreNotMuchLargerThanWhatTheyHold) {
    ParticleSource source = fountain();
    source.velocity_spread_m_s = source.spread_m = 0.0f;
    source.count = 64;
    float highest = -1e9f;
    for (int k = 0; k < 20000; ++k) {
        const Particle p = particle_at(source, static_cast<std::uint32_t>(k) % 64, 0.37 * k);
        highest = std::max(highest, p.centre_m.y);
    }
    const LocalBounds box = particle_bounds(source);
    // The vertex, 6²/(2·9.81), and the largest radius above it.
    EXPECT_NEAR(box.centre_m.y + box.half_extents_m.y, 36.0f / 19.62f + 0.4f, 1e-4f);
    EXPECT_NEAR(highest, 36.0f / 19.62f, 0.02f);
}

TEST(Particles, TimesAndLifetimesBeyondReasonAreStable) {
    ParticleSource source = fountain();
    for (const float lifetime : {1e-45f, 1e-30f, 9e-4f, std::nanf("")}) {
        source.lifetime_s = lifetime;
        EXPECT_EQ(particle_at(source, 1, 7.0).opacity, 1.0f) << lifetime << " is no life: it stays";
    }
    for (const float lifetime : {1e-3f, 1.0f, 1e4f}) {
        source.lifetime_s = lifetime;
        for (const double time : {1e15, -1e15, 1e300, -1e300}) {
            const Particle p = particle_at(source, 1, time);
            EXPECT_TRUE(p.opacity >= 0.0f && p.opacity <= 1.0f) << lifetime << ' ' << time;
            EXPECT_TRUE(std::isfinite(p.centre_m.x + p.centre_m.y + p.centre_m.z));
        }
    }
}

TEST(Particles, RestingOnesAreWholeAndStay) {
    ParticleSource glow;
    glow.start_radius_m = glow.end_radius_m = 0.5f;
    for (const double time : {0.0, 5.0, 1e7}) {
        const Particle p = particle_at(glow, 0, time);
        EXPECT_EQ(p.centre_m, glm::vec3{0.0f});
        EXPECT_EQ(p.radius_m, 0.5f);
        EXPECT_EQ(p.opacity, 1.0f);
    }
}

/// A world with one source and what a frame of it holds.
struct Smoking {
    ecs::World world;
    Eye eye;
    Frame frame;
    ecs::Entity source;

    explicit Smoking(const ParticleSource& of,
                     const WorldTransform& at = {{0, 0, 0}, glm::mat3{1.0f}, {0, 0, -8}}) {
        const Pipeline haze{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend), .haze = true};
        source =
            world.create(at, Renderable{assets::k_none, 3, pack(haze)}, particle_bounds(of), of, NoShadow{});
        eye.size_px = {64, 64};
    }
    const Frame& look() {
        build_frame(world, eye, 1.0f, frame);
        return frame;
    }
};

std::uint32_t instances_of(const std::vector<DrawBatch>& queue) {
    std::uint32_t sum = 0;
    for (const DrawBatch& batch : queue)
        sum += batch.instance_count;
    return sum;
}

TEST(ParticleQueue, HoldsTheBallsFarOnesFirstInOneBatch) {
    Smoking smoking{fountain()};
    const Frame& frame = smoking.look();
    EXPECT_TRUE(frame.opaque.empty());
    ASSERT_EQ(frame.blended.size(), 1u);
    const DrawBatch& batch = frame.blended[0];
    EXPECT_TRUE(unpack_pipeline(batch.pipeline).haze);
    EXPECT_EQ(batch.mesh, assets::k_none);
    EXPECT_EQ(batch.material, 3u);
    EXPECT_EQ(frame.casters.size(), 0u);
    EXPECT_FALSE(frame.needs_emission) << "the G-buffer has nothing of haze";
    std::uint32_t expected = 0;
    for (std::uint32_t i = 0; i < 40; ++i)
        expected += particle_at(fountain(), i, 0.0).opacity > 0.5f / 255.0f ? 1 : 0;
    EXPECT_EQ(batch.instance_count, expected);
    EXPECT_GT(expected, 30u);
    for (std::uint32_t i = 0; i < batch.instance_count; ++i) {
        const Instance& ball = frame.instances[batch.first_instance + i];
        EXPECT_GT(ball.row0.x, 0.0f);
        EXPECT_EQ(ball.material & k_instance_material_mask, 3u);
        EXPECT_EQ(ball.object, smoking.source.index);
        if (i > 0) {
            EXPECT_GE(ball.row2.w, frame.instances[batch.first_instance + i - 1].row2.w);
        }
    }
}

TEST(ParticleQueue, WhatTheCameraDoesNotSeeIsNotSimulated) {
    Smoking smoking{fountain(), {{0, 0, 0}, glm::mat3{1.0f}, {0, 0, 30}}};
    EXPECT_TRUE(smoking.look().instances.empty());
    EXPECT_EQ(smoking.frame.counts.visible, 0u);
}

TEST(ParticleQueue, WhatASourceHasBecomeIsSeenWhateverItsBoundsSay) {
    Smoking smoking{fountain()};
    const std::uint32_t seen = instances_of(smoking.look().blended);
    ASSERT_GT(seen, 30u);
    smoking.world.get_mut<LocalBounds>(smoking.source) = {{0, 0, 60}, glm::vec3{0.01f}};
    EXPECT_EQ(instances_of(smoking.look().blended), seen) << "though its bounds lie behind the eye";

    // A jet of 75 m, which starts far beside the picture, is turned into it.
    ParticleSource jet = fountain();
    jet.velocity_m_s = {-30, 0, 0};
    jet.acceleration_m_s2 = glm::vec3{0.0f};
    Smoking aside{jet, {{0, 0, 0}, glm::mat3{1.0f}, {-40, 0, -8}}};
    EXPECT_EQ(instances_of(aside.look().blended), 0u);
    aside.world.get_mut<ParticleSource>(aside.source).velocity_m_s.x = 30.0f;
    EXPECT_GT(instances_of(aside.look().blended), 0u);
    aside.world.get_mut<ParticleSource>(aside.source).velocity_m_s.x = -30.0f;
    EXPECT_EQ(instances_of(aside.look().blended), 0u);
}

TEST(ParticleQueue, MovesWithTheTimeShownAndWithNothingElse) {
    Smoking smoking{fountain()};
    smoking.look();
    const std::vector<Instance> first = smoking.frame.instances;
    smoking.look();
    ASSERT_EQ(smoking.frame.instances.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        EXPECT_EQ(smoking.frame.instances[i].row1, first[i].row1);
    for (int i = 0; i < 30; ++i)
        step(smoking.world);
    smoking.look();
    EXPECT_NE(smoking.frame.instances[0].row1, first[0].row1);
}

TEST(ParticleQueue, BallsStayBallsInAnySpaceAndWithinItsBox) {
    Random random{5};
    ParticleSource glow;
    glow.start_radius_m = glow.end_radius_m = 0.5f;
    for (int i = 0; i < 300; ++i) {
        glm::mat3 linear{random.point(2), random.point(2), random.point(2)};
        if (i == 0) linear = {glm::vec3{8, 0, 0}, {0, -2, 0}, {0, 0, 3}};
        Smoking smoking{glow, {{0, 0, 0}, linear, {0, 0, -8}}};
        const Frame& frame = smoking.look();
        if (i == 0) {
            EXPECT_FLOAT_EQ(frame.instances.at(0).row0.x, 1.0f) << "half a metre, by the least of its axes";
        }
        ASSERT_EQ(frame.blended.size(), 1u);
        EXPECT_FALSE(unpack_pipeline(frame.blended[0].pipeline).mirrored) << "or it would show its back";
        const Instance& ball = frame.instances.at(0);
        EXPECT_EQ(ball.row0.x, ball.row1.y);
        EXPECT_EQ(ball.row0.x, ball.row2.z);
        const glm::vec3 half = frame.visible.half_extents();
        EXPECT_LE(ball.row0.x, std::min({half.x, half.y, half.z}) * 1.00001f) << "seen as long as its box is";
    }
}

TEST(ParticleQueue, NumbersThatAreNoneDrawNothing) {
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity(), 3e38f}) {
        ParticleSource source = fountain();
        source.velocity_m_s.x = bad;
        source.lifetime_s = 1e3f;
        Smoking smoking{source};
        EXPECT_EQ(instances_of(smoking.look().blended), 0u) << bad;
    }
}

TEST(ParticleQueue, SourcesOfSeveralMaterialsAreSortedAmongEachOther) {
    Smoking smoking{fountain()};
    const Pipeline haze{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend), .haze = true};
    ParticleSource other = fountain();
    other.seed = 99;
    smoking.world.create(WorldTransform{{0, 0, 0}, glm::mat3{1.0f}, {0, 0, -8}},
                         Renderable{assets::k_none, 4, pack(haze)}, particle_bounds(other), other,
                         NoShadow{});
    const Frame& frame = smoking.look();
    EXPECT_GT(frame.blended.size(), 10u);
    for (std::size_t i = 1; i < frame.instances.size(); ++i)
        EXPECT_GE(frame.instances[i].row2.w, frame.instances[i - 1].row2.w);
}

}  // namespace
}  // namespace rambla::systems
