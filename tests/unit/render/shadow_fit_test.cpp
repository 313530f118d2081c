#include "render/shadow/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "render/shadow/convex.h"

namespace {

using namespace rambla;
using render::shadow::fit_sun_map;
using render::shadow::FitInput;
using render::shadow::SunFit;

constexpr float k_near_m = 0.05f;

/// Reversed Z, infinite far plane.
glm::mat4 perspective(float vertical_fov_rad, float aspect) {
    const float f = 1.0f / std::tan(0.5f * vertical_fov_rad);
    glm::mat4 p{0.0f};
    p[0][0] = f / aspect;
    p[1][1] = f;
    p[2][3] = -1.0f;
    p[3][2] = k_near_m;
    return p;
}

systems::FrameView view_along(glm::vec3 direction) {
    const glm::vec3 up = std::fabs(direction.y) > 0.99f ? glm::vec3{0, 0, 1} : glm::vec3{0, 1, 0};
    systems::FrameView view;
    view.view_from_world = glm::lookAt(glm::vec3{0.0f}, direction, up);
    view.clip_from_view = perspective(1.0f, 16.0f / 9.0f);
    view.size_px = {960, 540};
    return view;
}

void add_caster(systems::CasterColumns& casters, glm::vec3 centre, glm::vec3 half) {
    casters.centre_x.push_back(centre.x);
    casters.centre_y.push_back(centre.y);
    casters.centre_z.push_back(centre.z);
    casters.half_x.push_back(half.x);
    casters.half_y.push_back(half.y);
    casters.half_z.push_back(half.z);
    casters.pipeline.push_back(0);
    casters.material.push_back(0);
    casters.mesh.push_back(0);
    casters.instance.push_back(0);
}

/// A hundred metres of street around the eye, with walls on both sides.
FitInput street(glm::vec3 view_direction, glm::vec3 to_sun) {
    return {.view = view_along(view_direction),
            .direction_to_sun = glm::normalize(to_sun),
            .distance_m = 80.0f,
            .receivers = {{-12.0f, -1.7f, -100.0f}, {12.0f, 20.0f, 100.0f}},
            .size_texels = 1024};
}
systems::CasterColumns walls() {
    systems::CasterColumns casters;
    add_caster(casters, {-10.0f, 8.0f, 0.0f}, {2.0f, 10.0f, 100.0f});
    add_caster(casters, {10.0f, 8.0f, 0.0f}, {2.0f, 10.0f, 100.0f});
    return casters;
}

void expect_sound(const SunFit& fit) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            ASSERT_TRUE(std::isfinite(fit.clip_from_world[column][row]));
    }
    const glm::dmat4 m{fit.clip_from_world};
    const double determinant = glm::determinant(m);
    ASSERT_TRUE(std::isfinite(determinant));
    ASSERT_NE(determinant, 0.0);
    // Rows scale 2/extent and 1/depth: the inverse of such a matrix is well defined up to rounding of its
    // entries.
    const glm::dmat4 identity = m * glm::inverse(m);
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(identity[i][i], 1.0, 1e-9);
    EXPECT_GT(fit.texel_m.x, 0.0f);
    EXPECT_GT(fit.texel_m.y, 0.0f);
}

TEST(SunMapFit, CoversEveryReceiverThatACasterCanShadow) {
    std::mt19937 random{7};
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    int seen = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const glm::vec3 sun{unit(random), 0.2f + std::fabs(unit(random)), unit(random)};
        const FitInput input =
            street(glm::normalize(glm::vec3{unit(random), 0.3f * unit(random), unit(random)}), sun);
        const SunFit fit = fit_sun_map(input, walls());
        ASSERT_FALSE(fit.empty);
        expect_sound(fit);
        const glm::mat4 clip_from_world = input.view.clip_from_view * input.view.view_from_world;
        for (int i = 0; i < 400; ++i) {
            // Points of both walls that face the street: receivers and casters at once.
            const glm::vec3 p{unit(random) < 0.0f ? -8.0f : 8.0f, 8.0f + 9.5f * unit(random),
                              79.0f * unit(random)};
            const glm::vec4 c = clip_from_world * glm::vec4{p, 1.0f};
            if (std::fabs(c.x) > c.w || std::fabs(c.y) > c.w || c.w > input.distance_m || c.w < k_near_m)
                continue;
            ++seen;
            const glm::vec4 m = fit.clip_from_world * glm::vec4{p, 1.0f};
            // 1e-5: float rounding of coordinates up to 100 m in a map of a thousand texels, a hundredth of a
            // texel.
            EXPECT_LE(std::fabs(m.x), 1.0f + 1e-5f);
            EXPECT_LE(std::fabs(m.y), 1.0f + 1e-5f);
            EXPECT_GE(m.z, 0.0f);
            EXPECT_LE(m.z, 1.0f);
        }
    }
    EXPECT_GT(seen, 10000) << "the test looked at too few points";
}

