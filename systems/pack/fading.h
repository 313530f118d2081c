#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ecs/world.h"
#include "systems/components.h"
#include "systems/look/culling.h"

namespace rambla::systems {

inline constexpr std::uint8_t k_faded_away = 255;  ///< nothing is left to be drawn

/// How far something is gone, as Instance::material has it.
/// @param opacity  [0, 1]; what is more is 1, what is less or no number 0
[[nodiscard]] std::uint8_t faded(float opacity);

/// What is left of something at this distance, [0, 1], in a straight line between the fade's ends. Ends that
/// are equal, or the wrong way round, make it a step at `gone_m`. Distances that are no number leave all of
/// it.
[[nodiscard]] float near_opacity(const NearFade& fade, float distance_m);

/// From the eye to a box around what lies `centre_m` from it; 0 inside. NaN where the box has no numbers.
[[nodiscard]] float distance_to_box(glm::vec3 centre_m, glm::vec3 half_extents_m);

/// How far a row of a chunk is gone, by its Opacity and NearFade.
/// @param box  of the row, camera-relative
[[nodiscard]] std::uint8_t faded(const LookChunk& chunk, std::size_t row, const LocalBounds& box);

/// Materials of what has an Opacity or a NearFade, ascending.
[[nodiscard]] std::vector<std::uint32_t> fading_materials(const ecs::World& world);

}  // namespace rambla::systems
