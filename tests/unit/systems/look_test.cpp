#include <gtest/gtest.h>

#include <limits>

#include "systems/look/culling.h"
#include "systems/look/lights.h"
#include "systems/look/projection.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

using test::Random;

CullVolume ninety_degrees() {
    return frustum_volume(reversed_perspective(1.5707963f, 1.0f, 0.1f));
}

WorldTransform at(glm::vec3 p) {
    return {{0, 0, 0}, glm::mat3{1.0f}, p};
}

TEST(EnclosingBox, HoldsEveryPointOfTheBoxAsItIsDrawn) {
    Random random{1};
    for (int i = 0; i < 50000; ++i) {
        const LocalBounds bounds{random.point(std::exp2(random.uniform(-8, 8))),
                                 glm::abs(random.point(std::exp2(random.uniform(-12, 6))))};
        Placement place{glm::mat3{random.point(3), random.point(3), random.point(3)},
                        random.point(std::exp2(random.uniform(-4, 20)))};
        if (i % 5 == 0) place.linear[0] = glm::vec3{0.0f};
        const LocalBounds box = enclosing_box(bounds, place);
        const glm::dvec3 corner{random.below(2) ? 1 : -1, random.below(2) ? 1 : -1, random.below(2) ? 1 : -1};
        const glm::dvec3 local = glm::dvec3{bounds.centre_m} + corner * glm::dvec3{bounds.half_extents_m};
        const glm::dvec3 p = glm::dmat3{place.linear} * local + glm::dvec3{place.translation_m};
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(std::abs(p[axis] - static_cast<double>(box.centre_m[axis])),
                      static_cast<double>(box.half_extents_m[axis]));
        }
    }
}

TEST(Placement, InterpolatesBetweenStepsExactlyAtBothEnds) {
    Random random{2};
    const WorldTransform before{{3, 0, 0}, glm::mat3_cast(random.rotation()), {255.9f, 0, 1}};
    const WorldTransform now{{4, 0, 0}, glm::mat3_cast(random.rotation()), {0.1f, 0, 1}};
    const WorldPosition eye{{3, 0, 0}, {200, 0, 0}};
    EXPECT_EQ(placement(before, now, {eye, 0.0f}).translation_m, placement(before, {eye}).translation_m);
    EXPECT_EQ(placement(before, now, {eye, 0.0f}).linear, before.linear);
    EXPECT_EQ(placement(before, now, {eye, 1.0f}).translation_m, placement(now, {eye}).translation_m);
    EXPECT_EQ(placement(before, now, {eye, 1.0f}).linear, now.linear);
    EXPECT_NEAR(placement(before, now, {eye, 0.25f}).translation_m.x, 55.95f, 3e-5f);
}

TEST(Culling, SeesResidentsOfTheFrustumAcrossChunksAndArchetypes) {
    Random random{3};
    ecs::World world;
    for (int i = 0; i < 6000; ++i) {
        const WorldTransform place = at(random.point(50.0f));
        const LocalBounds bounds{{0, 0, 0}, glm::vec3{0.5f}};
        const Renderable drawn{0, 0, 0};
        switch (i % 3) {
            case 0:
                world.create(place, drawn, bounds);
                break;
            case 1:
                world.create(place, drawn, bounds, NoShadow{});
                break;
            default:
                world.create(place, drawn, bounds, PreviousWorldTransform{place});
                break;
        }
    }
    const CullVolume camera = ninety_degrees();
    Culling culling;
    culling(world, {}, std::span{&camera, 1});
    std::size_t rows = 0;
    std::size_t seen = 0;
    for (const LookChunk& chunk : culling.chunks()) {
        EXPECT_EQ(chunk.first_row, rows);
        for (std::size_t i = 0; i < chunk.entities.size(); ++i) {
            const glm::vec3 p = chunk.now[i].translation_m;
            const float half = 0.5f;
            // The frustum |x|, |y| ≤ −z against a box, away from the border by more than any rounding.
            const float margin = std::min(-p.z - std::abs(p.x), -p.z - std::abs(p.y)) + 2.0f * half;
            const bool visible = (culling.seen_by()[rows] & 1u) != 0;
            if (margin > 0.01f && p.z < 0.0f) {
                ASSERT_TRUE(visible);
            }
            if (margin < -0.01f) {
                ASSERT_FALSE(visible);
            }
            ASSERT_EQ(chunk.casts_shadows, !world.has<NoShadow>(chunk.entities[i]));
            seen += visible ? 1 : 0;
            ++rows;
        }
    }
    EXPECT_EQ(rows, 6000u);
    EXPECT_GT(seen, 500u);
    EXPECT_LT(seen, 2000u);
}

