#include "assets/export/sun.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rambla::assets {

namespace {

/// Turns +Z into a direction, by the shortest way: the half-angle quaternion of (1 + Z·d, Z × d).
glm::quat turned_to(glm::vec3 direction) {
    const glm::quat twice{1.0f + direction.z, -direction.y, direction.x, 0.0f};
    const float length = glm::length(twice);
    constexpr float k_opposite = 1e-4f;  // of −Z, to which all ways are equally long
    return length > k_opposite ? twice / length : glm::quat{0.0f, 0.0f, 1.0f, 0.0f};
}

}  // namespace

void add_sun(Scene& scene, const Environment& environment) {
    const glm::vec3 illuminance = environment.sun_illuminance;
    const float brightest = std::max({illuminance.x, illuminance.y, illuminance.z});
    if (!(brightest > 0.0f)) return;
    Light light;
    light.name = "sun";
    light.kind = LightKind::directional;
    light.colour = illuminance / brightest;  // KHR_lights_punctual: up to 1
    light.intensity = brightest;
    Node node;
    node.name = "sun";
    node.light = static_cast<std::uint32_t>(scene.lights.size());
    node.local.rotation = turned_to(environment.direction_to_sun);
    scene.lights.push_back(std::move(light));
    scene.roots.push_back(static_cast<std::uint32_t>(scene.nodes.size()));
    scene.nodes.push_back(std::move(node));
}

}  // namespace rambla::assets
