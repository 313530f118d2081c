// Balls of haze: depth impostors, soft at their rims and where something cuts them off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/shader_harness.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::add;
using tests::Inputs;
using tests::matte;
using tests::Picture;
using tests::Random;
using tests::ShaderHarness;
using tests::Stage;

/// The integral of max(0, 1 − ρ²/r²)² along a line by the midpoint rule, over that through the middle,
/// 16r/15.
double integrated_share(glm::dvec3 centre, double radius, glm::dvec3 direction, double near, double far) {
    const double along = glm::dot(centre, direction);
    near = std::max(near, along - radius);
    far = std::min(far, along + radius);
    if (!(far > near)) return 0.0;
    constexpr int k_steps = 4000;
    const double step = (far - near) / k_steps;
    double sum = 0.0;
    for (int i = 0; i < k_steps; ++i) {
        const glm::dvec3 off = (near + (i + 0.5) * step) * direction - centre;
        const double density = std::max(0.0, 1.0 - glm::dot(off, off) / (radius * radius));
        sum += density * density * step;
    }
    return sum / (16.0 / 15.0 * radius);
}

TEST(Haze, ShareOfALineIsTheIntegralOfTheDensity) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (int i = 0; i < 4000; ++i) {
        const float radius = std::exp2(12.0f * random() - 6.0f);
        const glm::vec3 direction = random.direction();
        // Through the ball, about its rim, and past it.
        const glm::vec3 centre =
            direction * (4.0f * random() - 1.0f) * radius + random.direction() * random() * 1.2f * radius;
        float near = i % 3 == 0 ? 0.0f : 2.0f * random() * radius;
        float far = i % 4 == 0 ? 1e30f : near + 3.0f * random() * radius;
        if (i % 10 == 0) far = near;                   // nothing of it
        if (i % 11 == 0) far = near + 1e-3f * radius;  // hardly any
        add(inputs, {centre, radius}, {direction, 0}, {near, far, 0, 0});
    }
    const auto found =
        gpu.run("haze.glsl", "result.x = haze_share(a.xyz, a.w, b.xyz, Stretch(c.x, c.y));", inputs);
    double worst = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::vec4 a = inputs[4 * i], b = inputs[4 * i + 1], c = inputs[4 * i + 2];
        const double expected = integrated_share(glm::dvec3{a}, static_cast<double>(a.w), glm::dvec3{b},
                                                 static_cast<double>(c.x), static_cast<double>(c.y));
        worst = std::max(worst, std::abs(static_cast<double>(found[i].x) - expected));
    }
    // A dozen roundings of numbers up to 4, and directions that are of unit length to 1e-7.
    EXPECT_LT(worst, 5e-6);
}

TEST(Haze, ShareIsStableWhereTheFormulaBreaks) {
    ShaderHarness gpu;
    constexpr float k_inf = std::numeric_limits<float>::infinity();
    Inputs inputs;
    add(inputs, {0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1e30f, 0, 0});         // from the middle: half of it
    add(inputs, {5, 1, 0, 1}, {1, 0, 0, 0}, {0, 1e30f, 0, 0});         // along the rim
    add(inputs, {5, 0, 0, 1}, {1, 0, 0, 0}, {0, k_inf, 0, 0});         // the whole middle, to infinity
    add(inputs, {5, 0, 0, 1}, {1, 0, 0, 0}, {0, 4, 0, 0});             // ends where it begins
    add(inputs, {5, 0, 0, 1}, {1, 0, 0, 0}, {6, 1e30f, 0, 0});         // begins where it ends
    add(inputs, {5, 0, 0, 1}, {1, 0, 0, 0}, {5, 4, 0, 0});             // ends before it begins
    add(inputs, {1e6f, 0, 0, 1e-3f}, {1, 0, 0, 0}, {0, 1e30f, 0, 0});  // tiny and far
    add(inputs, {1e6f, 0, 0, 9e5f}, {1, 0, 0, 0}, {0, 1e30f, 0, 0});   // huge
    add(inputs, {-5, 0, 0, 1}, {1, 0, 0, 0}, {0, 1e30f, 0, 0});        // behind
    add(inputs, {5, 0, 0, 1}, {1, 0, 0, 0}, {4.5f, 4.5f + 1e-6f, 0, 0});
    const auto found =
        gpu.run("haze.glsl", "result.x = haze_share(a.xyz, a.w, b.xyz, Stretch(c.x, c.y));", inputs);
    EXPECT_FLOAT_EQ(found[0].x, 0.5f);
    EXPECT_EQ(found[1].x, 0.0f);
    EXPECT_FLOAT_EQ(found[2].x, 1.0f);
    EXPECT_NEAR(found[3].x, 0.0f, 1e-7f);
    EXPECT_NEAR(found[4].x, 0.0f, 1e-7f);
    EXPECT_EQ(found[5].x, 0.0f) << "never less than nothing";
    EXPECT_NEAR(found[6].x, 1.0f, 1e-6f);
    EXPECT_FLOAT_EQ(found[7].x, 1.0f);
    EXPECT_EQ(found[8].x, 0.0f);
    EXPECT_GE(found[9].x, 0.0f);
    EXPECT_LT(found[9].x, 1e-5f);
}

