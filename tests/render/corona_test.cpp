// Rays and a halo about lamps that are seen.
#include <gtest/gtest.h>

#include "render/shader_harness.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::Picture;
using tests::Stage;

/// A lamp in the dark, far enough that its corona lies within the picture; 20 pixels make a degree.
struct Night {
    Night() {
        stage.frame.view.size_px = {256, 256};
        stage.look({0, 0, 0}, {0, 0, -1}, glm::radians(12.8f));
        stage.place(
            stage.square(), stage.material(tests::matte(glm::vec3{0.0f})),
            glm::translate(glm::mat4{1.0f}, {0, 0, -50}) * glm::scale(glm::mat4{1.0f}, glm::vec3{50.0f}));
        stage.frame.environment = tests::only_sun({0, 0, 1}, glm::vec3{0.0f});
        stage.frame.lights = {{.position_m = {0, 0, -20}, .radius_m = 5.0f, .intensity = glm::vec3{800.0f}}};
        stage.settings.bloom.corona = true;
        stage.settings.anti_aliasing.method = render::AntiAliasing::none;
        stage.settings.tone.dither = false;
    }
    Stage stage;
};

/// Mean over a circle about the picture's middle.
glm::dvec3 ring(const Picture& picture, double radius_px) {
    constexpr int k_places = 720;
    glm::dvec3 sum{0.0};
    for (int i = 0; i < k_places; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / k_places;
        sum += glm::dvec3{picture.display(static_cast<std::uint32_t>(128.0 + radius_px * std::cos(angle)),
                                          static_cast<std::uint32_t>(128.0 + radius_px * std::sin(angle)))};
    }
    return sum / static_cast<double>(k_places);
}

TEST(Corona, SurroundsALampThatIsSeen) {
    Night night;
    const Picture with = night.stage.draw();
    ASSERT_TRUE(with.has_pass("corona"));
    night.stage.settings.bloom.corona = false;
    const Picture without = night.stage.draw();
    EXPECT_FALSE(without.has_pass("corona"));
    const glm::dvec3 near_lamp = ring(with, 14.0) - ring(without, 14.0);
    const glm::dvec3 farther = ring(with, 30.0) - ring(without, 30.0);
    EXPECT_GT(near_lamp.y, 20.0);
    EXPECT_GT(near_lamp.y, farther.y + 5.0);
    EXPECT_GT(farther.y, 1.0);
    for (const std::uint32_t corner : {0u, 255u})
        EXPECT_EQ(with.display(corner, corner), without.display(corner, corner)) << "it ends";
}

TEST(Corona, RestsWhereTemporalAntiAliasingShiftsThePictureThatIsDrawn) {
    Night night;
    night.stage.settings.anti_aliasing.method = render::AntiAliasing::taa;
    static_cast<void>(night.stage.draw());
    Picture before = night.stage.draw_next();
    constexpr int k_jitters = 8;
    for (int i = 0; i < k_jitters; ++i) {
        const Picture picture = night.stage.draw_next();
        ASSERT_TRUE(picture.has_pass("corona"));
        EXPECT_EQ(picture.bytes, before.bytes) << "nothing but the corona is seen, and nothing moves";
        before = picture;
    }
}

TEST(Corona, HasAHaloThatIsRedOutsideAndBlueInside) {
    Night night;
    const Picture with = night.stage.draw();
    // 3·λ/568 degrees: 2.45 for blue, 3.23 for red, 20 pixels each.
    const glm::dvec3 inside = ring(with, 49.0), outside = ring(with, 64.5);
    EXPECT_GT(inside.z - inside.x, 3.0);
    EXPECT_GT(outside.x - outside.z, 3.0);
}

TEST(Corona, IsHiddenAsFarAsItsLampIs) {
    Night night;
    const double whole = ring(night.stage.draw(), 14.0).y;
    const std::uint32_t wall = night.stage.material(tests::matte(glm::vec3{0.0f}));
    // One metre before the lamp, with its edge through the lamp's middle, and then over all of it.
    const auto place_wall = [&](float x) {
        night.stage.things.resize(1);
        night.stage.place(0, wall, glm::translate(glm::mat4{1.0f}, {x - 1.0f, 0, -19}));
        return ring(night.stage.draw(), 14.0).y;
    };
    const double half = place_wall(0.0f), none = place_wall(0.5f);
    EXPECT_LT(half, 0.95 * whole) << "bytes of bright light";
    EXPECT_GT(half, 0.2 * whole);
    EXPECT_LT(none, 1.0);
    EXPECT_NEAR(place_wall(-0.5f), whole, 0.01 * whole) << "beside it";
}

TEST(Corona, OfALampsOwnGlassIsNotHidden) {
    Night night;
    const double whole = ring(night.stage.draw(), 14.0).y;
    night.stage.place(
        0, 0,
        glm::translate(glm::mat4{1.0f}, {0, 0, -19.85f}) * glm::scale(glm::mat4{1.0f}, glm::vec3{0.15f}));
    EXPECT_NEAR(ring(night.stage.draw(), 14.0).y, whole, 0.01 * whole);
}

TEST(Corona, IsNoneOfLampsBehindTheEyeOrThatShineElsewhere) {
    Night night;
    night.stage.settings.bloom.corona = false;
    const std::vector<std::uint8_t> without = night.stage.draw().bytes;
    night.stage.settings.bloom.corona = true;
    for (const systems::FrameLight& light :
         {systems::FrameLight{.position_m = {0, 0, 20}, .radius_m = 5.0f, .intensity = glm::vec3{4000.0f}},
          systems::FrameLight{.position_m = {0, 0, 0}, .radius_m = 5.0f, .intensity = glm::vec3{4000.0f}},
          systems::FrameLight{.position_m = {0, 0, -20},
          .radius_m = 5.0f,
          .intensity = glm::vec3{4000.0f},
          .cos_outer = 0.5f,
          .direction = {0, 0, -1},
          .cos_inner = 0.6f}}) {
        night.stage.frame.lights = {light};
        EXPECT_EQ(night.stage.draw().bytes, without) << light.position_m.z;
    }
}

TEST(Corona, NeedlesAreOneOnAverageOverAllDirections) {
    tests::ShaderHarness gpu;
    tests::Inputs inputs;
    constexpr int k_turns = 4400;
    for (int i = 0; i < k_turns; ++i)
        tests::add(inputs, {(i + 0.5f) / k_turns, 0, 0, 0});
    double sum = 0.0;
    for (const glm::vec4& found : gpu.run("corona.glsl", "result.x = corona_rays(a.x);", inputs)) {
        EXPECT_GE(found.x, 0.0f);
        sum += found.x;
    }
    EXPECT_NEAR(sum / k_turns, 1.0, 0.2) << "44 lengths are a small sample";
}

}  // namespace