TEST(Culling, DrawsAndCountsBrokenBounds) {
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float k_inf = std::numeric_limits<float>::infinity();
    ecs::World world;
    const Renderable drawn{0, 0, 0};
    world.create(at({0, 0, 100}), drawn, LocalBounds{{0, 0, 0}, glm::vec3{k_inf}});
    world.create(at({0, 0, 100}), drawn, LocalBounds{{k_nan, 0, 0}, glm::vec3{1.0f}});
    world.create(at({0, -k_inf, 100}), drawn, LocalBounds{{0, 0, 0}, glm::vec3{1.0f}});
    world.create(at({0, 0, 100}), drawn, LocalBounds{{0, 0, 0}, glm::vec3{1.0f}});
    const CullVolume camera = ninety_degrees();
    Culling culling;
    culling(world, {}, std::span{&camera, 1});
    EXPECT_EQ(culling.broken_bounds(), 3u);
    for (int row = 0; row < 3; ++row)
        EXPECT_EQ(culling.seen_by()[static_cast<std::size_t>(row)], 1u);
    EXPECT_EQ(culling.seen_by()[3], 0u) << "behind the camera";
}

TEST(Lights, ThoseWhoseSpheresReachIntoThePictureAreFound) {
    ecs::World world;
    const LocalLight lamp{{1, 2, 3}, 5.0f};
    world.create(at({0, 0, -10}), lamp);
    world.create(at({0, 0, 4}), lamp);                          // behind, reaches in front
    world.create(at({0, 0, 6}), lamp);                          // behind, does not
    world.create(at({0, 0, -5}), LocalLight{{0, 0, 0}, 5.0f});  // dark
    LightSearch search;
    std::vector<FrameLight> found;
    EXPECT_EQ(search(world, {}, ninety_degrees(), found), 4u);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].position_m, glm::vec3(0, 0, -10));
    EXPECT_EQ(found[0].intensity, glm::vec3(1, 2, 3));
    EXPECT_EQ(found[0].direction, glm::vec3(0, 0, -1));
}

TEST(Lights, DirectionalOnesAreFoundWhereverTheyStand) {
    ecs::World world;
    world.create(at({0, 0, 1e6f}), DirectionalLight{{1, 2, 3}});
    world.create(at({0, 0, -1}), DirectionalLight{{0, 0, 0}});  // dark
    world.create(at({0, 0, -1}), LocalLight{{1, 1, 1}, 5.0f});
    DirectionalLightSearch search;
    std::vector<FrameLight> found{FrameLight{}, FrameLight{}};
    EXPECT_EQ(search(world, {}, found), 2u);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].intensity, glm::vec3(1, 2, 3));
    EXPECT_EQ(found[0].direction, glm::vec3(0, 0, -1));
}

TEST(Lights, DirectionIsAUnitVectorUnderAnyScale) {
    for (const float scale : {1e-30f, 1.0f, 1e30f}) {
        const FrameLight light = frame_light(LocalLight{}, {glm::mat3{scale}, {}});
        EXPECT_EQ(light.direction, glm::vec3(0, 0, -1)) << scale;
    }
    EXPECT_EQ(frame_light(LocalLight{}, {glm::mat3{0.0f}, {}}).direction, glm::vec3(0, -1, 0));
}

}  // namespace
}  // namespace rambla::systems
