#include "game/player.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

#include "systems/position.h"

namespace rambla::game {
namespace {

constexpr auto k_step_s = static_cast<float>(systems::k_step_s);
constexpr float k_walk_m_s = 2.0f;  // brisk: a street at a stroller's 1.3 m/s feels endless on a screen
constexpr float k_run_m_s = 5.5f;
constexpr float k_gravity_m_s2 = 9.81f;
constexpr float k_jump_m_s = 3.4f;           // rises 0.59 m
constexpr float k_highest_pitch_rad = 1.5f;  // just short of straight up, where "ahead" would vanish
constexpr float k_eye_lag_kept = 0.80f;      // per step: a kerb's jolt fades within a tenth of a second
constexpr float k_near_m = 0.05f;  // nearer than the walker's radius, so that walls are never cut open

const Walker k_walker;

glm::vec2 wanted_velocity(const Player& player, const PlayerIntent& intent) {
    const glm::vec2 ahead{-std::sin(player.yaw_rad), -std::cos(player.yaw_rad)};
    const glm::vec2 right{-ahead.y, ahead.x};
    glm::vec2 direction = intent.move.x * right + intent.move.y * ahead;
    const float length = glm::length(direction);
    if (length > 1.0f) direction /= length;
    return direction * (intent.run ? k_run_m_s : k_walk_m_s);
}

/// Sets feet at `feet_m` (from the anchor) onto the ground, or lets them fall. False: there is no ground
/// below.
bool settle(Player& player, glm::vec3& feet_m, std::span<const Triangle> triangles) {
    const std::optional<float> ground = ground_height(triangles, feet_m, k_walker);
    if (!ground) return false;
    const float above_m = feet_m.y - *ground;
    const bool rests = player.on_ground && player.fall_m_s <= 0.0f && above_m <= k_walker.step_m;
    if (!rests) {
        player.fall_m_s -= k_gravity_m_s2 * k_step_s;
        feet_m.y += player.fall_m_s * k_step_s;
        player.on_ground = player.fall_m_s <= 0.0f && feet_m.y <= *ground;
        if (!player.on_ground) return true;
    }
    player.eye_lag_m += feet_m.y - *ground;
    feet_m.y = *ground;
    player.fall_m_s = 0.0f;
    return true;
}

}  // namespace

Player player_at(const systems::WorldPosition& origin, glm::vec3 eye_m, glm::vec3 target_m,
                 Surroundings& surroundings) {
    const glm::vec3 ahead = target_m - eye_m;
    Player player;
    player.yaw_rad = std::atan2(-ahead.x, -ahead.z);
    player.feet = systems::moved(origin, glm::dvec3{eye_m} - glm::dvec3{0.0, k_eye_height_m, 0.0});
    surroundings.move_to(player.feet);
    glm::vec3 feet_m = systems::offset_m(surroundings.anchor(), player.feet);
    if (const std::optional<float> ground = ground_height(surroundings.triangles(), feet_m, k_walker)) {
        feet_m.y = *ground;
        player.feet = systems::moved(surroundings.anchor(), glm::dvec3{feet_m});
    }
    return player;
}

void step(Player& player, const PlayerIntent& intent, Surroundings& surroundings) {
    player.yaw_rad = std::remainder(player.yaw_rad + intent.turn_rad, glm::two_pi<float>());
    player.pitch_rad =
        std::clamp(player.pitch_rad + intent.pitch_rad, -k_highest_pitch_rad, k_highest_pitch_rad);
    player.eye_lag_m *= k_eye_lag_kept;
    if (intent.jump && player.on_ground) {
        player.fall_m_s = k_jump_m_s;
        player.on_ground = false;
    }

    surroundings.move_to(player.feet);
    const glm::vec3 start_m = systems::offset_m(surroundings.anchor(), player.feet);
    const glm::vec2 way = wanted_velocity(player, intent) * k_step_s;
    glm::vec3 feet_m =
        pushed_out(surroundings.triangles(), start_m + glm::vec3{way.x, 0.0f, way.y}, k_walker);
    if (!settle(player, feet_m, surroundings.triangles())) {
        feet_m = start_m;
        if (!settle(player, feet_m, surroundings.triangles()))
            player.fall_m_s = 0.0f;  // a scene without ground: hover
    }
    player.feet = systems::moved(surroundings.anchor(), glm::dvec3{feet_m});
}

systems::Eye eye_of(const Player& before, const Player& now, float share) {
    const glm::vec3 way = systems::offset_m(before.feet, now.feet) * share;
    const float lag_m = std::lerp(before.eye_lag_m, now.eye_lag_m, share);
    const float turned_rad = std::remainder(now.yaw_rad - before.yaw_rad, glm::two_pi<float>());
    const float yaw_rad = before.yaw_rad + share * turned_rad;
    const float pitch_rad = std::lerp(before.pitch_rad, now.pitch_rad, share);
    systems::Eye eye;
    eye.place = systems::moved(before.feet, glm::dvec3{way} + glm::dvec3{0.0, k_eye_height_m + lag_m, 0.0});
    eye.rotation = glm::angleAxis(yaw_rad, glm::vec3{0.0f, 1.0f, 0.0f}) *
                   glm::angleAxis(pitch_rad, glm::vec3{1.0f, 0.0f, 0.0f});
    eye.near_m = k_near_m;
    return eye;
}

}  // namespace rambla::game
