#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace rambla::game {

/// Corners of one triangle in metres; which side is the front does not matter.
using Triangle = std::array<glm::vec3, 3>;

/// An upright cylinder that walks: what the player is to the scene.
struct Walker {
    float radius_m = 0.28f;
    float height_m = 1.75f;
    float step_m = 0.40f;  ///< climbs this much without a jump: kerbs, stairs
};

/// Steeper ground than this is a wall: cosine of its angle to the horizontal (50°).
inline constexpr float k_walkable_cosine = 0.643f;

/// Height of the highest walkable ground under (or up to a step above) feet at `feet_m`; nothing if there is
/// none below.
[[nodiscard]] std::optional<float> ground_height(std::span<const Triangle> triangles, glm::vec3 feet_m,
                                                 const Walker& walker);

/// Where feet come to stand that were put at `feet_m`, once nothing between a step's height and the head is
/// nearer than the radius: slides along walls. The height stays.
[[nodiscard]] glm::vec3 pushed_out(std::span<const Triangle> triangles, glm::vec3 feet_m,
                                   const Walker& walker);

}  // namespace rambla::game