TEST(SunMapFit, DepthIsOneTowardsTheSun) {
    const FitInput input = street({0, 0, -1}, {0.3f, 1.0f, 0.2f});
    const SunFit fit = fit_sun_map(input, walls());
    const glm::vec3 p{0.0f, 0.0f, -20.0f};
    const float near = (fit.clip_from_world * glm::vec4{p + input.direction_to_sun, 1.0f}).z;
    const float far = (fit.clip_from_world * glm::vec4{p, 1.0f}).z;
    EXPECT_NEAR((near - far) * fit.depth_m, 1.0f, 1e-3f);  // one metre; float coordinates of tens of metres
}

TEST(SunMapFit, IsSoundWithTheLightAlongAndAgainstTheView) {
    for (const float tilt : {0.0f, 1e-7f, 1e-4f, 1e-3f, 2e-3f, 0.01f}) {
        for (const float sign : {1.0f, -1.0f}) {
            const glm::vec3 sun = glm::normalize(glm::vec3{0.3f, 0.5f, 0.81f});
            const glm::vec3 view = glm::normalize(sign * sun + glm::vec3{tilt, 0.0f, 0.0f});
            const SunFit fit = fit_sun_map(street(view, sun), walls());
            expect_sound(fit);
        }
    }
    expect_sound(fit_sun_map(street({0, -1, 0}, {0, 1, 0}), walls()));
    expect_sound(fit_sun_map(street({0, 1, 0}, {0, 1, 0}), walls()));
}

TEST(SunMapFit, IsSoundWithTheSunBelowTheHorizonAndOnIt) {
    for (const glm::vec3 sun :
         {glm::vec3{0.2f, -0.5f, 0.1f}, glm::vec3{0, -1, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, 0, 1}}) {
        expect_sound(fit_sun_map(street({0, 0, -1}, sun), walls()));
    }
}

TEST(SunMapFit, IsEmptyButInvertibleWhereNoShadowCanFall) {
    const FitInput input = street({0, 0, -1}, {0.3f, 1.0f, 0.2f});
    const SunFit no_casters = fit_sun_map(input, {});
    EXPECT_TRUE(no_casters.empty);
    expect_sound(no_casters);

    FitInput nothing_seen = input;
    nothing_seen.receivers = {};
    EXPECT_TRUE(fit_sun_map(nothing_seen, walls()).empty);

    FitInput behind_the_eye = input;
    behind_the_eye.receivers = {{-1.0f, -1.0f, 10.0f}, {1.0f, 1.0f, 12.0f}};
    EXPECT_TRUE(fit_sun_map(behind_the_eye, walls()).empty);

    systems::CasterColumns far_aside;
    add_caster(far_aside, {5000.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f});
    EXPECT_TRUE(fit_sun_map(input, far_aside).empty);

    systems::CasterColumns underground;
    add_caster(underground, {0.0f, -500.0f, 0.0f}, {50.0f, 1.0f, 50.0f});
    FitInput sun_overhead = input;
    sun_overhead.direction_to_sun = {0, 1, 0};
    EXPECT_TRUE(fit_sun_map(sun_overhead, underground).empty);
}

TEST(SunMapFit, IsSoundForOnePoint) {
    FitInput input = street({0, 0, -1}, {0.3f, 1.0f, 0.2f});
    input.receivers = {{0.0f, 0.0f, -10.0f}, {0.0f, 0.0f, -10.0f}};
    systems::CasterColumns point;
    add_caster(point, {0.0f, 0.0f, -10.0f}, {0.0f, 0.0f, 0.0f});
    const SunFit fit = fit_sun_map(input, point);
    EXPECT_FALSE(fit.empty);
    expect_sound(fit);
}

TEST(SunMapFit, IsSoundForTenKilometres) {
    FitInput input = street(glm::normalize(glm::vec3{0.1f, -0.3f, -1.0f}), {0.3f, 0.2f, 0.2f});
    input.distance_m = 10000.0f;
    input.receivers = {{-10000.0f, -50.0f, -10000.0f}, {10000.0f, 500.0f, 10000.0f}};
    systems::CasterColumns casters;
    add_caster(casters, {0.0f, 0.0f, 0.0f}, {10000.0f, 400.0f, 10000.0f});
    const SunFit fit = fit_sun_map(input, casters);
    EXPECT_FALSE(fit.empty);
    expect_sound(fit);
}

