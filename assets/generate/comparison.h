#pragma once

#include <cstdint>
#include <string>

#include "assets/generate/builder.h"
#include "assets/place.h"

namespace rambla::assets::generate {

// What the scenes for comparison with other engines have in common. Other engines draw exactly these numbers,
// so none of them may be changed here alone.

/// Frames in the camera's half turn around the scene, one per step of the simulation.
inline constexpr int k_comparison_frames = 100;

/// A place with the ground, its light and the camera's way: in frame f at the angle π·f/100, 130 m from the
/// middle and 70 m high, looking at the origin.
[[nodiscard]] Place comparison_place(const std::string& name);

/// Adds an untextured dielectric of roughness 0.8.
std::uint32_t add_plain_material(Scene& scene, const std::string& name, glm::vec3 albedo);

/// Adds what a builder has made of one surface as a model in that material.
std::uint32_t add_plain_model(Scene& scene, const std::string& name, Builder& builder,
                              std::uint32_t material);

}  // namespace rambla::assets::generate
