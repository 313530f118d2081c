#include "support/scene_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/sample_scenes.h"

namespace rambla::assets::test {
namespace {

TEST(SceneCheck, SoundScenesHaveNoProblem) {
    EXPECT_EQ(problem_of(standing_scene()), "");
    EXPECT_EQ(problem_of(moving_scene()), "");
    EXPECT_EQ(problem_of({}), "");
}

TEST(SceneCheck, EachDamageIsSeen) {
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::function<void(Scene&)>> damages{
        [](Scene& s) { s.meshes[0].indices[2] = 4; },
        [](Scene& s) { s.meshes[0].normals.pop_back(); },
        [](Scene& s) { s.meshes[0].morphs[1].positions.pop_back(); },
        [](Scene& s) { s.meshes[0].positions[1].y = k_nan; },
        [](Scene& s) { s.meshes[0].normals[1] *= 1.01f; },
        [](Scene& s) { s.meshes[0].tangents[1].w = 0.5f; },
        [](Scene& s) { s.meshes[0].weights[1].x = 0.6f; },
        [](Scene& s) {
            s.meshes[0].weights[0] = {0.25f, 0.75f, 0, 0};
        },
        [](Scene& s) { s.nodes[0].model = 3; },
        [](Scene& s) { s.nodes[0].camera = 0; },
        [](Scene& s) { s.nodes[0].light = 0; },
        [](Scene& s) { s.nodes[0].skeleton = 1; },
        [](Scene& s) { s.nodes[1].children = {0}; },
        [](Scene& s) { s.nodes[1].parent = 9; },
        [](Scene& s) { s.nodes[3].coarser = {9}; },
        [](Scene& s) { s.nodes[3].local.scale.x = k_nan; },
        [](Scene& s) { s.nodes[3].local.rotation.x = 0.5f; },
        [](Scene& s) { s.clips[0].channels[0].node = 9; },
        [](Scene& s) { s.clips[0].channels[0].values.pop_back(); },
        [](Scene& s) { s.clips[0].channels[0].values[1] = k_nan; },
        [](Scene& s) { s.clips[0].channels[0].times_s[1] = 0.0f; },
        [](Scene& s) { s.clips[0].duration_s = 1.0f; },
        [](Scene& s) {
            s.clips[0].channels[0].times_s.clear();
            s.clips[0].channels[0].values.clear();
        },
        [](Scene& s) { s.models[0].parts[0].mesh = 3; },
        [](Scene& s) { s.models[0].parts[0].material = 1; },
        [](Scene& s) { s.materials[0].normal_texture.texture = 0; },
        [](Scene& s) { s.materials[0].normal_texture.uv_set = 2; },
        [](Scene& s) { s.textures.resize(1); },
        [](Scene& s) { s.images = {{.name = "torn", .width = 1, .height = 1, .texels = {}}}; },
        [](Scene& s) { s.skeletons[0].joint_from_mesh.pop_back(); },
        [](Scene& s) { s.skeletons[0].joints[0] = 9; },
        [](Scene& s) {
            s.roots = {9};
        }};
    for (std::size_t i = 0; i < damages.size(); ++i) {
        Scene scene = moving_scene();
        damages[i](scene);
        EXPECT_NE(problem_of(scene), "") << "damage " << i;
    }
}

}  // namespace
}  // namespace rambla::assets::test
