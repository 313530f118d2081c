#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "assets/generate/draws.h"

namespace rambla::assets::generate {

/// 32 scrambled bits of a lattice point (Mueller's integer hash): the source of every texture's randomness.
[[nodiscard]] constexpr std::uint32_t lattice(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x8da6b343u ^ y * 0xd8163841u ^ seed * 0xcb1ab31fu;
    h = (h ^ (h >> 16u)) * 0x45d9f3bu;
    h = (h ^ (h >> 16u)) * 0x45d9f3bu;
    return h ^ (h >> 16u);
}

/// Uniform in [0, 1) for a lattice point.
[[nodiscard]] constexpr float lattice_unit(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return static_cast<float>(lattice(x, y, seed) >> 8u) * 0x1p-24f;
}

/// Smooth value noise in [0, 1] that repeats after `cells` lattice cells over the unit square; p in [0, 1]².
[[nodiscard]] float value_noise(glm::vec2 p, glm::uvec2 cells, std::uint32_t seed);

/// Sum of `octaves` of value noise, each at twice the frequency and half the amplitude, normalised to [0, 1].
[[nodiscard]] float fractal_noise(glm::vec2 p, glm::uvec2 cells, int octaves, std::uint32_t seed);

/// Distances to the nearest and second nearest of one jittered point per cell, in cells; repeats like
/// value_noise. Worley 1996.
[[nodiscard]] glm::vec2 cell_noise(glm::vec2 p, glm::uvec2 cells, std::uint32_t seed);

}  // namespace rambla::assets::generate