/// Haze of optical depth 1 before a bright card of radiance 1, or nothing, that swallows all light.
struct Smoky {
    Stage stage;

    explicit Smoky(float optical_depth = 1.0f) {
        assets::Material black = matte(glm::vec3{0.0f});
        black.optical_depth = optical_depth;
        stage.balls.push_back({.radius_m = 1.0f, .material = stage.material(black)});
        assets::Material card = matte();
        card.unlit = true;
        stage.place(
            stage.square(), stage.material(card),
            glm::translate(glm::mat4{1.0f}, {0, 0, -20}) * glm::scale(glm::mat4{1.0f}, glm::vec3{40.0f}));
        stage.frame.environment = {};
        stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
            stage.frame.environment.ground_radiance = glm::vec3{0.0f};
    }

    /// Nothing stands behind the haze any more but a sky of radiance 1.
    void show_white_sky() {
        stage.things.clear();
        stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
            stage.frame.environment.ground_radiance = glm::vec3{1.0f};
    }

    /// What a pixel's look lets through of the card or the sky, by the integral.
    double expected(std::uint32_t x, std::uint32_t y, double far = 1e30) const {
        const glm::vec2 size{stage.frame.view.size_px};
        const glm::vec2 ndc{2.0f * (static_cast<float>(x) + 0.5f) / size.x - 1.0f,
                            1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / size.y};
        const glm::mat4& p = stage.frame.view.clip_from_view;
        const glm::dmat3 to_world{glm::transpose(glm::mat3{stage.frame.view.view_from_world})};
        const glm::dvec3 plane{static_cast<double>(ndc.x / p[0][0]), static_cast<double>(ndc.y / p[1][1]),
                               -1.0};
        double through = 1.0;
        for (const Stage::Ball& ball : stage.balls) {
            const double depth = static_cast<double>(stage.scene.materials[ball.material].optical_depth);
            const glm::dvec3 centre{ball.centre_m - stage.eye};
            const bool flat = stage.frame.view.orthographic;
            const glm::dvec3 direction =
                flat ? to_world * glm::dvec3{0, 0, -1} : glm::normalize(to_world * plane);
            const glm::dvec3 origin = flat ? to_world * glm::dvec3{plane.x, plane.y, 0.0} : glm::dvec3{0.0};
            const double near = flat ? 0.05 : 0.05 * glm::length(plane);
            const double share =
                integrated_share(centre - origin, static_cast<double>(ball.radius_m), direction, near, far);
            const double left = 1.0 - static_cast<double>(ball.faded) / 255.0;
            through *= 1.0 - left * (1.0 - std::exp(-depth * share));
        }
        return through;
    }

    void expect_as_expected(const char* what) {
        const Picture picture = stage.draw();
        double worst = 0.0;
        for (std::uint32_t y = 0; y < picture.size.y; y += 3)
            for (std::uint32_t x = 0; x < picture.size.x; x += 3)
                worst =
                    std::max(worst, std::abs(static_cast<double>(picture.radiance(x, y).x) - expected(x, y)));
        // Half floats of up to 1 are 5e-4 apart.
        EXPECT_LT(worst, 7e-4) << what;
    }
};

