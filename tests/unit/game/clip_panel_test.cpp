#include "game/clip_panel.h"

#include <gtest/gtest.h>

#include "unit/game/panel.h"

namespace rambla::game {
namespace {

constexpr float k_width_px = 300.0f;

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

struct ClipPanel : Panel {
    Stage stage = stage_with_clips();
    ClipPlayback clips{stage};

    ClipPanel() : Panel{k_width_px, 260.0f} { draw(); }
    void draw_widgets() override { draw_clip_panel(clips); }
};

TEST_F(ClipPanel, AClickInTheListChoosesAClip) {
    EXPECT_TRUE(clicked_until(60.0f, 0.0f, [this] { return clips.clip() == 1; }));
}

TEST_F(ClipPanel, TheSlidersSetTimeAndSpeed) {
    // Sliders take two thirds of the width: this is about their middle.
    const float middle_px = 0.33f * k_width_px;
    EXPECT_TRUE(
        clicked_until(middle_px, 0.0f, [this] { return clips.time_s() > 0.7 && clips.time_s() < 1.3; }));
    EXPECT_EQ(clips.speed(), 1.0f) << "the time stands above the speed";
    EXPECT_TRUE(
        clicked_until(middle_px, 0.0f, [this] { return clips.speed() > 1.1f && clips.speed() < 1.9f; }));
}

}  // namespace
}  // namespace rambla::game
