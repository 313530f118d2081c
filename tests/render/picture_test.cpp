// Sky, and what happens to the lit picture on its way to the display.
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <cmath>

#include "render/post/hud.h"
#include "render/post/picture_reference.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

/// An unlit square that fills the picture with one linear value, at an exposure.
struct Card {
    Card() {
        assets::Material m = matte();
        m.unlit = true;
        material = stage.material(m);
        stage.place(stage.square(), material, glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        stage.frame.view.size_px = {32, 32};
        stage.look({0, 0, 5}, {0, 0, 0});
    }
    Stage stage;
    std::uint32_t material = 0;
};

TEST(Sky, FillsWhatNothingCoversAndNothingElse) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte(glm::vec3{0.0f})));
    stage.frame.environment = assets::noon();
    stage.frame.environment.sun_illuminance = glm::vec3{0.0f};
    stage.look({0, 0, 5}, {0, 0.4f, 0});
    const Picture picture = stage.draw();
    const assets::Environment& e = stage.frame.environment;
    for (std::uint32_t y = 0; y < 128; y += 7) {
        for (std::uint32_t x = 0; x < 128; x += 7) {
            const glm::vec2 ndc{(static_cast<float>(x) + 0.5f) / 64.0f - 1.0f,
                                1.0f - (static_cast<float>(y) + 0.5f) / 64.0f};
            const glm::vec3 ray = glm::transpose(glm::mat3{stage.frame.view.view_from_world}) *
                                  glm::normalize(glm::vec3{ndc * std::tan(0.5f), -1.0f});
            const glm::vec3 hit = stage.eye - ray * (stage.eye.z / ray.z);
            const bool covered = std::max(std::fabs(hit.x), std::fabs(hit.y)) < 1.0f;
            const glm::vec3 found = picture.radiance(x, y);
            if (covered) {
                EXPECT_LT(found.x, 0.1f) << "black, but for its Fresnel";
            } else if (ray.y > 0.0f) {
                const glm::vec3 expected =
                    glm::mix(e.sky_horizon_radiance, e.sky_zenith_radiance, std::sqrt(ray.y));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(found[c], expected[c], 1e-3f);  // half floats
            } else {
                EXPECT_GT(found.x, 0.05f);
            }
        }
    }
}

TEST(Sky, ShowsTheSunWhereItIs) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::translate(glm::mat4{1.0f}, {0, 0, 50}));
    const glm::vec3 to_sun = glm::normalize(glm::vec3{0.1f, 0.3f, -1.0f});
    stage.frame.environment = only_sun(to_sun);
    stage.look({0, 0, 0}, {0, 0.2f, -1}, 0.5f);
    const Picture picture = stage.draw();
    const glm::vec2 expected = stage.pixel_of(1000.0f * to_sun);
    glm::vec2 sum{0.0f};
    float count = 0.0f;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            if (picture.radiance(x, y).x < 5.0f) continue;
            sum += glm::vec2{x + 0.5f, y + 0.5f};
            count += 1.0f;
        }
    }
    ASSERT_GT(count, 0.0f);
    EXPECT_LT(glm::distance(sum / count, expected), 1.0f);
}

TEST(Tonemap, ShowsWhatTheCurvesSay) {
    Card card;
    for (const float ev : {-4.0f, -1.0f, 0.0f, 2.0f}) {
        card.stage.settings.exposure.ev = ev;
        for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
            card.stage.settings.tone.curve = static_cast<render::ToneCurve>(curve);
            const Picture picture = card.stage.draw();
            double mean = 0.0;
            for (std::uint32_t i = 0; i < 32 * 32; ++i)
                mean += picture.display(i % 32, i / 32).x / 1024.0;
            const double expected =
                render::tone_mapped(glm::dvec3{std::exp2(ev)}, card.stage.settings.tone.curve,
                                    render::ToneOn::channels, 3.0)
                    .x;
            // Dither keeps the mean over 1024 pixels within 0.1 of a step; the encoding's own error is 0.012.
            EXPECT_NEAR(mean, 255.0 * render::srgb_encoded(expected), 0.15)
                << render::k_tone_curves[curve] << " at " << ev << " EV";
        }
    }
}

