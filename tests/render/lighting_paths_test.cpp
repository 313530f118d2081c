// Five ways to find the lights of a pixel, and one picture.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::Picture;
using tests::Stage;

struct Difference {
    int largest = 0;              ///< of any channel, in 1/255
    double beyond_one_pct = 0.0;  ///< pixels with a channel that differs by more than 1/255
};

Difference difference(const Picture& a, const Picture& b) {
    Difference found;
    std::size_t beyond = 0;
    for (std::size_t pixel = 0; pixel < a.bytes.size() / 4; ++pixel) {
        int largest = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            largest = std::max(
                largest, std::abs(int{a.bytes[4 * pixel + channel]} - int{b.bytes[4 * pixel + channel]}));
        found.largest = std::max(found.largest, largest);
        beyond += largest > 1 ? 1 : 0;
    }
    found.beyond_one_pct = 100.0 * static_cast<double>(beyond) / static_cast<double>(a.bytes.size() / 4);
    return found;
}

/// Pillars of several materials on a floor, under a weak sun and many lamps: points and spots, near and far,
/// before and behind the eye.
void furnish(Stage& stage) {
    stage.frame.view.size_px = {320, 200};
    stage.look({0, 3, 12}, {0, 1, 0});
    const std::uint32_t square = stage.square();
    assets::Material metal = matte({0.9f, 0.7f, 0.4f});
    metal.metalness = 1.0f;
    metal.roughness = 0.35f;
    assets::Material bumpy = matte({0.3f, 0.5f, 0.8f});
    bumpy.roughness = 0.5f;
    bumpy.normal_texture = stage.texture(
        2, 2, {{160, 128, 240, 255}, {128, 100, 240, 255}, {100, 128, 240, 255}, {128, 160, 240, 255}});
    assets::Material glowing = matte({0.2f, 0.2f, 0.2f});
    glowing.emissive = {0.3f, 0.8f, 0.1f};
    assets::Material cut = matte({0.6f, 0.2f, 0.2f});
    cut.alpha_mode = assets::AlphaMode::mask;
    cut.base_colour_texture = stage.texture(
        2, 2, {{255, 255, 255, 255}, {255, 255, 255, 0}, {255, 255, 255, 0}, {255, 255, 255, 255}});
    const std::uint32_t materials[] = {stage.material(metal), stage.material(bumpy), stage.material(glowing),
                                       stage.material(cut)};
    const glm::mat4 floor =
        glm::scale(glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}), glm::vec3{40.0f});
    stage.place(square, stage.material(matte({0.5f, 0.5f, 0.5f})), floor);
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 place{-6.0f + 2.4f * static_cast<float>(i % 6), 1.0f, i < 6 ? 0.0f : -9.0f};
        stage.place(square, materials[i % 4], glm::translate(glm::mat4{1.0f}, place));
    }
    stage.frame.environment = assets::noon();
    stage.frame.environment.sun_illuminance *= 0.1f;
    for (const glm::vec3 direction : {glm::vec3{0.6f, -0.8f, 0.0f}, glm::vec3{0.0f, -0.6f, -0.8f}})
        stage.frame.directional_lights.push_back({.intensity = {0.2f, 0.1f, 0.05f}, .direction = direction});
    std::mt19937 random{8};
    std::uniform_real_distribution<float> uniform;
    for (int i = 0; i < 80; ++i) {
        const glm::vec3 place{-12.0f + 24.0f * uniform(random), 0.2f + 3.0f * uniform(random),
                              -25.0f + 40.0f * uniform(random)};
        systems::FrameLight light{.position_m = place - stage.eye,
                                  .radius_m = 1.0f + 5.0f * uniform(random),
                                  .intensity = glm::vec3{uniform(random), uniform(random), uniform(random)}};
        if (i % 3 == 0) {
            light.direction =
                glm::normalize(glm::vec3{uniform(random) - 0.5f, -1.0f, uniform(random) - 0.5f});
            light.cos_outer = 0.6f;
            light.cos_inner = 0.8f;
        }
        stage.frame.lights.push_back(light);
    }
}

Picture drawn_by(Stage& stage, render::LightingPath path, bool prepass = false) {
    stage.settings.lighting.path = path;
    stage.settings.lighting.prepass = prepass;
    return stage.draw();
}

Picture drawn_by_volumes(Stage& stage, render::LightVolume volume, bool queries = false) {
    stage.settings.lighting = {.path = render::LightingPath::volumes, .volume = volume, .queries = queries};
    return stage.draw();
}

