#include "assets/generate/agents.h"

#include <cmath>
#include <numbers>

#include "assets/generate/comparison.h"
#include "assets/generate/lcg.h"
#include "assets/generate/node.h"

namespace rambla::assets {

namespace {

using namespace generate;

constexpr int k_movers = 10'000;
constexpr float k_span_m = 380.0f;

/// Body and head, looking along +X.
std::uint32_t add_mover_model(Scene& scene) {
    Builder builder;
    builder.box(Surface::plain, {-0.2f, 0.0f, -0.3f}, {0.2f, 1.3f, 0.3f});
    builder.box(Surface::plain, {-0.175f, 1.3f, -0.175f}, {0.175f, 1.7f, 0.175f});
    return add_plain_model(scene, "mover", builder,
                           add_plain_material(scene, "mover", {0.80f, 0.30f, 0.20f}));
}

}  // namespace

Place generate_agents() {
    Place place = comparison_place("agents");
    Scene& scene = place.scene;
    const std::uint32_t model = add_mover_model(scene);
    const std::uint32_t stand = add_node(scene, "movers", k_none, {});
    scene.roots.push_back(stand);
    place.mover_reach_m = 0.5f * k_span_m;
    Lcg lcg{777};
    for (int n = 0; n < k_movers; ++n) {
        Transform at;
        at.translation_m.x = (lcg.next() - 0.5f) * k_span_m;
        at.translation_m.z = (lcg.next() - 0.5f) * k_span_m;
        const float heading = lcg.next() * static_cast<float>(2.0 * std::numbers::pi);
        const float speed = 1.0f + 4.0f * lcg.next();
        at.rotation = {std::cos(0.5f * heading), 0.0f, -std::sin(0.5f * heading), 0.0f};
        const std::uint32_t node = add_node(scene, "mover", stand, at);
        scene.nodes[node].model = model;
        place.movers.push_back({node, heading, speed});
    }
    return place;
}

}  // namespace rambla::assets