TEST(Tonemap, ShowsTheSameOfSceneColourInFewerBits) {
    Stage stage;
    assets::Material glass = matte({0.2f, 0.3f, 0.3f});
    glass.alpha_mode = assets::AlphaMode::blend;
    glass.base_colour.w = 0.4f;
    const std::uint32_t square = stage.square();
    stage.place(square, stage.material(matte({0.5f, 0.3f, 0.2f})),
                glm::scale(glm::mat4{1.0f}, glm::vec3{3.0f}));
    stage.place(square, stage.material(glass), glm::translate(glm::mat4{1.0f}, {0.7f, 0.0f, 1.0f}));
    stage.frame.environment = assets::noon();
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 4.0f, .intensity = {1, 2, 3}}};
    stage.settings.tone.dither = false;
    for (const auto path :
         {render::LightingPath::tiled, render::LightingPath::volumes, render::LightingPath::forward}) {
        stage.settings.lighting.path = path;
        stage.settings.tone.format = render::SceneColourFormat::rgba16f;
        const Picture halves = stage.draw();
        stage.settings.tone.format = render::SceneColourFormat::r11g11b10f;
        const Picture packed = stage.draw();
        EXPECT_NE(packed.linear, halves.linear);
        for (std::uint32_t y = 0; y < 128; y += 3) {
            for (std::uint32_t x = 0; x < 128; x += 3) {
                const glm::vec3 expected = halves.radiance(x, y), found = packed.radiance(x, y);
                // Six bits of red and green, five of blue; sun, lamp, sky and glass each round once, cut off.
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[c], expected[c], 4.0f / (c == 2 ? 32.0f : 64.0f) * expected[c])
                        << x << " " << y;
            }
        }
    }
}

TEST(Tonemap, ShowsASunlitWhiteNearWhite) {
    Stage stage;
    stage.place(
        stage.square(), stage.material(matte(glm::vec3{0.9f})),
        glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}) * glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = assets::noon();
    stage.look({0, 3, 3}, {0, 0, 0});
    const glm::ivec3 white = stage.draw().display(64, 64);
    EXPECT_GT(white.y, 0.80 * 255);
    EXPECT_LT(white.y, 0.95 * 255);
}

TEST(Tonemap, SurvivesOverflow) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = only_sun({0, 0, 1}, glm::vec3{1e9f});
    stage.frame.lights.assign(
        3, {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 10.0f, .intensity = glm::vec3{1e9f}});
    stage.settings.exposure.ev = 16.0f;
    const Picture picture = stage.draw();
    EXPECT_EQ(picture.display(64, 64), glm::ivec3{255});
}

TEST(Picture, IsTheSameTwentyTimes) {
    Stage stage;
    assets::Material glass = matte({0.2f, 0.3f, 0.3f});
    glass.alpha_mode = assets::AlphaMode::blend;
    glass.base_colour.w = 0.4f;
    const std::uint32_t square = stage.square();
    stage.place(
        square, stage.material(matte(glm::vec3{0.5f})),
        glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}) * glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.place(square, stage.material(matte({0.9f, 0.2f, 0.1f})),
                glm::translate(glm::mat4{1.0f}, {0, 1, 0}));
    stage.place(square, stage.material(glass), glm::translate(glm::mat4{1.0f}, {0.7f, 1, 1}));
    stage.frame.environment = assets::noon();
    stage.look({1, 2, 5}, {0, 1, 0});
    stage.frame.lights.assign(
        3, {.position_m = glm::vec3{1, 1, 1} - stage.eye, .radius_m = 4.0f, .intensity = {1, 2, 3}});
    const Picture first = stage.draw();
    for (int i = 1; i < 20; ++i)
        ASSERT_EQ(stage.draw().bytes, first.bytes) << "picture " << i;
}

TEST(Picture, TakesOddSizes) {
    for (const glm::uvec2 size : {glm::uvec2{1, 1}, {3, 131}, {97, 2}}) {
        Stage stage;
        stage.frame.view.size_px = size;
        stage.look({0, 0, 5}, {0, 0, 0});
        stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        stage.frame.environment = assets::noon();
        stage.frame.lights = {{.position_m = {0, 0, -3}, .radius_m = 6.0f, .intensity = glm::vec3{1.0f}}};
        EXPECT_EQ(stage.draw().size, size);
    }
}

TEST(Hud, IsDrawnOverThePictureWhereItWasPut) {
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {128, 128};
    ImGui::GetIO().Fonts->Build();
    ImGui::NewFrame();
    ImGui::GetForegroundDrawList()->AddRectFilled({16, 8}, {48, 24}, IM_COL32(255, 128, 0, 255));
    ImGui::GetForegroundDrawList()->PushClipRect({64, 64}, {96, 96});
    ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {128, 128}, IM_COL32(0, 0, 255, 255));
    ImGui::GetForegroundDrawList()->PopClipRect();
    ImGui::Render();
    Stage stage;
    stage.place(stage.square(), stage.material(matte()));
    EXPECT_FALSE(stage.draw().has_pass("hud"));
    stage.frame.hud = render::clone_hud(*ImGui::GetDrawData());
    ImGui::DestroyContext(context);  // the copy needs it no more
    const Picture picture = stage.draw();
    ASSERT_TRUE(picture.has_pass("hud"));
    EXPECT_EQ(picture.display(30, 16), (glm::ivec3{255, 128, 0}));
    EXPECT_EQ(picture.display(80, 80), (glm::ivec3{0, 0, 255}));
    EXPECT_NE(picture.display(60, 80), (glm::ivec3{0, 0, 255})) << "clipped";
    EXPECT_NE(picture.display(30, 30), (glm::ivec3{255, 128, 0}));
}

}  // namespace
