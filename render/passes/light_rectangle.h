#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "systems/frame.h"

namespace rambla::render {

/// Part of the screen, and of the depths behind it, that a sphere can touch.
struct ScreenRectangle {
    glm::vec2 min{-1.0f};  ///< clip space, [−1, 1]
    glm::vec2 max{1.0f};
    float depth =
        0.0f;  ///< of the sphere's point farthest from the eye, > 0: what lies behind is out of its reach
    float nearest_m =
        0.0f;  ///< from the eye's plane to the sphere, along the view; 0 where it reaches behind
    float farthest_m = 0.0f;  ///< the same to its far side
};

/// Where the near plane lies in the eye's space; negative, but for orthographic views that also see behind
/// the eye.
[[nodiscard]] double near_plane_z(const systems::FrameView& view);

/// Bounds of a sphere on the screen, exact but for what the near plane cuts off.
///
/// Perspective, for each axis, seen from above with the eye at 0 and c = (x, d) the centre:
///
///        x ╱  upper tangent: c turned by asin(r/|c|), direction (x·t + d·r, d·t − x·r) with t = √(|c|² −
///        r²);
///     ●(r)    its slope bounds the sphere. A tangent that points backwards bounds nothing: the screen's edge
///     does.
///   0 ────d
///
/// @param centre_m  camera-relative, world axes
/// @param radius_m  ≥ 0
/// @return  nothing when the sphere lies outside the view
[[nodiscard]] std::optional<ScreenRectangle> sphere_rectangle(const systems::FrameView& view,
                                                              glm::vec3 centre_m, float radius_m);

}  // namespace rambla::render