TEST(LightingPaths, ThatAddInOneShaderAgreeToTheBit) {
    Stage stage;
    furnish(stage);
    for (const render::Brdf brdf : {render::Brdf::ggx, render::Brdf::blinn, render::Brdf::lambert}) {
        stage.settings.brdf.model = brdf;
        const Picture all = drawn_by(stage, render::LightingPath::fullscreen);
        for (const int tile_px : {16, 64, 100}) {
            stage.settings.lighting.tile_px = tile_px;
            // A light that does not reach a pixel adds 0 there, and lists keep the frame's order.
            EXPECT_EQ(drawn_by(stage, render::LightingPath::clustered).bytes, all.bytes) << tile_px;
            EXPECT_EQ(drawn_by(stage, render::LightingPath::tiled).bytes, all.bytes) << tile_px;
        }
    }
}

TEST(LightingPaths, ThatAddInTheTargetAgree) {
    Stage stage;
    furnish(stage);
    // It decides by thresholds: a step of 1/255 may become one of many.
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const Picture all = drawn_by(stage, render::LightingPath::fullscreen);
    for (const render::LightVolume volume : {render::LightVolume::quad, render::LightVolume::solid}) {
        for (const bool queries : {false, true}) {
            const std::string way{render::k_light_volumes[static_cast<std::size_t>(volume)]};
            // A half float has 11 bits: each of the lights that overlap rounds the sum once more.
            const Difference found = difference(all, drawn_by_volumes(stage, volume, queries));
            EXPECT_LE(found.largest, 2) << way << queries;
            EXPECT_LE(found.beyond_one_pct, 0.01) << way << queries;
        }
    }
}

TEST(LightingPaths, ThatAddInTheTargetAgreeInAFlatView) {
    Stage stage;
    furnish(stage);
    stage.look_flat(stage.eye, {0, 1, 0}, 4.0f);
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const Picture all = drawn_by(stage, render::LightingPath::fullscreen);
    for (const render::LightVolume volume : {render::LightVolume::quad, render::LightVolume::solid}) {
        const Difference found = difference(all, drawn_by_volumes(stage, volume));
        EXPECT_LE(found.largest, 2) << static_cast<int>(volume);
        EXPECT_LE(found.beyond_one_pct, 0.01) << static_cast<int>(volume);
    }
}

TEST(LightingPaths, ForwardKeepsWhatTheGBufferKeeps) {
    Stage stage;
    furnish(stage);
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    for (const render::ShadowTaps taps : {render::ShadowTaps::four, render::ShadowTaps::sixteen}) {
        stage.settings.shadows.taps = taps;
        const std::string_view count = render::k_shadow_taps[static_cast<std::size_t>(taps)];
        const Picture all = drawn_by(stage, render::LightingPath::fullscreen);
        for (const bool prepass : {false, true}) {
            const Picture forward = drawn_by(stage, render::LightingPath::forward, prepass);
            const Difference found = difference(all, forward);
            EXPECT_LE(found.largest, 4) << prepass << ' ' << count;
            EXPECT_LE(found.beyond_one_pct, 0.01) << prepass << ' ' << count;
            EXPECT_FALSE(forward.has_pass("gbuffer"));
            EXPECT_EQ(forward.has_pass("depth pre-pass"), prepass);
        }
        EXPECT_EQ(drawn_by(stage, render::LightingPath::fullscreen, true).bytes, all.bytes)
            << "a pre-pass changes no deferred picture";
    }
}

TEST(LightingPaths, APrePassLeavesTheSameOneOfCoincidentSurfacesInFront) {
    Stage stage;
    assets::Material red = matte({1, 0, 0}), green = matte({0, 1, 0});
    red.unlit = green.unlit = true;
    const std::uint32_t square = stage.square();
    stage.place(square, stage.material(red));
    stage.place(square, stage.material(green));
    for (const render::LightingPath path : {render::LightingPath::tiled, render::LightingPath::forward}) {
        const Picture without = drawn_by(stage, path);
        EXPECT_EQ(drawn_by(stage, path, true).bytes, without.bytes);
        EXPECT_GT(without.radiance(64, 64).y, 0.9f) << "of equally near ones the last one drawn is seen";
    }
}

