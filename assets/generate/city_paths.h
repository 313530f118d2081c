#pragma once

#include <cstdint>
#include <vector>

#include "assets/generate/city_plan.h"
#include "assets/generate/draws.h"
#include "assets/place.h"

namespace rambla::assets::generate {

/// Ways around every block and along the city's edge, joined by the crossings, at pavement height (road
/// height on the carriageway).
struct PavementPlan {
    PathNetwork network;
    std::vector<std::uint32_t> walked_links;    ///< along both sides of the standard walk's street
    std::vector<std::uint32_t> pavement_links;  ///< those long enough to start on: no crossings
};
[[nodiscard]] PavementPlan plan_pavements(const CityPlan& plan);

/// One-way lanes, a link from crossroads to crossroads.
[[nodiscard]] PathNetwork plan_lanes(const CityPlan& plan);

/// A crossing of the street that lies between two blocks, or a block and the edge: its middle on the road and
/// whether the street runs along z.
struct Crossing {
    glm::vec2 middle{0.0f};
    bool street_along_z = true;
};
/// All zebras. The street of the standard walk has none where the walk leaves its block, so that nobody
/// crosses the camera's way.
[[nodiscard]] std::vector<Crossing> plan_crossings(const CityPlan& plan);

/// Walkers and cars with varied speed, in both directions; two of five walkers are in the walked street.
[[nodiscard]] std::vector<ActorStart> plan_actors(const CityParameters& parameters,
                                                  const PavementPlan& pavements, const PathNetwork& lanes,
                                                  const std::vector<std::uint32_t>& people,
                                                  const std::vector<std::uint32_t>& cars, std::uint64_t seed);

}  // namespace rambla::assets::generate
