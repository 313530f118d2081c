#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "systems/look/cull_kernel.h"
#include "systems/look/projection.h"

namespace rambla::systems {
namespace {

constexpr float k_max = std::numeric_limits<float>::max();
constexpr float k_denormal = std::numeric_limits<float>::denorm_min();
constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

bool seen(const CullVolume& volume, glm::vec3 centre, glm::vec3 half) {
    // Eight equal rows and one more, so that the SIMD loop and the scalar tail both answer.
    std::array<std::array<float, 9>, 6> c;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        c[axis].fill(centre[static_cast<int>(axis)]);
        c[axis + 3].fill(half[static_cast<int>(axis)]);
    }
    std::array<std::uint32_t, 9> masks{};
    cull({c[0], c[1], c[2], c[3], c[4], c[5]}, std::span{&volume, 1}, masks);
    EXPECT_EQ(masks[0], masks[8]);
    return masks[0] == 1;
}

CullVolume street_camera() {
    return frustum_volume(reversed_perspective(1.0f, 16.0f / 9.0f, 0.05f));
}

TEST(CullingHardCases, ABoxThatContainsTheCameraIsSeen) {
    EXPECT_TRUE(seen(street_camera(), {0, 0, 0}, {1, 1, 1}));
    EXPECT_TRUE(seen(street_camera(), {0, 0, 40}, {50, 50, 50}));
}

TEST(CullingHardCases, BoxesWithoutSizeAreSeenWhereTheyLie) {
    EXPECT_TRUE(seen(street_camera(), {0, 0, -1}, glm::vec3{0.0f}));
    EXPECT_TRUE(seen(street_camera(), {0, 0, -0.05f}, glm::vec3{0.0f})) << "on the near plane";
    EXPECT_FALSE(seen(street_camera(), {0, 0, 1}, glm::vec3{0.0f}));
    EXPECT_TRUE(seen(street_camera(), {0, 0, -1}, glm::vec3{k_denormal}));
    EXPECT_TRUE(seen(street_camera(), {k_denormal, k_denormal, -1}, glm::vec3{0.0f}));
}

TEST(CullingHardCases, BoxesAMillionMetresWide) {
    EXPECT_TRUE(seen(street_camera(), {0, -1, 0}, {1e6f, 0.01f, 1e6f})) << "the ground";
    EXPECT_TRUE(seen(street_camera(), {9e5f, 0, 9e5f}, {1e6f, 1e6f, 1e6f}));
    EXPECT_FALSE(seen(street_camera(), {0, 0, 1.1e6f}, {1e6f, 1e6f, 1e6f})) << "100 km behind, and of no use";
}

TEST(CullingHardCases, PlanesAtGrazingAngles) {
    // A camera of a hundredth of a degree: its side planes all but contain the view direction.
    const CullVolume telescope = frustum_volume(reversed_perspective(0.00017f, 1.0f, 0.05f));
    EXPECT_TRUE(seen(telescope, {0, 0, -1e6f}, glm::vec3{0.0f}));
    EXPECT_TRUE(seen(telescope, {84.0f, 0, -1e6f}, glm::vec3{0.0f}));  // the edge is at 85 m
    EXPECT_FALSE(seen(telescope, {200.0f, 0, -1e6f}, glm::vec3{1.0f}));
    // And one of 179.9°.
    const CullVolume wide = frustum_volume(reversed_perspective(3.14f, 1.0f, 0.05f));
    EXPECT_TRUE(seen(wide, {1000, 0, -1}, glm::vec3{0.0f}));
}

TEST(CullingHardCases, WhatIsNotANumberIsDrawn) {
    const CullVolume camera = street_camera();
    for (const float bad : {k_nan, k_inf, -k_inf}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 centre{0, 0, 100};
            glm::vec3 half{1.0f};
            centre[axis] = bad;
            EXPECT_TRUE(seen(camera, centre, half)) << bad << ' ' << axis;
            half[axis] = std::abs(bad);
            EXPECT_TRUE(seen(camera, {0, 0, 100}, half)) << bad << ' ' << axis;
        }
    }
}

TEST(CullingHardCases, SumsThatOverflowAreDrawn) {
    const CullVolume camera = street_camera();
    EXPECT_TRUE(seen(camera, glm::vec3{k_max}, glm::vec3{k_max}));
    EXPECT_TRUE(seen(camera, glm::vec3{0, 0, -k_max}, glm::vec3{k_max}));
    EXPECT_TRUE(seen(camera, glm::vec3{0, 0, k_max}, glm::vec3{k_max}));
}

TEST(CullingHardCases, BrokenMatricesHideNothing) {
    EXPECT_EQ(frustum_volume(glm::mat4{k_nan}).plane_count, 0u);
    EXPECT_EQ(frustum_volume(glm::mat4{0.0f}).plane_count, 0u);
    EXPECT_TRUE(seen(frustum_volume(glm::mat4{0.0f}), {0, 0, 100}, glm::vec3{1.0f}));
}

TEST(CullingHardCases, ALightAlongTheViewKeepsCastersBeforeAndBehind) {
    const CullVolume camera = street_camera();
    const CullVolume from_behind = shadow_caster_volume(camera, {0, 0, 1});
    EXPECT_TRUE(seen(from_behind, {0, 0, 1000}, glm::vec3{1.0f}));
    const CullVolume from_ahead = shadow_caster_volume(camera, {0, 0, -1});
    EXPECT_TRUE(seen(from_ahead, {0, 0, -1000}, glm::vec3{1.0f}));
    EXPECT_FALSE(seen(from_ahead, {0, 0, 1000}, glm::vec3{1.0f}));
}

TEST(CullingHardCases, ALightThatGrazesAPlaneDoesNotCutOffFarCasters) {
    // Light along the frustum's right side plane, but for rounding: casters on it count however far away.
    const float half_width = std::tan(0.5f) * 16.0f / 9.0f;
    const glm::vec3 along = glm::normalize(glm::vec3{half_width, 0.0f, -1.0f});
    for (const float sign : {1.0f, -1.0f}) {
        const CullVolume casters = shadow_caster_volume(street_camera(), sign * along);
        const glm::vec3 receiver = along * 10.0f;
        for (const float away : {1.0f, 1e3f, 1e6f}) {
            EXPECT_TRUE(seen(casters, receiver + sign * along * away, glm::vec3{0.0f})) << away;
        }
    }
}

}  // namespace
}  // namespace rambla::systems