TEST(Haze, LetsThroughWhatItsDepthSays) {
    Smoky smoky;
    smoky.stage.look({0, 0, 5}, {0, 0, 0});
    smoky.expect_as_expected("before the eye");
    EXPECT_NEAR(smoky.stage.draw().radiance(64, 64).x, std::exp(-1.0f), 2e-3f);
    smoky.stage.balls[0].centre_m = {1.7f, 0.8f, 0.5f};
    smoky.expect_as_expected("aside");
    smoky.stage.balls[0] = {{0, 0, 0}, 1.0f, smoky.stage.balls[0].material, 100};
    smoky.expect_as_expected("faded");
    smoky.stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.5f);
    smoky.expect_as_expected("orthographic");
    smoky.stage.look_flat({0, 0, 0.3f}, {0, 0, 0}, 1.5f);
    smoky.expect_as_expected("orthographic, from within");
}

TEST(Haze, IsSeenWholeFromAnywhereAlsoFromWithin) {
    Smoky smoky{4.0f};
    Stage::Ball& ball = smoky.stage.balls[0];
    smoky.stage.look({0, 0, 0}, {0, 0, -1});
    // Along the view through the eye, aside of it, and across the near plane.
    for (const float z : {-3.0f, -1.2f, -1.06f, -1.05f, -1.0f, -0.5f, 0.0f, 0.5f, 0.94f, 0.951f, 1.2f}) {
        ball.centre_m = {0, 0, z};
        smoky.expect_as_expected("ahead");
        ball.centre_m = {0.9f, -0.7f, z};
        smoky.expect_as_expected("aside");
    }
    ball = {{3, 0, -2}, 2.9f, ball.material, 0};
    smoky.expect_as_expected("large, beside the eye");
    // The plane that touches it comes nearer than the near plane where the picture ends.
    ball = {1.0505f * glm::vec3{std::sin(0.45f), 0, -std::cos(0.45f)}, 1.0f, ball.material, 0};
    smoky.expect_as_expected("almost at the eye, aside");
    ball = {{0, 0, -2}, 0.001f, ball.material, 0};
    smoky.expect_as_expected("smaller than a pixel");
    ball = {{0, 0, -900}, 890.0f, ball.material, 0};
    smoky.show_white_sky();
    smoky.expect_as_expected("huge, before the sky");
}

TEST(Haze, ChangesSmoothlyAsTheEyeGoesThroughIt) {
    Smoky smoky{4.0f};
    smoky.stage.look({0, 0, 0}, {0, 0, -1});
    float before = -1.0f;
    float largest = 0.0f;
    for (int i = 0; i <= 120; ++i) {
        smoky.stage.balls[0].centre_m = {0.2f, 0.1f, -2.0f + 0.03f * static_cast<float>(i)};
        const float now = smoky.stage.draw().radiance(70, 60).x;
        if (before >= 0.0f) largest = std::max(largest, std::abs(now - before));
        before = now;
    }
    EXPECT_NEAR(before, 1.0f, 1e-3f) << "at last it lies behind";
    // ∂/∂z of e^(−4·share): the density at the near plane, at most 15/16 per metre of share, times 4 and 0.03
    // m.
    EXPECT_LT(largest, 4.0f * 15.0f / 16.0f * 0.03f);
}

TEST(Haze, EndsSoftlyWhereSomethingCutsIt) {
    Smoky smoky{2.0f};
    // A wall through the middle of the ball: every look ends at z = 0.
    smoky.stage.things[0].world_from_local = glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f});
    smoky.stage.look({0, 0, 5}, {0, 0, 0});
    const Picture picture = smoky.stage.draw();
    for (const std::uint32_t x : {20u, 40u, 50u, 64u, 80u}) {
        const glm::vec2 size{smoky.stage.frame.view.size_px};
        const float f = smoky.stage.frame.view.clip_from_view[1][1];
        const glm::dvec2 plane{
            static_cast<double>((2.0f * (static_cast<float>(x) + 0.5f) / size.x - 1.0f) / f),
            static_cast<double>((1.0f - 2.0f * 64.5f / size.y) / f)};
        const double to_wall = 5.0 * std::sqrt(1.0 + glm::dot(plane, plane));
        EXPECT_NEAR(picture.radiance(x, 64).x, smoky.expected(x, 64, to_wall), 1e-3) << x;
    }
    EXPECT_NEAR(picture.radiance(64, 64).x, std::exp(-1.0f), 2e-3f) << "half of it";
    // Along the floor that it sinks into there is no line: the picture changes no faster there than
    // elsewhere.
    smoky.stage.things[0].world_from_local = glm::translate(glm::mat4{1.0f}, {0, -0.4f, 0}) *
                                             glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}) *
                                             glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f});
    smoky.stage.look({0, 0.6f, 4}, {0, -0.2f, 0});
    const Picture floor = smoky.stage.draw();
    float largest = 0.0f;
    for (std::uint32_t y = 75; y + 1 < 128; ++y)
        largest = std::max(largest, std::abs(floor.radiance(64, y).x - floor.radiance(64, y + 1).x));
    EXPECT_GT(largest, 0.001f);
    EXPECT_LT(largest, 0.06f) << "a hard edge would be " << 1.0f - std::exp(-2.0f);
}

