#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace rambla::assets {

/// A random point of the unit square that depends on its arguments alone: stratified, so that each of the
/// `count` samples of a pixel has a cell of its own. Cells are squares if `count` is a square number, else as
/// square as a grid of `count` cells can be; a prime number makes strips.
/// @param sample  < count
[[nodiscard]] glm::dvec2 stratified_sample(std::uint64_t seed, std::uint64_t pixel, std::uint32_t sample,
                                           std::uint32_t count);

/// Maps the unit square onto the unit disc, areas by the same factor: Shirley and Chiu 1997, "A low
/// distortion map between disk and square".
[[nodiscard]] glm::dvec2 on_disc(glm::dvec2 square);

/// A direction around a unit normal whose density is cos θ/π: a point of the disc, lifted onto the hemisphere
/// (Malley's method; Pharr, Jakob, Humphreys 2016, 13.6.3).
[[nodiscard]] glm::dvec3 around_normal(glm::dvec3 normal, glm::dvec2 disc);

}  // namespace rambla::assets
