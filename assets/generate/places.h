#pragma once

#include <cstdint>
#include <string_view>

#include "assets/daylight.h"
#include "assets/place.h"

namespace rambla::assets {

/// Generates the place that a scene name asks for: `city`, `street`, or with parameters
/// `city:blocks=4x2,walkers=200` (those of k_city_parameters; `blocks=AxB` sets both counts of blocks).
/// `street` is the city's standard walk. `blocks` and `agents`, for comparison with other engines, are the
/// same for every seed and have neither parameters nor a time. @param time  its light
/// @throws std::invalid_argument  naming the bad part and what would be right
[[nodiscard]] Place generate_place(std::string_view scene_spec, std::uint64_t seed, TimeOfDay time = {});

}  // namespace rambla::assets
