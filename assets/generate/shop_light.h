#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "assets/generate/facade.h"
#include "assets/scene.h"

namespace rambla::assets::generate {

/// A part of a pane that shines evenly, in its wall's plane.
struct GlowingGlass {
    Opening at;
    glm::vec3 radiance{0.0f};
};

/// A shop's lit window as it stands in the world.
struct ShopWindow {
    Frame wall;  ///< of its façade, upright: foot of the wall at y = 0, out of it +z
    Opening opening;
    std::vector<GlowingGlass> glass;  ///< k_reveal_m behind the opening
};

/// What a material's emission is on average over a rectangle of its texture.
/// @param a, b  opposite corners in texture coordinates, within [0, 1]²
[[nodiscard]] glm::vec3 mean_emission(const Scene& scene, std::uint32_t material, glm::vec2 a, glm::vec2 b);

/// 1 up to 0.4 of the reach, and smoothly down to 0 at its end and beyond. @param reach  > 0
[[nodiscard]] double glow_fade(double distance, double reach);

/// How far from its opening a window is taken to light the ground.
struct GlowReach {
    float ahead_m = 4.5f;   ///< out of the wall, > 0
    float beside_m = 6.0f;  ///< along the wall, > 0
};

/// Irradiance over π by a window on level ground that faces up. The opening's sides hide from it what they
/// do. It fades towards the end of the reach; at 4.5 m it would be a tenth of the most.
/// @param point_m  of the world
[[nodiscard]] glm::dvec3 glow_on_ground(const ShopWindow& window, glm::vec3 point_m, const GlowReach& reach);

}  // namespace rambla::assets::generate
