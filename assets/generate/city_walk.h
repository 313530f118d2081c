#pragma once

#include <vector>

#include "assets/generate/city_plan.h"
#include "assets/place.h"

namespace rambla::assets::generate {

/// The standard walk: sixteen seconds on the parking side of the walked street towards −z, at eye height,
/// with looks to both façades and to the corner house across the crossroads.
[[nodiscard]] std::vector<CameraKey> plan_walk(const CityPlan& plan);

/// How far along −z from the middle of its row of blocks the walk begins and ends, in metres.
inline constexpr float k_walk_from_m = 0.8f;
inline constexpr float k_walk_to_m = 27.0f;

}  // namespace rambla::assets::generate
