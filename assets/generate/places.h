#pragma once

#include <cstdint>
#include <string_view>

#include "assets/place.h"

namespace rambla::assets {

/// Generates the place that a scene name asks for: `city`, `street`, or with parameters
/// `city:blocks=4x2,walkers=200` (those of k_city_parameters; `blocks=AxB` sets both counts of blocks).
/// `street` is the city's standard walk.
/// @throws std::invalid_argument  naming the bad part and what would be right
[[nodiscard]] Place generate_place(std::string_view scene_spec, std::uint64_t seed);

}  // namespace rambla::assets
