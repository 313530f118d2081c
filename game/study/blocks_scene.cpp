#include "game/study/blocks_scene.h"

#include <cmath>

#include "assets/generate/blocks.h"
#include "game/camera_path.h"
#include "systems/components.h"
#include "systems/position.h"

namespace rambla::game::study {
namespace {

constexpr float k_radius_m = 20.0f;
constexpr float k_height_m = 14.0f;
constexpr float k_extent_m = 288.0f;  ///< that the scene's own four by four lights share evenly

void replace_lights(assets::Scene& scene, std::uint32_t count) {
    std::erase_if(scene.roots, [&](std::uint32_t node) { return scene.nodes[node].light != assets::k_none; });
    scene.lights.clear();
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const float cell_m = k_extent_m / static_cast<float>(side);
    const auto along = [&](std::uint32_t i) {
        return (static_cast<float>(i) + 0.5f) * cell_m - 0.5f * k_extent_m;
    };
    for (std::uint32_t k = 0; k < count; ++k) {
        assets::Light& light = scene.lights.emplace_back();
        light.kind = assets::LightKind::point;
        light.colour = k % 2 == 0 ? glm::vec3{1.0f, 0.6f, 0.3f} : glm::vec3{0.3f, 0.6f, 1.0f};
        light.intensity = 300.0f;
        light.range_m = k_radius_m;
        assets::Node& node = scene.nodes.emplace_back();
        node.light = k;
        node.local.translation_m = {along(k % side), k_height_m, along(k / side)};
        scene.roots.push_back(static_cast<std::uint32_t>(scene.nodes.size() - 1));
    }
}

}  // namespace

std::string_view to_text(View view) {
    return view == View::above ? "above" : "below";
}

Stage blocks_with_lights(std::uint32_t lights, std::uint32_t suns) {
    assets::Place place = assets::generate_blocks();
    replace_lights(place.scene, lights);
    Stage stage = make_stage(std::move(place), 1, {});
    for (std::uint32_t sun = 1; sun < suns; ++sun) {
        const glm::vec3 towards{0.6f, -0.6f, -0.5f};
        stage.world->create(
            systems::WorldTransform{.linear = glm::mat3_cast(look_rotation(glm::vec3{0.0f}, towards))},
            systems::DirectionalLight{glm::vec3{0.5f}});
    }
    return stage;
}

systems::Eye eye_of(const Stage& stage, View view, double share, glm::uvec2 size_px) {
    systems::Eye eye =
        walk_eye(stage, static_cast<float>(share) * (stage.walk.back().time_s - stage.walk.front().time_s));
    if (view == View::below) {
        // On the middle one of the ways between the boxes, which are 18 m apart, and a little across them.
        const float along_m = 120.0f * static_cast<float>(share);
        const glm::vec3 at{0.0f, 1.7f, 171.0f - along_m};
        eye.place = systems::moved(stage.origin, glm::dvec3{at});
        eye.rotation = look_rotation(at, at + glm::vec3{0.2f, 0.02f, -1.0f});
    }
    eye.size_px = size_px;
    return eye;
}

}  // namespace rambla::game::study