TEST(Haze, HidesNothingThatStandsBeforeIt) {
    Smoky smoky{50.0f};
    smoky.stage.things[0].world_from_local =
        glm::translate(glm::mat4{1.0f}, {0, 0, 1.5f}) * glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f});
    smoky.stage.look({0, 0, 5}, {0, 0, 0});
    EXPECT_NEAR(smoky.stage.draw().radiance(64, 64).x, 1.0f, 1e-3f);
}

TEST(Haze, GlowsWithoutHidingWhatLiesBehind) {
    Smoky smoky{3.0f};
    assets::Material& glow = smoky.stage.scene.materials[smoky.stage.balls[0].material];
    glow.base_colour.w = 0.0f;
    glow.emissive = {8.0f, 4.0f, 0.0f};
    const glm::vec3 found = smoky.stage.draw().radiance(64, 64);
    const float cover = 1.0f - std::exp(-3.0f);
    EXPECT_NEAR(found.x, 1.0f + 8.0f * cover, 0.02f);
    EXPECT_NEAR(found.y, 1.0f + 4.0f * cover, 0.01f);
    EXPECT_NEAR(found.z, 1.0f, 1e-3f);
}

TEST(Haze, IsLitBySunLampsAndShadows) {
    Stage stage;
    assets::Material white = matte();
    white.optical_depth = 60.0f;
    stage.balls.push_back({.material = stage.material(white)});
    stage.frame.environment = tests::only_sun({0, 0, 1});
    const float sunlit = stage.draw().radiance(64, 64).x;
    EXPECT_NEAR(sunlit, 1.0f, 0.01f) << "like a white wall that faces the sun";
    stage.frame.environment = tests::only_sun({0, 1, 0});
    EXPECT_GT(stage.draw().radiance(64, 50).x, stage.draw().radiance(64, 78).x + 0.1f) << "lit from above";
    // A roof over it takes the sun away.
    stage.place(stage.square(), stage.material(matte()),
                glm::translate(glm::mat4{1.0f}, {0, 3, 0}) *
                    glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}) *
                    glm::scale(glm::mat4{1.0f}, glm::vec3{3.0f}));
    EXPECT_LT(stage.draw().radiance(64, 50).x, 0.01f);
    stage.frame.environment = tests::only_sun({0, 1, 0}, glm::vec3{0.0f});
    stage.frame.lights = {{.position_m = glm::vec3{0, 0, 3} - stage.eye,
                           .radius_m = 9.0f,
                           .intensity = glm::vec3{3.14159265f}}};
    const float distance = 2.0f;
    const float window = 1.0f - std::pow(distance / 9.0f, 4.0f);
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, window * window / (distance * distance), 0.01f);
}

TEST(Haze, VanishesInAWhiteFurnace) {
    // White, and as bright from everywhere: whichever way it is lit, it sends what it hides.
    Stage stage;
    assets::Material white = matte();
    white.optical_depth = 3.0f;
    stage.balls.push_back({.material = stage.material(white)});
    stage.frame.environment = {};
    stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
        stage.frame.environment.ground_radiance = glm::vec3{1.0f};
    const auto expect_nothing = [&stage](const char* what, float distance_m) {
        float worst = 0.0f;
        for (const glm::vec4& texel : stage.draw().linear)
            worst = std::max(worst, std::abs(texel.x - 1.0f));
        // Half floats about 1 are 5e-4 to 1e-3 apart, and two roundings meet.
        EXPECT_LT(worst, 1.5e-3f) << what << ' ' << distance_m;
    };
    // Far away floats place the entry to a hundredth of the ball.
    for (const float distance_m : {0.0f, 1e-8f, 1e-3f, 0.5f, 0.99f, 1.04f, 5.0f, 1e3f, 1e5f}) {
        stage.look({0, 0, distance_m}, {0, 0, -1}, 2.0f * std::atan(1.2f / std::max(distance_m, 1.2f)));
        expect_nothing("at", distance_m);
    }
    stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.2f);
    expect_nothing("orthographic", 5.0f);
}

