#include "systems/look/cull_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "systems/look/projection.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

using test::Random;

struct Boxes {
    std::vector<float> cx, cy, cz, hx, hy, hz;

    void add(glm::vec3 centre, glm::vec3 half) {
        cx.push_back(centre.x), cy.push_back(centre.y), cz.push_back(centre.z);
        hx.push_back(half.x), hy.push_back(half.y), hz.push_back(half.z);
    }
    [[nodiscard]] BoxColumns columns() const { return {cx, cy, cz, hx, hy, hz}; }
};

glm::mat4 random_clip_from_world(Random& random) {
    const glm::mat4 view{glm::mat3_cast(random.rotation())};
    const glm::mat4 projection =
        random.below(4) == 0 ? reversed_orthographic(random.uniform(0.1f, 500.0f),
                                                     random.uniform(0.1f, 500.0f), 0.05f, 1000.0f)
                             : reversed_perspective(random.uniform(0.05f, 2.5f), random.uniform(0.3f, 3.0f),
                                                    random.uniform(0.001f, 1.0f));
    return projection * view;
}

bool seen(const CullVolume& volume, glm::vec3 centre, glm::vec3 half) {
    Boxes boxes;
    boxes.add(centre, half);
    std::array<std::uint32_t, 1> mask{};
    cull(boxes.columns(), std::span{&volume, 1}, mask);
    return mask[0] == 1;
}

CullVolume ninety_degrees() {
    return frustum_volume(reversed_perspective(1.5707963f, 1.0f, 0.1f));
}

TEST(FrustumCulling, KnowsInsideFromOutside) {
    const CullVolume camera = ninety_degrees();
    const glm::vec3 half{0.5f};
    EXPECT_TRUE(seen(camera, {0, 0, -10}, half));
    EXPECT_FALSE(seen(camera, {0, 0, 10}, half));
    EXPECT_TRUE(seen(camera, {10.9f, 0, -10}, half));   // reaches back over the side at x = 10
    EXPECT_FALSE(seen(camera, {11.1f, 0, -10}, half));  // nearest corner (10.6, −10.5) is outside
    EXPECT_FALSE(seen(camera, {-11.1f, 0, -10}, half));
    EXPECT_FALSE(seen(camera, {0, 11.1f, -10}, half));
    EXPECT_FALSE(seen(camera, {0, -11.1f, -10}, half));
    EXPECT_TRUE(seen(camera, {0, 0, -1.0e9f}, half)) << "there is no far plane";
}

TEST(FrustumCulling, InfiniteProjectionHasFivePlanesAndAFiniteOneSix) {
    EXPECT_EQ(ninety_degrees().plane_count, 5u);
    const CullVolume box = frustum_volume(reversed_orthographic(2.0f, 1.0f, 0.5f, 100.0f));
    EXPECT_EQ(box.plane_count, 6u);
    EXPECT_TRUE(seen(box, {1.9f, 0.9f, -99.9f}, glm::vec3{0.0f}));
    EXPECT_FALSE(seen(box, {0, 0, -100.1f}, glm::vec3{0.0f}));
    EXPECT_FALSE(seen(box, {0, 0, -0.4f}, glm::vec3{0.0f}));
    EXPECT_FALSE(seen(box, {2.1f, 0, -50.0f}, glm::vec3{0.0f}));
}

/// A point is visible if its clip coordinates, computed in double from the very matrix, satisfy the
/// inequalities.
bool point_visible(const glm::dmat4& clip_from_world, const glm::dvec3& p) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4{p, 1.0};
    return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z >= 0.0 && clip.z <= clip.w;
}

TEST(FrustumCulling, NeverDropsAVisibleBox) {
    Random random{1};
    std::uint32_t visible_boxes = 0;
    for (int camera = 0; camera < 300; ++camera) {
        const glm::mat4 clip_from_world = random_clip_from_world(random);
        const CullVolume volume = frustum_volume(clip_from_world);
        const glm::dmat4 exact{clip_from_world};
        for (int i = 0; i < 300; ++i) {
            const float reach = std::exp2(random.uniform(-10.0f, 24.0f));
            const glm::vec3 centre = random.point(reach);
            const float size = reach * std::exp2(random.uniform(-24.0f, 1.0f));
            const glm::vec3 half = glm::abs(random.point(size));
            bool visible = false;
            for (int s = 0; s < 16 && !visible; ++s) {
                const glm::dvec3 at = s < 8 ? glm::dvec3{s & 1 ? 1 : -1, s & 2 ? 1 : -1, s & 4 ? 1 : -1}
                                            : glm::dvec3{random.point(1.0f)};
                visible = point_visible(exact, glm::dvec3{centre} + at * glm::dvec3{half});
            }
            if (!visible) continue;
            ++visible_boxes;
            ASSERT_TRUE(seen(volume, centre, half)) << "camera " << camera << ", box " << i;
        }
    }
    EXPECT_GT(visible_boxes, 5000u) << "the search must meet visible boxes";
}

TEST(FrustumCulling, NeverDropsAPointOnAPlaneAtAGrazingAngle) {
    Random random{2};
    for (int i = 0; i < 200000; ++i) {
        const glm::mat4 clip_from_world = random_clip_from_world(random);
        const CullVolume volume = frustum_volume(clip_from_world);
        // A corner ray of the picture lies on two side planes at once, at any distance: rounding alone
        // decides.
        const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{clip_from_world});
        const double depth = std::exp2(static_cast<double>(random.uniform(-20.0f, -1.0f)));
        const glm::dvec4 h = world_from_clip * glm::dvec4{random.below(2) ? 1.0 : -1.0,
                                                          random.below(2) ? 1.0 : -1.0, depth, 1.0};
        const glm::vec3 point{glm::dvec3{h} / h.w};
        ASSERT_TRUE(seen(volume, point, glm::vec3{0.0f})) << i;
    }
}

