#include "game/clips.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "game/shown_bounds.h"
#include "systems/simulate/animation.h"

namespace rambla::game {
namespace {

using assets::AnimatedPath;
using assets::Interpolation;

/// A cube of a metre on a node, with a child of half its size 3 m beside it. Clips: "rise" lifts the node by
/// 2 m in a second and leaves it there, one without a name turns it, and one whose name is a number.
assets::Scene cubes() {
    assets::Scene scene;
    assets::Mesh& mesh = scene.meshes.emplace_back();
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back(glm::vec3{corner & 1, (corner >> 1) & 1, corner >> 2} - 0.5f);
        mesh.bounds.expand(mesh.positions.back());
    }
    scene.models.push_back({"cube", {{0, assets::k_none}}, {}});
    scene.nodes.resize(2);
    scene.nodes[0].model = 0;
    scene.nodes[0].children = {1};
    scene.nodes[0].local.translation_m = {5, 0, 0};
    scene.nodes[1].model = 0;
    scene.nodes[1].parent = 0;
    scene.nodes[1].local.translation_m = {3, 0, 0};
    scene.nodes[1].local.scale = {0.5f, 0.5f, 0.5f};
    scene.roots = {0};
    scene.clips.resize(3);
    scene.clips[0].name = "rise";
    scene.clips[0].duration_s = 2.0f;
    scene.clips[0].channels.push_back(
        {0, AnimatedPath::translation, Interpolation::linear, 3, {0, 1, 2}, {5, 0, 0, 5, 2, 0, 5, 2, 0}});
    scene.clips[1].duration_s = 1.0f;
    scene.clips[1].channels.push_back(
        {0, AnimatedPath::rotation, Interpolation::linear, 4, {0, 1}, {0, 0, 0, 1, 0, 1, 0, 0}});
    scene.clips[2].name = "1";
    return scene;
}

Stage stage_of(assets::Scene scene) {
    return make_stage(std::move(scene), assets::noon(), {{3, 0, -1}, {255.0f, 1.0f, 2.0f}});
}

std::string refusal(const assets::Scene& scene, const std::string& wanted) {
    try {
        (void)find_clip(scene, wanted, "cubes.glb");
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

TEST(Clips, AreFoundByNameThenByNumber) {
    const assets::Scene scene = cubes();
    EXPECT_EQ(find_clip(scene, "rise", "f"), 0u);
    EXPECT_EQ(find_clip(scene, "0", "f"), 0u);
    EXPECT_EQ(find_clip(scene, "1", "f"), 2u) << "a name, though it looks like a number";
    EXPECT_EQ(find_clip(scene, "2", "f"), 2u);
    EXPECT_EQ(clip_label(scene, 0), "rise");
    EXPECT_EQ(clip_label(scene, 1), "clip 1");
    for (const char* const wanted : {"3", "-1", "Rise", "0x0", "99999999999"}) {
        const std::string message = refusal(scene, wanted);
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
        EXPECT_NE(message.find("0 'rise'"), std::string::npos) << message;
        EXPECT_NE(message.find("cubes.glb"), std::string::npos) << message;
    }
    EXPECT_NE(refusal(assets::Scene{}, "rise").find("has no clips"), std::string::npos);
}

TEST(Clips, AreShownAtAnyTime) {
    Stage stage = stage_of(cubes());
    show_clip(stage, 0, 0.5);
    EXPECT_EQ(shown_bounds(*stage.world, *stage.scene, stage.origin).min.y, 0.5f);
    show_clip(stage, 0, 4.5);
    EXPECT_EQ(shown_bounds(*stage.world, *stage.scene, stage.origin).min.y, 0.5f) << "starts over";
}

TEST(Clips, AreFramedAsFarAsTheyGo) {
    Stage stage = stage_of(cubes());
    const assets::Bounds still = shown_bounds(*stage.world, *stage.scene, stage.origin);
    EXPECT_EQ(still.min, glm::vec3(4.5f, -0.5f, -0.5f));
    EXPECT_EQ(still.max, glm::vec3(8.25f, 0.5f, 0.5f));
    show_clip(stage, 0, 0.5);
    const assets::Bounds rising = clip_bounds(stage, 0);
    EXPECT_EQ(rising.min, still.min);
    EXPECT_EQ(rising.max.y, 2.5f);
    EXPECT_EQ(shown_bounds(*stage.world, *stage.scene, stage.origin).min.y, 0.5f)
        << "and the pose is as it was";
}

TEST(ClipPlayback, GoesWhereItIsToldToAtOnce) {
    Stage stage = stage_of(cubes());
    show_clip(stage, 0, 0.0);
    ClipPlayback playback{stage};
    EXPECT_TRUE(playback.has_clips());
    EXPECT_EQ(playback.duration_s(), 2.0);
    playback.set_speed(2.0f);
    playback.seek(0.5);
    EXPECT_EQ(playback.time_s(), 0.5);
    EXPECT_EQ(shown_bounds(*stage.world, *stage.scene, stage.origin).min.y, 0.5f) << "before any step";
    systems::step(*stage.world);
    EXPECT_NEAR(playback.time_s(), 0.5 + 2.0 * systems::k_step_s, 1e-12) << "the speed outlives the leap";
}

TEST(ClipPlayback, FlowsIntoTheClipThatIsChosen) {
    Stage stage = stage_of(cubes());
    show_clip(stage, 0, 1.0);
    ClipPlayback playback{stage};
    playback.set_speed(0.0f);
    playback.choose(1);
    EXPECT_EQ(playback.clip(), 1u);
    EXPECT_EQ(playback.time_s(), 0.0);
    EXPECT_NE(playback.caption().find("clip 1 (2 of 3)"), std::string::npos) << playback.caption();
    systems::step(*stage.world);
    const float height_m = shown_bounds(*stage.world, *stage.scene, stage.origin).min.y;
    EXPECT_GT(height_m, 0.5f) << "still almost where the first clip was";
    EXPECT_LT(height_m, 1.5f);
    for (int i = 0; i < 30; ++i)
        systems::step(*stage.world);
    EXPECT_EQ(shown_bounds(*stage.world, *stage.scene, stage.origin).min.y, -0.5f);
    EXPECT_EQ(playback.time_s(), 0.0) << "at speed 0";
}

TEST(ClipPlayback, HasNothingToPlayWithoutClips) {
    assets::Scene scene = cubes();
    scene.clips.clear();
    Stage stage = stage_of(std::move(scene));
    const ClipPlayback playback{stage};
    EXPECT_FALSE(playback.has_clips());
    EXPECT_EQ(playback.caption(), "");
}

TEST(Clips, FramesFollowEveryVertexThatDeforms) {
    assets::Scene scene = cubes();
    assets::Mesh& mesh = scene.meshes[0];
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(8, {0, 0, 4});
    scene.models[0].morph_weights = {0.5f};
    // Half of the weight on a joint far up: a vertex goes half of the way.
    mesh.joints.assign(8, {0, 1, 0, 0});
    mesh.weights.assign(8, {0.5f, 0.5f, 0, 0});
    scene.skeletons.push_back({"", {2, 3}, {glm::mat4{1.0f}, glm::mat4{1.0f}}});
    scene.nodes.resize(4);
    scene.nodes[3].local.translation_m = {0, 20, 0};
    scene.nodes[0].children.clear();
    scene.nodes[0].skeleton = 0;
    scene.roots = {0, 2, 3};
    const Stage stage = stage_of(std::move(scene));
    const assets::Bounds box = shown_bounds(*stage.world, *stage.scene, stage.origin);
    EXPECT_LT(glm::distance(box.min, glm::vec3(-0.5f, 9.5f, 1.5f)), 1e-4f);
    EXPECT_LT(glm::distance(box.max, glm::vec3(0.5f, 10.5f, 2.5f)), 1e-4f);
}

}  // namespace
}  // namespace rambla::game