TEST(SunMapFit, RefusesNonFiniteInput) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    FitInput input = street({0, 0, -1}, {0.3f, 1.0f, 0.2f});
    for (const glm::vec3 sun : {glm::vec3{nan, 1, 0}, glm::vec3{infinity, 0, 0}, glm::vec3{0.0f}}) {
        input.direction_to_sun = sun;
        const SunFit fit = fit_sun_map(input, walls());
        EXPECT_TRUE(fit.empty);
        expect_sound(fit);
    }
    input = street({0, 0, -1}, {0.3f, 1.0f, 0.2f});
    input.receivers.max.x = nan;
    expect_sound(fit_sun_map(input, walls()));
    input.receivers.max.x = infinity;
    expect_sound(fit_sun_map(input, walls()));
    systems::CasterColumns broken = walls();
    broken.centre_x[0] = nan;
    broken.half_y[1] = infinity;
    expect_sound(fit_sun_map(street({0, 0, -1}, {0.3f, 1.0f, 0.2f}), broken));
}

TEST(SunMapFit, MovesByWholeTexelsWhenTheEyeDoesNotTurn) {
    const glm::vec3 sun = glm::normalize(glm::vec3{0.42f, 0.80f, 0.36f});
    const glm::dvec3 landmark{3.0, 0.5, -20.0};  // in the world
    glm::dvec2 first_phase{0.0};
    glm::vec2 first_texel{0.0f};
    for (int step = 0; step < 60; ++step) {
        const glm::dvec3 eye{256.0 * 4000.0 + 0.013 * step, 1.7, -0.029 * step};  // 1000 km from the origin
        const glm::dvec3 cell = glm::floor(eye / 256.0);
        FitInput input{.view = view_along({0, 0, -1}),
                       .direction_to_sun = sun,
                       .distance_m = 80.0f,
                       .receivers = {},
                       .size_texels = 1024};
        input.view.eye_cell = glm::ivec3{cell};
        input.view.eye_local_m = glm::vec3{eye - cell * 256.0};
        const glm::vec3 relative{glm::dvec3{256.0 * 4000.0, 0.0, 0.0} - eye};
        input.receivers = {glm::vec3{-12, 0, -100} + relative, glm::vec3{12, 20, 100} + relative};
        systems::CasterColumns casters;
        add_caster(casters, glm::vec3{0, 8, 0} + relative, {12.0f, 10.0f, 100.0f});
        const SunFit fit = fit_sun_map(input, casters);
        ASSERT_FALSE(fit.empty);
        const glm::dvec3 place = glm::dvec3{256.0 * 4000.0, 0.0, 0.0} + landmark - eye;
        const glm::dvec2 texel = 512.0 * glm::dvec2{glm::dmat4{fit.clip_from_world} * glm::dvec4{place, 1.0}};
        const glm::dvec2 phase = texel - glm::floor(texel);
        if (step == 0 || fit.texel_m != first_texel) {
            first_phase = phase;
            first_texel = fit.texel_m;
            continue;
        }
        for (int axis = 0; axis < 2; ++axis) {
            const double change = std::fabs(phase[axis] - first_phase[axis]);
            // A hundredth of a texel: the matrix is float, and so is the eye's place in its cell.
            EXPECT_LT(std::min(change, 1.0 - change), 0.01) << "step " << step;
        }
    }
}

TEST(SunMapFit, FillsTheMapAlongAStreet) {
    // A street at 45° to the axes: axes fixed in the world would waste most of the map on its diagonal.
    FitInput input = street(glm::normalize(glm::vec3{1, 0, -1}), {0.2f, 1.0f, 0.1f});
    input.view.clip_from_view = perspective(0.05f, 0.3f);
    const SunFit fit = fit_sun_map(input, [] {
        systems::CasterColumns casters;
        add_caster(casters, {0.0f, 0.0f, 0.0f}, {100.0f, 50.0f, 100.0f});
        return casters;
    }());
    ASSERT_FALSE(fit.empty);
    EXPECT_LT(fit.texel_m.x, 0.5f * fit.texel_m.y);
}

TEST(ConvexIntersection, HoldsExactlyThePointsOfBothBodies) {
    const systems::FrameView view = view_along({0, 0, -1});
    const auto slice = render::shadow::frustum_slice(view, 50.0f);
    const auto points = render::shadow::intersect(slice, {{-100, -100, -20}, {100, 100, -10}});
    assets::Bounds found;
    for (const glm::vec3& p : points.span())
        found.expand(p);
    // The frustum at z = −20 is 20·tan(0.5) high to either side, by independent trigonometry.
    const float half_height = 20.0f * std::tan(0.5f);
    EXPECT_NEAR(found.max.y, half_height, 1e-4f);
    EXPECT_NEAR(found.min.x, -half_height * 16.0f / 9.0f, 1e-4f);
    EXPECT_NEAR(found.min.z, -20.0f, 1e-5f);
    EXPECT_NEAR(found.max.z, -10.0f, 1e-5f);
    // A box inside the frustum stays whole; one behind the eye vanishes.
    EXPECT_GE(render::shadow::intersect(slice, {{-1, -1, -12}, {1, 1, -10}}).count, 8u);
    EXPECT_EQ(render::shadow::intersect(slice, {{-1, -1, 1}, {1, 1, 2}}).count, 0u);
}

}  // namespace
