#pragma once

#include <glm/glm.hpp>

#include "game/surroundings.h"
#include "systems/pipeline.h"

namespace rambla::game {

/// What the player wants during one simulation step.
struct PlayerIntent {
    glm::vec2 move{0.0f};    ///< x to the right, y ahead; each −1 to 1
    float turn_rad = 0.0f;   ///< to the left
    float pitch_rad = 0.0f;  ///< upwards
    bool run = false;
    bool jump = false;
};

/// Somebody on foot.
struct Player {
    systems::WorldPosition feet;
    float yaw_rad = 0.0f;    ///< 0 looks along −Z, growing turns to the left
    float pitch_rad = 0.0f;  ///< upwards
    float fall_m_s = 0.0f;   ///< upward speed
    float eye_lag_m = 0.0f;  ///< how far the eye is still above its height, after a step up or down
    bool on_ground = true;
};

inline constexpr float k_eye_height_m = 1.65f;

/// A player whose eye is at `eye_m` from `origin`, looking at `target_m`, set upon the ground below.
[[nodiscard]] Player player_at(const systems::WorldPosition& origin, glm::vec3 eye_m, glm::vec3 target_m,
                               Surroundings& surroundings);

/// One step of 1/60 s: walks, slides along walls, climbs kerbs and stairs, falls. Never leaves the ground for
/// where there is none below.
void step(Player& player, const PlayerIntent& intent, Surroundings& surroundings);

/// Eye between two steps. @param share  0 at `before`, 1 at `now`
[[nodiscard]] systems::Eye eye_of(const Player& before, const Player& now, float share);

}  // namespace rambla::game
