#pragma once

#include <array>
#include <cstdint>

#include "assets/daylight.h"
#include "assets/parameter.h"
#include "assets/place.h"

namespace rambla::assets {

/// A city of blocks with chamfered corners and narrow streets, as in Barcelona's Gràcia.
struct CityParameters {
    int blocks_x = 3;
    int blocks_z = 3;
    float street_width_m = 9.0f;
    int walkers = 48;
    int cars = 12;
};
inline constexpr std::array k_city_parameters{
    parameter<&CityParameters::blocks_x>("blocks-x", "", 1, 100, "Blocks from west to east."),
    parameter<&CityParameters::blocks_z>("blocks-z", "", 1, 100, "Blocks from north to south."),
    parameter<&CityParameters::street_width_m>("street", "m", 6, 30,
                                               "Width of a street between its façades."),
    parameter<&CityParameters::walkers>("walkers", "", 0, 100000, "People on the pavements."),
    parameter<&CityParameters::cars>("cars", "", 0, 10000, "Cars on the lanes."),
};

/// Generates the city with its paths, actors and the standard walk; the same seed and time give the same
/// bytes. The time decides what shines; what stands where does not depend on it.
[[nodiscard]] Place generate_city(const CityParameters& parameters, std::uint64_t seed, TimeOfDay time = {});

}  // namespace rambla::assets
