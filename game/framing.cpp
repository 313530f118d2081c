#include "game/framing.h"

#include <algorithm>
#include <cmath>

#include "game/camera_path.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

constexpr float k_three_quarter_yaw_rad = 0.62f;  // a little less than 45°: both sides show, one of them more
constexpr float k_three_quarter_pitch_rad = 0.32f;  // high enough to see tops, low enough to see sides
constexpr float k_margin = 1.08f;                   // leaves the model a rim of air

/// Near planes stand this share of the distance away: close enough for zooming in, far enough for 32-bit
/// depth.
constexpr float k_near_share = 0.01f;

glm::vec3 direction_from_target(const Orbit& orbit) {
    return {std::sin(orbit.yaw_rad) * std::cos(orbit.pitch_rad), std::sin(orbit.pitch_rad),
            std::cos(orbit.yaw_rad) * std::cos(orbit.pitch_rad)};
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const assets::Scene& scene) {
    std::vector<PlacedNode> placed;
    placed.reserve(scene.nodes.size());
    for (const std::uint32_t root : scene.roots)
        placed.push_back({root, matrix(scene.nodes[root].local)});
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PlacedNode parent = placed[i];
        for (const std::uint32_t child : scene.nodes[parent.node].children) {
            placed.push_back({child, parent.scene_from_node * matrix(scene.nodes[child].local)});
        }
    }
    return placed;
}

Orbit frame_bounds(const assets::Bounds& box, float vertical_fov_rad, float aspect) {
    Orbit orbit{.target_m = box.empty() ? glm::vec3{0.0f} : box.centre(),
                .distance_m = 0.0f,
                .yaw_rad = k_three_quarter_yaw_rad,
                .pitch_rad = k_three_quarter_pitch_rad};
    const glm::vec3 own_half_m = box.empty() ? glm::vec3{0.0f} : box.half_extents();
    const glm::vec3 half_m = own_half_m == glm::vec3{0.0f} ? glm::vec3{1.0f} : own_half_m;
    const glm::quat view_from_world =
        glm::conjugate(look_rotation(direction_from_target(orbit), glm::vec3{0.0f}));
    const float tan_vertical = std::tan(0.5f * vertical_fov_rad);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 sign{(corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                             (corner & 4) != 0 ? 1.0f : -1.0f};
        // Seen from distance d, a point (x, y, z) is inside the rim where |y| ≤ tan · (d − z), and likewise
        // x.
        const glm::vec3 seen = view_from_world * (half_m * sign);
        const float slope = std::max(std::abs(seen.y), std::abs(seen.x) / aspect) / tan_vertical;
        orbit.distance_m = std::max(orbit.distance_m, k_margin * slope + seen.z);
    }
    return orbit;
}

systems::Eye eye_of(const Orbit& orbit, const systems::WorldPosition& origin, const systems::Eye& like) {
    const glm::vec3 from_target = direction_from_target(orbit) * orbit.distance_m;
    systems::Eye eye = like;
    eye.place = systems::moved(origin, glm::dvec3{orbit.target_m} + glm::dvec3{from_target});
    eye.rotation = look_rotation(from_target, glm::vec3{0.0f});
    eye.near_m = k_near_share * orbit.distance_m;
    return eye;
}

Orbit orbit_of(const systems::Eye& eye, const assets::Bounds& box, const systems::WorldPosition& origin) {
    const glm::vec3 eye_m = systems::offset_m(origin, eye.place);
    const glm::vec3 ahead = eye.rotation * glm::vec3{0.0f, 0.0f, -1.0f};
    const glm::vec3 centre_m = box.empty() ? eye_m + ahead : box.centre();
    // The point of the line of sight nearest to the centre; something in front of the eye in any case.
    const float along_m = glm::dot(centre_m - eye_m, ahead);
    const float distance_m = std::max({along_m, 0.1f * glm::length(centre_m - eye_m), 10.0f * eye.near_m});
    return {.target_m = eye_m + distance_m * ahead,
            .distance_m = distance_m,
            .yaw_rad = std::atan2(-ahead.x, -ahead.z),
            .pitch_rad = std::asin(std::clamp(-ahead.y, -1.0f, 1.0f))};
}

ViewingLight viewing_light(const assets::Scene& scene, std::optional<assets::TimeOfDay> time) {
    const assets::TimeOfDay own_time = time.value_or(scene.time.value_or(assets::TimeOfDay{}));
    assets::Environment light = assets::daylight(own_time);
    const float exposure_ev = assets::daylight_exposure_ev(own_time);
    if (time) return {light, exposure_ev};
    bool lit = false;
    bool sunlit = false;
    for (const PlacedNode& placed : placed_nodes(scene)) {
        const std::uint32_t index = scene.nodes[placed.node].light;
        if (index == assets::k_none) continue;
        lit = true;
        const assets::Light& own = scene.lights[index];
        const glm::vec3 to_sun{placed.scene_from_node[2]};
        const bool has_direction = glm::length(to_sun) > 0.0f;
        if (own.kind != assets::LightKind::directional || sunlit || !has_direction) continue;
        sunlit = true;
        light.direction_to_sun = glm::normalize(to_sun);
        light.sun_illuminance = own.colour * own.intensity;
    }
    if (!lit || scene.time) return {light, exposure_ev};
    if (!sunlit) light.sun_illuminance = glm::vec3{0.0f};
    constexpr float k_soft_sky = 0.15f;
    light.sky_zenith_radiance *= k_soft_sky;
    light.sky_horizon_radiance *= k_soft_sky;
    light.ground_radiance *= k_soft_sky;
    return {light, 0.0f};
}

void remove_suns(assets::Scene& scene) {
    for (assets::Node& node : scene.nodes) {
        const bool shines = node.light != assets::k_none;
        if (shines && scene.lights[node.light].kind == assets::LightKind::directional)
            node.light = assets::k_none;
    }
}

}  // namespace rambla::game
