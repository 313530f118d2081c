#include "unit/systems/animated_scenes.h"

#include <algorithm>
#include <utility>

#include "unit/systems/worlds.h"

namespace rambla::test {

using assets::AnimatedPath;
using assets::Interpolation;
using assets::k_none;

void add_clip(assets::Scene& scene, const char* name, std::vector<assets::Channel> channels) {
    assets::Clip& clip = scene.clips.emplace_back();
    clip.name = name;
    clip.channels = std::move(channels);
    for (const assets::Channel& channel : clip.channels)
        clip.duration_s = std::max(clip.duration_s, channel.times_s.back());
}

assets::Scene bending_arm() {
    assets::Scene scene;
    scene.materials.emplace_back();
    assets::Mesh& mesh = scene.meshes.emplace_back();
    for (int ring = 0; ring <= 4; ++ring) {
        const float y = 0.5f * static_cast<float>(ring);
        const float lower = std::clamp(2.0f - static_cast<float>(ring), 0.0f, 1.0f);
        const float elbow = ring == 2 ? 0.5f : lower;
        for (const glm::vec2 corner : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            mesh.positions.push_back({0.1f * corner.x, y, 0.1f * corner.y});
            mesh.bounds.expand(mesh.positions.back());
            mesh.joints.push_back({0, 1, 0, 0});
            mesh.weights.push_back({elbow, 1.0f - elbow, 0, 0});
        }
    }
    for (std::uint32_t i = 0; i < 16; ++i) {
        const std::uint32_t next = i % 4 == 3 ? i - 3 : i + 1;
        for (const std::uint32_t corner : {i, i + 4, next, next, i + 4, next + 4})
            mesh.indices.push_back(corner);
    }
    scene.models.push_back({"arm", {{0, 0}}, {}});

    const std::uint32_t shoulder = add_node(scene, k_none, {});
    assets::Transform local;
    local.translation_m = {0, 1, 0};
    const std::uint32_t elbow = add_node(scene, shoulder, local);
    local.translation_m = {400, 300, 200};
    local.scale = {5, 5, 5};
    const std::uint32_t shown = add_node(scene, k_none, local);
    scene.nodes[shown].model = 0;
    scene.nodes[shown].skeleton = 0;
    glm::mat4 from_elbow{1.0f};
    from_elbow[3] = {0, -1, 0, 1};
    scene.skeletons.push_back({"arm", {shoulder, elbow}, {glm::mat4{1.0f}, from_elbow}});

    const float half = 0.70710678f;
    add_clip(scene, "bend",
             {{elbow,
               AnimatedPath::rotation,
               Interpolation::linear,
               4,
               {0, 1, 2},
               {0, 0, 0, 1, 0, 0, half, half, 0, 0, half, half}}});
    add_clip(scene, "sway",
             {{shoulder,
               AnimatedPath::translation,
               Interpolation::cubic_spline,
               3,
               {0, 1, 2},
               {0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0}}});
    return scene;
}

}  // namespace rambla::test
