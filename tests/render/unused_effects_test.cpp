// What a frame does not call for costs no GL call and no memory.
#include <gtest/gtest.h>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::Stage;

/// Frames after which the graph's pool has let go of what nobody asked for since.
constexpr int k_settling_frames = 40;

struct Held {
    std::uint64_t calls = 0;
    std::uint64_t bytes = 0;
    bool operator==(const Held&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Held& held) {
    return out << held.calls << " calls, " << held.bytes << " bytes";
}

Held settled(Stage& stage) {
    Held held;
    for (int i = 0; i < k_settling_frames; ++i) {
        const systems::Feedback feedback = stage.redraw();
        held = {feedback.gl_calls, feedback.gpu_memory_bytes};
    }
    return held;
}

TEST(UnusedEffects, LeaveTheFrameAsItWasToTheCallAndTheByte) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = tests::only_sun({0, 0, 1});
    static_cast<void>(stage.draw());
    const Held plain = settled(stage);
    ASSERT_GT(plain.calls, 50u);

    const auto changes_and_comes_back = [&](const char* what, auto&& add, auto&& remove) {
        add();
        const Held with = settled(stage);
        EXPECT_NE(with.calls, plain.calls) << what;
        remove();
        EXPECT_EQ(settled(stage), plain) << what;
    };
    render::Settings& settings = stage.settings;
    const systems::FrameLight lamp{
        .position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 1.5f, .intensity = glm::vec3{5.0f}};
    for (const auto path : {render::LightingPath::tiled, render::LightingPath::volumes,
                            render::LightingPath::clustered, render::LightingPath::forward}) {
        changes_and_comes_back(
            render::k_lighting_paths[static_cast<std::size_t>(path)].data(),
            [&] {
                stage.frame.lights = {lamp};
                settings.lighting.path = path;
            },
            [&] {
                stage.frame.lights.clear();
                settings.lighting.path = render::LightingPath::tiled;
            });
    }
    changes_and_comes_back(
        "solid volumes",
        [&] {
            stage.frame.lights = {lamp};
            settings.lighting = {.path = render::LightingPath::volumes, .volume = render::LightVolume::solid};
        },
        [&] {
            stage.frame.lights.clear();
            settings.lighting = {};
        });
    changes_and_comes_back(
        "pre-pass", [&] { settings.lighting.prepass = true; }, [&] { settings.lighting.prepass = false; });
    changes_and_comes_back(
        "haze", [&] { stage.balls = {{.material = 0}}; }, [&] { stage.balls.clear(); });
    changes_and_comes_back(
        "fading", [&] { stage.things[0].faded = 100; }, [&] { stage.things[0].faded = 0; });
    changes_and_comes_back(
        "no shadows", [&] { settings.shadows.method = render::ShadowMethod::off; },
        [&] { settings.shadows.method = render::ShadowMethod::focused; });
    changes_and_comes_back(
        "no anti-aliasing", [&] { settings.anti_aliasing.method = render::AntiAliasing::none; },
        [&] { settings.anti_aliasing.method = render::AntiAliasing::fxaa; });
    for (const auto method : {render::LuminanceMethod::chain, render::LuminanceMethod::compute,
                              render::LuminanceMethod::mips, render::LuminanceMethod::mips16}) {
        changes_and_comes_back(
            render::k_luminance_methods[static_cast<std::size_t>(method)].data(),
            [&] {
                settings.exposure.mode = render::ExposureMode::automatic;
                settings.exposure.luminance = method;
            },
            [&] { settings.exposure.mode = render::ExposureMode::fixed; });
    }
    changes_and_comes_back(
        "estimated curve", [&] { settings.tone = {.curve = render::ToneCurve::extended, .estimate = true}; },
        [&] { settings.tone = {}; });
    changes_and_comes_back(
        "supersampling",
        [&] {
            settings.anti_aliasing.method = render::AntiAliasing::ssaa;
            stage.frame.view.samples = 2;
            stage.frame.view.size_px *= 2u;
        },
        [&] {
            settings.anti_aliasing.method = render::AntiAliasing::fxaa;
            stage.frame.view.samples = 1;
            stage.frame.view.size_px /= 2u;
        });
    changes_and_comes_back(
        "temporal anti-aliasing", [&] { settings.anti_aliasing.method = render::AntiAliasing::taa; },
        [&] { settings.anti_aliasing.method = render::AntiAliasing::fxaa; });
    for (const auto method : {render::BloomMethod::pyramid, render::BloomMethod::iterated}) {
        changes_and_comes_back(
            render::k_bloom_methods[static_cast<std::size_t>(method)].data(),
            [&] { settings.bloom.method = method; },
            [&] { settings.bloom.method = render::BloomMethod::off; });
    }
    changes_and_comes_back(
        "corona",
        [&] {
            stage.frame.lights = {lamp};
            settings.bloom.corona = true;
        },
        [&] {
            stage.frame.lights.clear();
            settings.bloom.corona = false;
        });
    changes_and_comes_back(
        "overdraw", [&] { settings.debug.view = render::DebugView::overdraw; },
        [&] { settings.debug.view = render::DebugView::off; });
}