TEST(FrustumCulling, DropsMostOfWhatIsNotVisible) {
    // A quarter-turn frustum covers a sixth of the sphere of directions; far boxes of size zero show the
    // share exactly.
    const CullVolume camera = ninety_degrees();
    Random random{3};
    int kept = 0;
    constexpr int k_boxes = 60000;
    for (int i = 0; i < k_boxes; ++i)
        kept += seen(camera, random.direction() * 1000.0f, glm::vec3{0.0f}) ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(kept) / k_boxes, 1.0 / 6.0, 0.008);  // five standard deviations
}

TEST(FrustumCulling, ScalarAndSimdAgreeBitForBitOnAnyInput) {
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "no AVX2 here";
    Random random{4};
    std::vector<CullVolume> volumes;
    for (int i = 0; i < 5; ++i)
        volumes.push_back(frustum_volume(random_clip_from_world(random)));
    Boxes boxes;
    constexpr std::size_t k_boxes = 1000003;  // not a multiple of eight: the tail counts as well
    for (std::size_t i = 0; i < k_boxes; ++i) {
        if (i % 4 == 0) {
            const glm::vec3 centre{random.any_float(), random.any_float(), random.any_float()};
            boxes.add(centre, {random.any_float(), random.any_float(), random.any_float()});
        } else {
            const float reach = std::exp2(random.uniform(-12.0f, 24.0f));
            boxes.add(random.point(reach), glm::abs(random.point(reach * 0.25f)));
        }
    }
    std::vector<std::uint32_t> scalar(k_boxes), simd(k_boxes);
    cull_scalar(boxes.columns(), volumes, scalar);
    cull_avx2(boxes.columns(), volumes, simd);
    EXPECT_EQ(scalar, simd);
}

TEST(FrustumCulling, OneSweepAnswersForThirtyTwoVolumes) {
    Random random{5};
    std::vector<CullVolume> volumes;
    for (std::size_t v = 0; v < k_max_cull_volumes; ++v)
        volumes.push_back(frustum_volume(random_clip_from_world(random)));
    Boxes boxes;
    for (int i = 0; i < 1001; ++i)
        boxes.add(random.point(100.0f), glm::abs(random.point(5.0f)));
    std::vector<std::uint32_t> together(1001), alone(1001);
    cull(boxes.columns(), volumes, together);
    for (std::size_t v = 0; v < volumes.size(); ++v) {
        cull(boxes.columns(), std::span{&volumes[v], 1}, alone);
        for (std::size_t row = 0; row < alone.size(); ++row)
            ASSERT_EQ((together[row] >> v) & 1u, alone[row]);
    }
}

TEST(ShadowCasterVolume, HoldsEverythingWhoseShadowFallsIntoThePicture) {
    Random random{6};
    for (int camera = 0; camera < 200; ++camera) {
        const glm::mat4 clip_from_world = random_clip_from_world(random);
        const glm::vec3 to_light = random.direction();
        const CullVolume casters = shadow_caster_volume(frustum_volume(clip_from_world), to_light);
        const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{clip_from_world});
        for (int i = 0; i < 100; ++i) {
            const glm::dvec4 h = world_from_clip * glm::dvec4{random.uniform(-1, 1), random.uniform(-1, 1),
                                                              std::exp2(random.uniform(-12.0f, 0.0f)), 1.0};
            const glm::dvec3 receiver = glm::dvec3{h} / h.w;
            const double away = std::exp2(random.uniform(-4.0f, 12.0f));
            const glm::vec3 caster{receiver + glm::dvec3{to_light} * away};
            ASSERT_TRUE(seen(casters, caster, glm::vec3{0.0f})) << camera << ' ' << i;
        }
    }
}

TEST(ShadowCasterVolume, LeavesOutWhatThrowsItsShadowElsewhere) {
    const CullVolume casters = shadow_caster_volume(ninety_degrees(), {0.0f, 1.0f, 0.0f});
    EXPECT_TRUE(seen(casters, {0, 500, -10}, glm::vec3{1.0f})) << "above the picture, under the sun";
    EXPECT_FALSE(seen(casters, {0, -500, -10}, glm::vec3{1.0f}))
        << "below the picture: its shadow falls away";
    EXPECT_FALSE(seen(casters, {50, 500, -10}, glm::vec3{1.0f}));
    EXPECT_FALSE(seen(casters, {0, 500, 10}, glm::vec3{1.0f}));
}

TEST(SphereCulling, NeverDropsASphereThatReachesIntoTheFrustum) {
    Random random{7};
    for (int camera = 0; camera < 100; ++camera) {
        const glm::mat4 clip_from_world = random_clip_from_world(random);
        const CullVolume volume = frustum_volume(clip_from_world);
        const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{clip_from_world});
        for (int i = 0; i < 300; ++i) {
            const glm::dvec4 h = world_from_clip * glm::dvec4{random.uniform(-1, 1), random.uniform(-1, 1),
                                                              random.uniform(0.01f, 1.0f), 1.0};
            const float radius = random.uniform(0.0f, 20.0f);
            const glm::vec3 centre{glm::dvec3{h} / h.w +
                                   glm::dvec3{random.direction()} * (0.999999 * static_cast<double>(radius))};
            ASSERT_TRUE(sphere_may_be_seen(volume, centre, radius));
        }
    }
    EXPECT_FALSE(sphere_may_be_seen(ninety_degrees(), {0, 0, 10}, 9.0f));
    EXPECT_TRUE(sphere_may_be_seen(ninety_degrees(), {0, 0, std::numeric_limits<float>::quiet_NaN()}, 1.0f));
}

}  // namespace
}  // namespace rambla::systems
