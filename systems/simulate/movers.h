#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "ecs/view.h"
#include "systems/components.h"

namespace rambla::systems {

/// Where a mover is in its parent's xz plane, and where it heads.
struct Course {
    float x_m = 0.0f;
    float z_m = 0.0f;
    float heading_rad = 0.0f;
};

/// The course after one step: straight ahead, then mirrored and set back by the walls that were passed, those
/// across x first.
[[nodiscard]] Course advanced(Course course, float speed_m_s, float reach_m, float step_s);

/// Turns +X to (cos heading, 0, sin heading).
[[nodiscard]] glm::quat heading_rotation(float heading_rad);

/// System: moves movers by one step.
void advance_movers(ecs::View<Mover, LocalTransform> movers);

}  // namespace rambla::systems
