#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "systems/components.h"

namespace rambla::systems {

/// One ball of haze, in the space of its source.
struct Particle {
    glm::vec3 centre_m{0.0f};
    float radius_m = 0.0f;
    float opacity = 0.0f;  ///< [0, 1]
};

/// Of ParticleSource::lifetime_s; what is shorter, or no number, counts as 0: the particles stay.
inline constexpr float k_shortest_life_s = 1e-3f;

/// A source's particle at a time. Each is born and dissolves again and again, all of them evenly spread over
/// the lifetime; each birth draws another place and velocity. It appears and dissolves smoothly, and is all
/// there after a third of its lifetime.
/// @param number  < ParticleSource::count
/// @param time_s  also before 0; beyond 10¹² s nothing moves
[[nodiscard]] Particle particle_at(const ParticleSource& source, std::uint32_t number, double time_s);

/// Encloses all that the source's particles ever are.
[[nodiscard]] LocalBounds particle_bounds(const ParticleSource& source);

}  // namespace rambla::systems
