// Lamps on surfaces: numbers in pictures against the formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "render/reference.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::rough_dielectric;
using tests::Stage;

TEST(PointLight, FallsOffWithTheSquareInsideItsWindow) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const float radius = 4.0f;
    const double aside =
        std::sqrt(2.0) * 5.0 * std::tan(0.5) / 128.0;  // the pixel's centre, from below the light
    for (const float height : {0.5f, 1.0f, 2.0f, 3.5f}) {
        stage.frame.lights = {{.position_m = glm::vec3{0, 0, height} - stage.eye,
                               .radius_m = radius,
                               .intensity = glm::vec3{2.0f}}};
        const Picture picture = stage.draw();
        const double distance = std::hypot(height, aside);
        const double window = std::pow(1.0 - std::pow(distance / radius, 4.0), 2.0);
        const double expected =
            2.0 * window / (distance * distance) * rough_dielectric(1.0, height / distance, 1.0, 1.0);
        EXPECT_NEAR(picture.radiance(64, 64).x, expected, expected * 1.5e-3)
            << "height " << height;  // half floats
    }
}

TEST(PointLight, EndsAtItsRadiusAndCostsNothingWhenAbsent) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    EXPECT_FALSE(stage.draw().has_pass("light tiles"));
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 1.5f, .intensity = glm::vec3{50.0f}}};
    const Picture picture = stage.draw();
    EXPECT_TRUE(picture.has_pass("light tiles"));
    const float rim = std::sqrt(1.5f * 1.5f - 1.0f);  // of the lit circle on the plane
    int lit_beyond = 0, lit_within = 0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            const glm::vec2 plane = (glm::vec2{x + 0.5f, y + 0.5f} / 64.0f - 1.0f) * 5.0f * std::tan(0.5f);
            if (picture.radiance(x, y).x <= 0.0f) continue;
            (glm::length(plane) > rim ? lit_beyond : lit_within) += 1;
        }
    }
    EXPECT_EQ(lit_beyond, 0);
    // The circle's area in pixels, less a rim where the window's light is below a half float's smallest step.
    const float pixels = 3.14159f * std::pow(rim / (5.0f * std::tan(0.5f)) * 64.0f, 2.0f);
    EXPECT_GT(static_cast<float>(lit_within), 0.95f * pixels) << "the light's rectangle cuts it off";
    stage.frame.lights[0].position_m = glm::vec3{0, 0, 50} - stage.eye;  // behind the eye
    EXPECT_FALSE(stage.draw().has_pass("light tiles"));
}

TEST(PointLight, LightsFromAroundTheEyeAndManyOverlap) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.lights = {{.position_m = {0, 0, 0}, .radius_m = 20.0f, .intensity = glm::vec3{10.0f}}};
    const float one = stage.draw().radiance(64, 64).x;
    EXPECT_GT(one, 0.1f);
    stage.frame.lights.assign(8, stage.frame.lights[0]);
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, 8.0f * one,
                8.0f * one * 4e-3f);  // eight roundings to half floats
}

TEST(PointLight, KeepsItsColourWhenOthersLieOutsideTheView) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const auto light = [&](glm::vec3 position, glm::vec3 intensity) {
        return systems::FrameLight{
            .position_m = position - stage.eye, .radius_m = 2.0f, .intensity = intensity};
    };
    stage.frame.lights = {light({0, 0, 30}, {5, 5, 5}), light({-1.5f, 0, 1}, {1, 0, 0}),
                          light({1.5f, 0, 1}, {0, 0, 1})};
    const Picture picture = stage.draw();
    const auto at = [&](float x) {
        return picture.radiance(static_cast<std::uint32_t>(stage.pixel_of({x, 0, 0}).x), 64);
    };
    EXPECT_GT(at(-1.5f).x, 0.2f);
    EXPECT_EQ(at(-1.5f).z, 0.0f);
    EXPECT_GT(at(1.5f).z, 0.2f);
    EXPECT_EQ(at(1.5f).x, 0.0f);
}

TEST(SpotLight, HasAConeWithASmoothEdge) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const float inner = 0.2f, outer = 0.4f;
    stage.frame.lights = {{.position_m = glm::vec3{0, 0, 3} - stage.eye,
                           .radius_m = 50.0f,
                           .intensity = glm::vec3{20.0f},
                           .cos_outer = std::cos(outer),
                           .direction = {0, 0, -1},
                           .cos_inner = std::cos(inner)}};
    const Picture spot = stage.draw();
    stage.frame.lights[0].cos_outer = -2.0f;
    stage.frame.lights[0].cos_inner = -1.0f;
    const Picture point = stage.draw();
    const auto share = [&](float angle) {
        const glm::vec2 p = stage.pixel_of({3.0f * std::tan(angle), 0.0f, 0.0f});
        const auto x = static_cast<std::uint32_t>(p.x), y = static_cast<std::uint32_t>(p.y);
        return spot.radiance(x, y).x / point.radiance(x, y).x;
    };
    EXPECT_NEAR(share(0.1f), 1.0f, 2e-3f);
    EXPECT_EQ(share(0.45f), 0.0f);
    const float ramp = (std::cos(0.3f) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(share(0.3f), ramp * ramp, 0.06f);  // a pixel is 0.014 rad wide, a fourteenth of the ramp
}

}  // namespace
