#include "assets/generate/blocks.h"

#include "assets/generate/comparison.h"
#include "assets/generate/lcg.h"
#include "assets/generate/node.h"

namespace rambla::assets {

namespace {

using namespace generate;

void add_boxes(Scene& scene) {
    Builder builder;
    builder.box(Surface::plain, {-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f});
    const std::uint32_t box =
        add_plain_model(scene, "box", builder, add_plain_material(scene, "box", {0.70f, 0.66f, 0.60f}));
    Lcg lcg{12345};
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) {
            Transform at;
            at.translation_m = {(static_cast<float>(i) - 9.5f) * 18.0f, 0.0f,
                                (static_cast<float>(j) - 9.5f) * 18.0f};
            at.scale = {10.0f, 4.0f + 26.0f * lcg.next(), 10.0f};
            const std::uint32_t node = add_node(scene, "box", k_none, at);
            scene.nodes[node].model = box;
            scene.roots.push_back(node);
        }
    }
}

/// 300 cd at a distance d give the illuminance 300/d², in the unit in which the sun's is 3: that is what
/// Light::intensity says as well. Only the window at the radius comes on top.
void add_lights(Scene& scene) {
    Light light;
    light.kind = LightKind::point;
    light.intensity = 300.0f;
    light.range_m = 20.0f;
    for (int k = 0; k < 16; ++k) {
        light.name = "light-" + std::to_string(k);
        light.colour = k % 2 == 0 ? glm::vec3{1.0f, 0.6f, 0.3f} : glm::vec3{0.3f, 0.6f, 1.0f};
        scene.lights.push_back(light);
        Transform at;
        at.translation_m = {(static_cast<float>(k % 4) - 1.5f) * 72.0f, 14.0f,
                            (static_cast<float>(k / 4) - 1.5f) * 72.0f};
        const std::uint32_t node = add_node(scene, light.name, k_none, at);
        scene.nodes[node].light = static_cast<std::uint32_t>(k);
        scene.roots.push_back(node);
    }
}

}  // namespace

Place generate_blocks() {
    Place place = comparison_place("blocks");
    add_boxes(place.scene);
    add_lights(place.scene);
    return place;
}

}  // namespace rambla::assets