TEST(Haze, IsLitWithoutACreaseFromWithin) {
    Stage stage;
    assets::Material white = matte();
    white.optical_depth = 0.9f;
    stage.balls.push_back({.radius_m = 0.7f, .material = stage.material(white)});
    stage.frame.environment = assets::noon();
    stage.settings.shadows.method = render::ShadowMethod::off;
    stage.place(stage.square(), stage.material(matte(glm::vec3{0.0f})),
                glm::translate(glm::mat4{1.0f}, {0, 0, -30}) * glm::scale(glm::mat4{1.0f}, glm::vec3{60.0f}));
    stage.look({0, 0, 0}, {0, 0, -1});
    for (const glm::vec3 centre :
         {glm::vec3{0, 0, -0.1f}, {0, 0, -0.05f}, {0.02f, 0.01f, -0.05f}, {0.15f, 0, 0}}) {
        stage.balls[0].centre_m = centre;
        const Picture picture = stage.draw();
        float largest = 0.0f;
        for (std::uint32_t y = 0; y + 1 < 128; ++y) {
            for (std::uint32_t x = 0; x + 1 < 128; ++x) {
                const glm::vec3 here = picture.radiance(x, y);
                const glm::vec3 beside = glm::abs(here - picture.radiance(x + 1, y));
                const glm::vec3 below = glm::abs(here - picture.radiance(x, y + 1));
                largest = std::max({largest, beside.x, beside.y, beside.z, below.x, below.y, below.z});
            }
        }
        EXPECT_GT(picture.radiance(64, 64).x, 0.02f);
        EXPECT_LT(largest, 0.03f) << centre.x << ' ' << centre.z;
    }
}

TEST(Haze, IsTheSameInEveryLightingPath) {
    Stage stage;
    stage.frame.environment = assets::noon();
    assets::Material smoke = matte(glm::vec3{0.7f});
    smoke.optical_depth = 2.0f;
    const std::uint32_t material = stage.material(smoke);
    stage.balls = {{{-0.4f, 0, -1}, 0.8f, material, 0}, {{0.3f, 0.2f, 0}, 0.7f, material, 40}};
    stage.place(stage.square(), stage.material(matte({0.6f, 0.4f, 0.3f})),
                glm::translate(glm::mat4{1.0f}, {0, 0, -0.5f}));
    stage.frame.lights = {
        {.position_m = glm::vec3{0.5f, 0.5f, 1} - stage.eye, .radius_m = 4.0f, .intensity = {2, 2, 1}}};
    stage.settings.lighting.path = render::LightingPath::fullscreen;
    const Picture reference = stage.draw();
    ASSERT_TRUE(reference.has_pass("blend"));
    for (const render::LightingPath path : {render::LightingPath::volumes, render::LightingPath::clustered,
                                            render::LightingPath::tiled, render::LightingPath::forward}) {
        stage.settings.lighting.path = path;
        const Picture picture = stage.draw();
        int worst = 0;
        for (std::size_t i = 0; i < picture.bytes.size(); ++i)
            worst = std::max(worst, std::abs(picture.bytes[i] - reference.bytes[i]));
        EXPECT_LE(worst, 1) << static_cast<int>(path);
    }
}

TEST(Haze, OfFadingThingsBeforeItIsCutByThem) {
    // A half faded wall at z = 0 through the ball: what of the ball lies behind the wall is seen through it,
    // and the ball, drawn after the wall, ends at it.
    Smoky smoky{2.0f};
    smoky.stage.things[0].world_from_local = glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f});
    smoky.stage.things[0].faded = 128;
    smoky.stage.look({0, 0, 5}, {0, 0, 0});
    const float wall = 1.0f - 128.0f / 255.0f;
    EXPECT_NEAR(smoky.stage.draw().radiance(64, 64).x, wall * std::exp(-1.0f), 2e-3f);
}

}  // namespace
