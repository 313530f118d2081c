#include "game/clip_panel.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace rambla::game {
namespace {

constexpr float k_width_px = 300.0f;
constexpr float k_height_px = 260.0f;

/// A stage with an empty node that two clips of two seconds move; the names of both mean something to Dear
/// ImGui.
Stage stage_with_clips() {
    assets::Scene scene;
    scene.nodes.resize(1);
    scene.roots = {0};
    scene.clips.resize(2);
    for (assets::Clip& clip : scene.clips) {
        clip.name = "same##name%s";
        clip.duration_s = 2.0f;
        clip.channels.push_back({0,
                                 assets::AnimatedPath::translation,
                                 assets::Interpolation::linear,
                                 3,
                                 {0, 2},
                                 {0, 0, 0, 1, 0, 0}});
    }
    Stage stage = make_stage(std::move(scene), assets::noon(), {});
    show_clip(stage, 0, 0.0);
    return stage;
}

/// The panel in a window of its own, and a mouse.
struct ClipPanel : testing::Test {
    Stage stage = stage_with_clips();
    ClipPlayback clips{stage};
    ImGuiContext* context = ImGui::CreateContext();

    ClipPanel() {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {k_width_px, k_height_px};
        io.Fonts->Build();
        draw();
    }
    ~ClipPanel() override { ImGui::DestroyContext(context); }

    void draw() {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({k_width_px, k_height_px});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
        draw_clip_panel(clips);
        ImGui::End();
        ImGui::Render();
    }
    void click(float x_px, float y_px) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {x_px, y_px};
        draw();
        io.MouseDown[0] = true;
        draw();
        io.MouseDown[0] = false;
        draw();
    }
    /// Clicks at one distance from the left, further and further down, until something has come true. The
    /// topmost line is the heading, which would fold the panel.
    template <class Fact>
    bool clicked_until(float x_px, const Fact& fact) {
        for (float y_px = 30.0f; y_px < k_height_px; y_px += 4.0f) {
            click(x_px, y_px);
            if (fact()) return true;
        }
        return false;
    }
};

TEST_F(ClipPanel, AClickInTheListChoosesAClip) {
    EXPECT_TRUE(clicked_until(60.0f, [this] { return clips.clip() == 1; }));
}

TEST_F(ClipPanel, TheSlidersSetTimeAndSpeed) {
    // Sliders take two thirds of the width: this is about their middle.
    const float middle_px = 0.33f * k_width_px;
    EXPECT_TRUE(clicked_until(middle_px, [this] { return clips.time_s() > 0.7 && clips.time_s() < 1.3; }));
    EXPECT_EQ(clips.speed(), 1.0f) << "the time stands above the speed";
    EXPECT_TRUE(clicked_until(middle_px, [this] { return clips.speed() > 1.1f && clips.speed() < 1.9f; }));
}

}  // namespace
}  // namespace rambla::game