TEST(LightingPaths, ShowTheSamePictureFromAWideGBuffer) {
    Stage stage;
    furnish(stage);
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    const auto gbuffer_bytes = [](const Picture& picture) {
        for (const systems::PassTiming& pass : picture.feedback.passes) {
            if (pass.name == "gbuffer") return pass.bytes_written;
        }
        return std::uint64_t{0};
    };
    const Picture compact = drawn_by(stage, render::LightingPath::fullscreen);
    stage.settings.gbuffer.layout = render::GBufferLayout::wide;
    const Picture wide = drawn_by(stage, render::LightingPath::fullscreen);
    EXPECT_EQ(gbuffer_bytes(compact), 320u * 200u * (3 * 4 + 4 + 4)) << "emission and depth besides";
    EXPECT_EQ(gbuffer_bytes(wide), 320u * 200u * (4 * 8 + 4 + 4 + 4));
    EXPECT_NE(wide.bytes, compact.bytes);
    // Compact: half a byte's step of the albedo, 2e-5 of the normal. Wide: 2^-11 of all, which is 8 mm at 16
    // m, where lamps hang 0.2 m above the floor.
    const Difference found = difference(compact, wide);
    EXPECT_LE(found.largest, 6);
    EXPECT_LE(found.beyond_one_pct, 1.0);
    EXPECT_EQ(drawn_by(stage, render::LightingPath::clustered).bytes, wide.bytes);
    EXPECT_EQ(drawn_by(stage, render::LightingPath::tiled).bytes, wide.bytes);
    for (const render::LightVolume volume : {render::LightVolume::quad, render::LightVolume::solid})
        EXPECT_LE(difference(drawn_by_volumes(stage, volume), wide).largest, 2);
}

TEST(LightingPaths, ShowThePlaceBeyondWhatHalfFloatsHoldFromAWideGBuffer) {
    Stage stage;
    stage.frame.environment = assets::noon();
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    stage.settings.shadows.method = render::ShadowMethod::off;
    assets::Material metal = matte({0.9f, 0.7f, 0.4f});
    metal.metalness = 1.0f;
    metal.roughness = 0.3f;
    stage.place(stage.square(), stage.material(metal),
                glm::scale(glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}), glm::vec3{2e5f}));
    stage.look({0, 20'000, 0}, {0, 5'000, -40'000});
    const Picture compact = stage.draw();
    stage.settings.gbuffer.layout = render::GBufferLayout::wide;
    // All but sun and sky ends long before; their directions are off by a half float's 2^-11.
    EXPECT_LE(difference(compact, stage.draw()).largest, 3);
}

TEST(LightingPaths, EachPathLightsTheFloorByManyLamps) {
    Stage stage;
    furnish(stage);
    stage.frame.environment.sun_illuminance = glm::vec3{0.0f};
    stage.frame.environment.sky_zenith_radiance = glm::vec3{0.0f};
    stage.frame.environment.sky_horizon_radiance = glm::vec3{0.0f};
    stage.frame.environment.ground_radiance = glm::vec3{0.0f};
    for (const auto path :
         {render::LightingPath::fullscreen, render::LightingPath::volumes, render::LightingPath::clustered,
          render::LightingPath::tiled, render::LightingPath::forward}) {
        const Picture lit = drawn_by(stage, path);
        std::size_t bright = 0;
        for (const glm::vec4& texel : lit.linear)
            bright += glm::vec3{texel}.x > 0.001f ? 1 : 0;
        EXPECT_GT(bright, lit.linear.size() / 4) << static_cast<int>(path);
    }
}

TEST(LightingPaths, ATileWithoutLampsIsOfAnotherClassAndStillLit) {
    Stage stage;
    stage.frame.view.size_px = {256, 64};
    stage.look({0, 0, 5}, {0, 0, 0});
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{40.0f}));
    stage.frame.environment = tests::only_sun({0, 0, 1});
    const Picture without = stage.draw();
    EXPECT_FALSE(without.has_pass("light tiles"));
    stage.frame.lights = {
        {.position_m = glm::vec3{-6.0f, 0, 1} - stage.eye, .radius_m = 1.5f, .intensity = glm::vec3{5.0f}}};
    const Picture with = stage.draw();
    EXPECT_TRUE(with.has_pass("light tiles"));
    int changed_left = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            const bool changed = with.radiance(x, y) != without.radiance(x, y);
            if (x >= 128) {
                ASSERT_FALSE(changed) << x << " " << y;
            }
            changed_left += changed ? 1 : 0;
        }
    }
    EXPECT_GT(changed_left, 100);
}

}  // namespace
