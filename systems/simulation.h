#pragma once

#include <memory>

#include "ecs/schedule.h"

namespace rambla::systems {

/// Resource: the systems of a simulation step, with the memory that they keep from step to step.
struct Simulation {
    std::unique_ptr<ecs::Schedule> schedule;
};

/// Actors along their paths, gaits, movers, clips, transforms, deformations, clock. Needs the resources
/// Paths, Clock, ClipLibrary and Deformations.
[[nodiscard]] Simulation make_simulation();

}  // namespace rambla::systems
