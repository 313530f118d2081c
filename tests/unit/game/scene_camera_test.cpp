#include "game/scene_camera.h"

#include <gtest/gtest.h>

#include "game/clips.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

/// A camera turned by 90° about Y, so that it looks along −X, one metre above a node at (10, 0, 0) of scale
/// 2. The clip "drive" moves that node by 6 m along Z within a second.
assets::Scene scene_with_camera() {
    assets::Scene scene;
    scene.cameras.push_back({.name = "a", .vertical_fov_rad = 0.5f, .near_m = 0.25f});
    scene.nodes.resize(2);
    scene.nodes[0].local.translation_m = {10.0f, 0.0f, 0.0f};
    scene.nodes[0].local.scale = glm::vec3{2.0f};
    scene.nodes[0].children = {1};
    scene.nodes[1].parent = 0;
    scene.nodes[1].local.translation_m = {0.0f, 1.0f, 0.0f};
    scene.nodes[1].local.rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3{0.0f, 1.0f, 0.0f});
    scene.nodes[1].camera = 0;
    scene.roots = {0};
    scene.clips.resize(1);
    scene.clips[0].name = "drive";
    scene.clips[0].duration_s = 1.0f;
    scene.clips[0].channels.push_back({0,
                                       assets::AnimatedPath::translation,
                                       assets::Interpolation::linear,
                                       3,
                                       {0, 1},
                                       {10, 0, 0, 10, 0, 6}});
    return scene;
}

Stage stage_of(assets::Scene scene) {
    return make_stage(std::move(scene), assets::noon(), {{3, 0, -1}, {255.0f, 1.0f, 2.0f}});
}

glm::vec3 place_of(const systems::Eye& eye, const Stage& stage) {
    return systems::offset_m(stage.origin, eye.place);
}

TEST(SceneCamera, IsFoundByItsNumberAmongWhatIsShown) {
    assets::Scene scene = scene_with_camera();
    EXPECT_EQ(find_camera(scene, 0), 1u);
    EXPECT_FALSE(find_camera(scene, 1).has_value());
    scene.roots.clear();
    EXPECT_FALSE(find_camera(scene, 0).has_value());
}

TEST(SceneCamera, StandsAndLooksAsItsNodeDoes) {
    const Stage stage = stage_of(scene_with_camera());
    const systems::Eye eye = camera_eye(stage, 1, 1.0f);
    const glm::vec3 ahead = eye.rotation * glm::vec3{0.0f, 0.0f, -1.0f};
    // A coordinate up to 270 m has steps of 3e-5 m.
    EXPECT_LT(glm::distance(place_of(eye, stage), glm::vec3{10.0f, 2.0f, 0.0f}), 1e-4f);
    EXPECT_LT(glm::distance(ahead, glm::vec3{-1.0f, 0.0f, 0.0f}), 1e-5f);
    EXPECT_EQ(eye.vertical_fov_rad, 0.5f);
    EXPECT_EQ(eye.near_m, 0.25f);
}

TEST(SceneCamera, MovesAsTheClipSays) {
    Stage stage = stage_of(scene_with_camera());
    show_clip(stage, 0, 0.5);
    EXPECT_LT(glm::distance(place_of(camera_eye(stage, 1, 1.0f), stage), glm::vec3{10.0f, 2.0f, 3.0f}),
              1e-4f);
    systems::step(*stage.world);
    // A step of 1/60 s is 0.1 m of the way, and half of it lies between the two steps.
    EXPECT_NEAR(place_of(camera_eye(stage, 1, 1.0f), stage).z, 3.1f, 1e-4f);
    EXPECT_NEAR(place_of(camera_eye(stage, 1, 0.5f), stage).z, 3.05f, 1e-4f);
}

TEST(SceneCamera, WithoutExtentStillLooksSomewhere) {
    assets::Scene scene = scene_with_camera();
    scene.nodes[0].local.scale = glm::vec3{0.0f};
    const systems::Eye eye = camera_eye(stage_of(std::move(scene)), 1, 1.0f);
    EXPECT_EQ(eye.rotation, (glm::quat{1.0f, 0.0f, 0.0f, 0.0f}));
}

}  // namespace
}  // namespace rambla::game
