#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "assets/material.h"

namespace rambla::assets {

inline constexpr std::uint32_t k_max_particles = 4096;  ///< of Emitter::count

/// A source of particles: balls of haze that begin about its node, drift and dissolve. Everything is in the
/// node's own space; where they are at a time follows from that time alone.
struct Emitter {
    std::string name;
    std::uint32_t material = k_none;   ///< one with an optical depth
    std::uint32_t count = 1;           ///< of particles at any time, [1, k_max_particles]
    float lifetime_s = 0.0f;           ///< of each; 0: they stay where they began
    float spread_m = 0.0f;             ///< radius of the level disc that they begin in, evenly
    glm::vec3 velocity_m_s{0.0f};      ///< when they begin
    float velocity_spread_m_s = 0.0f;  ///< by which each axis of that differs at most, evenly
    glm::vec3 acceleration_m_s2{0.0f};
    float start_radius_m = 1.0f;  ///< of the balls; > 0
    float end_radius_m = 1.0f;    ///< when they have dissolved; > 0
};

}  // namespace rambla::assets
