#include "systems/look/projection.h"

#include <gtest/gtest.h>

namespace rambla::systems {
namespace {

float depth_of(const glm::mat4& clip_from_view, glm::vec3 p) {
    const glm::vec4 clip = clip_from_view * glm::vec4{p, 1.0f};
    return clip.z / clip.w;
}

TEST(ReversedPerspective, DepthIsNearOverDistance) {
    const glm::mat4 m = reversed_perspective(1.0f, 1.6f, 0.05f);
    EXPECT_FLOAT_EQ(depth_of(m, {0, 0, -0.05f}), 1.0f);
    EXPECT_FLOAT_EQ(depth_of(m, {1, 2, -10.0f}), 0.005f);
    EXPECT_GT(depth_of(m, {0, 0, -1e30f}), 0.0f);
}

TEST(ReversedPerspective, FieldOfViewReachesThePicturesEdge) {
    const glm::mat4 m = reversed_perspective(1.5707963f, 2.0f, 0.05f);
    const glm::vec4 corner = m * glm::vec4{20.0f, 10.0f, -10.0f, 1.0f};
    EXPECT_NEAR(corner.x / corner.w, 1.0f, 1e-6f);  // tan 45° is one within the rounding of π/2
    EXPECT_NEAR(corner.y / corner.w, 1.0f, 1e-6f);
}

TEST(ReversedOrthographic, DepthFallsLinearlyFromNearToFar) {
    const glm::mat4 m = reversed_orthographic(4.0f, 3.0f, 2.0f, 10.0f);
    EXPECT_FLOAT_EQ(depth_of(m, {0, 0, -2}), 1.0f);
    EXPECT_FLOAT_EQ(depth_of(m, {0, 0, -6}), 0.5f);
    EXPECT_FLOAT_EQ(depth_of(m, {0, 0, -10}), 0.0f);
    const glm::vec4 corner = m * glm::vec4{4.0f, -3.0f, -5.0f, 1.0f};
    EXPECT_EQ(glm::vec2(corner), glm::vec2(1.0f, -1.0f));
}

}  // namespace
}  // namespace rambla::systems
