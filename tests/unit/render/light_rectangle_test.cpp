#include "render/passes/light_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace {

using namespace rambla;
using render::sphere_rectangle;

systems::FrameView perspective_view(glm::vec3 direction) {
    systems::FrameView view;
    view.view_from_world = glm::lookAt(glm::vec3{0.0f}, direction, glm::vec3{0, 1, 0});
    const float f = 1.0f / std::tan(0.5f);
    view.clip_from_view = glm::mat4{0.0f};
    view.clip_from_view[0][0] = f / 1.5f;
    view.clip_from_view[1][1] = f;
    view.clip_from_view[2][0] = 0.1f;  // off-centre, so that the sign of that term matters
    view.clip_from_view[2][3] = -1.0f;
    view.clip_from_view[3][2] = 0.05f;
    return view;
}

systems::FrameView orthographic_view() {
    systems::FrameView view;
    view.orthographic = true;
    view.clip_from_view = glm::mat4{1.0f};
    view.clip_from_view[0][0] = 0.1f;
    view.clip_from_view[1][1] = 0.2f;
    view.clip_from_view[2][2] = 0.01f;  // depth 1 at z = 0, 0 at z = −100
    view.clip_from_view[3][2] = 1.0f;
    return view;
}

/// Every visible point of the sphere must lie in the rectangle and not behind its depth.
void expect_bounds(const systems::FrameView& view, glm::vec3 centre, float radius, std::mt19937& random) {
    std::normal_distribution<float> normal;
    const auto rectangle = sphere_rectangle(view, centre, radius);
    const glm::mat4 clip_from_world = view.clip_from_view * view.view_from_world;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 direction = glm::normalize(glm::vec3{normal(random), normal(random), normal(random)});
        const glm::vec4 c = clip_from_world * glm::vec4{centre + radius * direction, 1.0f};
        if (c.w <= 0.0f) continue;
        const glm::vec3 ndc = glm::vec3{c} / c.w;
        if (std::fabs(ndc.x) > 1.0f || std::fabs(ndc.y) > 1.0f || ndc.z < 0.0f || ndc.z > 1.0f) continue;
        ASSERT_TRUE(rectangle.has_value());
        // Float projection of a point at up to 100 m: a few units in the last place of the quotient.
        EXPECT_GE(ndc.x, rectangle->min.x - 2e-6f);
        EXPECT_LE(ndc.x, rectangle->max.x + 2e-6f);
        EXPECT_GE(ndc.y, rectangle->min.y - 2e-6f);
        EXPECT_LE(ndc.y, rectangle->max.y + 2e-6f);
        EXPECT_GE(ndc.z, rectangle->depth * (1.0f - 1e-5f) - 1e-6f);
    }
}

TEST(LightRectangle, HoldsEveryVisiblePointOfTheSphere) {
    std::mt19937 random{3};
    std::uniform_real_distribution<float> place{-40.0f, 40.0f};
    std::uniform_real_distribution<float> radius{0.0f, 30.0f};
    const systems::FrameView ahead = perspective_view(glm::normalize(glm::vec3{0.3f, -0.2f, -1.0f}));
    for (int trial = 0; trial < 400; ++trial) {
        const glm::vec3 centre{place(random), place(random), place(random)};
        expect_bounds(ahead, centre, radius(random), random);
        expect_bounds(orthographic_view(), centre, radius(random), random);
    }
}

TEST(LightRectangle, IsTightAroundASphereOnTheAxis) {
    systems::FrameView view = perspective_view({0, 0, -1});
    view.clip_from_view[2][0] = 0.0f;
    const auto rectangle = sphere_rectangle(view, {0, 0, -10}, 2.0f);
    ASSERT_TRUE(rectangle.has_value());
    // The tangent's slope is tan(asin(r/d)) = r/√(d² − r²).
    const float expected = 2.0f / std::sqrt(96.0f) * view.clip_from_view[1][1];
    EXPECT_NEAR(rectangle->max.y, expected, 1e-5f);
    EXPECT_NEAR(rectangle->min.y, -expected, 1e-5f);
    EXPECT_NEAR(rectangle->depth, 0.05f / 12.0f, 1e-7f);
}

TEST(LightRectangle, IsTheWholeScreenAroundTheEye) {
    const auto rectangle = sphere_rectangle(perspective_view({0, 0, -1}), {0.5f, 0.0f, 0.5f}, 2.0f);
    ASSERT_TRUE(rectangle.has_value());
    EXPECT_EQ(rectangle->min, glm::vec2{-1.0f});
    EXPECT_EQ(rectangle->max, glm::vec2{1.0f});
}

TEST(LightRectangle, IsAbsentOutsideTheView) {
    const systems::FrameView view = perspective_view({0, 0, -1});
    EXPECT_FALSE(sphere_rectangle(view, {0, 0, 10}, 5.0f).has_value()) << "behind";
    EXPECT_FALSE(sphere_rectangle(view, {100, 0, -10}, 5.0f).has_value()) << "to the right";
    EXPECT_FALSE(sphere_rectangle(view, {0, -100, -10}, 5.0f).has_value()) << "below";
    EXPECT_FALSE(sphere_rectangle(orthographic_view(), {0, 0, -200}, 5.0f).has_value())
        << "beyond the far plane";
}

TEST(LightRectangle, NeverReachesTheSky) {
    const auto rectangle = sphere_rectangle(perspective_view({0, 0, -1}), {0, 0, -1e9f}, 1e8f);
    ASSERT_TRUE(rectangle.has_value());
    EXPECT_GT(rectangle->depth, 0.0f);
}

}  // namespace