TEST(UnusedEffects, SolidVolumesAreMadeWhenTheyAreChosen) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 1.5f, .intensity = glm::vec3{5.0f}}};
    stage.settings.lighting.path = render::LightingPath::volumes;
    static_cast<void>(stage.draw());
    const auto objects = [&] {
        static_cast<void>(settled(stage));
        return stage.redraw().gl_objects;
    };
    const std::uint32_t quads = objects();
    stage.settings.lighting.volume = render::LightVolume::solid;
    EXPECT_EQ(objects(), quads + 4) << "vertices, indices, their array, a program";
}

TEST(UnusedEffects, AutomaticExposureKeepsOneBufferAndWhatReadsItBack) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = tests::only_sun({0, 0, 1});
    static_cast<void>(stage.draw());
    const auto objects = [&] {
        static_cast<void>(settled(stage));
        return stage.redraw().gl_objects;
    };
    const std::uint32_t fixed = objects();
    stage.settings.exposure.mode = render::ExposureMode::automatic;
    // Programs: two of the chain, exposure, tone mapping. Steps of the chain from 128 pixels: four textures,
    // with a framebuffer each, of which the pool lends no other pass one. Buffers: the state, and a copy for
    // each of two frames in flight.
    EXPECT_EQ(objects(), fixed + 4 + 8 + 3);
    stage.settings.exposure.mode = render::ExposureMode::fixed;
    EXPECT_EQ(objects(), fixed + 4) << "programs stay";
}

TEST(UnusedEffects, AntiAliasingLeavesNothingInTheFramesAfterIt) {
    Stage stage;
    stage.frame.view.size_px = {32, 32};
    stage.place(stage.square(), stage.material(matte()));
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    static_cast<void>(stage.draw());
    const Held plain = settled(stage);
    for (const auto method : {render::AntiAliasing::sobel, render::AntiAliasing::edges,
                              render::AntiAliasing::fxaa, render::AntiAliasing::morphological}) {
        const char* const name = render::k_anti_aliasing_methods[static_cast<std::size_t>(method)].data();
        stage.settings.anti_aliasing.method = method;
        const Held with = settled(stage);
        EXPECT_GT(with.calls, plain.calls) << name;
        EXPECT_GT(with.bytes, plain.bytes) << name;
        stage.settings.anti_aliasing.method = render::AntiAliasing::none;
        EXPECT_EQ(settled(stage), plain) << name;
    }
}

TEST(UnusedEffects, AntiAliasingIsMadeWhenItIsChosen) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()));
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    static_cast<void>(stage.draw());
    const auto objects_without = [&] {
        stage.settings.anti_aliasing = {.method = render::AntiAliasing::none};
        static_cast<void>(settled(stage));
        return stage.redraw().gl_objects;
    };
    const auto choose = [&](const render::AntiAliasingParameters& chosen) {
        stage.settings.anti_aliasing = chosen;
        static_cast<void>(settled(stage));
    };
    const std::uint32_t none = objects_without();
    choose({.method = render::AntiAliasing::fxaa, .everywhere = true});
    EXPECT_EQ(objects_without(), none + 1) << "a program for the whole screen";
    choose({.method = render::AntiAliasing::fxaa});
    EXPECT_EQ(objects_without(), none + 3) << "one for tiles, and one that finds them";
    choose({.method = render::AntiAliasing::morphological, .everywhere = true});
    EXPECT_EQ(objects_without(), none + 5) << "one for the screen, and one that finds lines";
    choose({.method = render::AntiAliasing::fxaa, .samples = 2, .history = 0.5f});
    EXPECT_EQ(objects_without(), none + 5) << "what other methods read changes nothing";
}

TEST(UnusedEffects, ALampOutOfViewCostsNoCall) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = tests::only_sun({0, 0, 1});
    static_cast<void>(stage.draw());
    const Held plain = settled(stage);
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 50}, .radius_m = 1.5f, .intensity = glm::vec3{5.0f}}};
    EXPECT_EQ(settled(stage).calls, plain.calls);
}

}  // namespace
