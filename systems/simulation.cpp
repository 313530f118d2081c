#include "systems/simulation.h"

#include "systems/components.h"
#include "systems/simulate/actors.h"
#include "systems/simulate/transform.h"

namespace rambla::systems {
namespace {

void count_step(ecs::ResMut<Clock> clock) {
    ++clock->steps;
}

}  // namespace

Simulation make_simulation() {
    Simulation simulation{std::make_unique<ecs::Schedule>()};
    ecs::Schedule& schedule = *simulation.schedule;
    schedule.add("actors", follow_paths);
    schedule.add("limbs", swing_limbs).after("actors");
    schedule.add("wheels", roll_wheels).after("limbs");
    schedule.add("transforms", TransformPropagation{})
        .after("wheels")
        .reads<Parent>()
        .writes<LocalTransform, Cell, WorldTransform, PreviousWorldTransform>();
    schedule.add("clock", count_step);
    return simulation;
}

}  // namespace rambla::systems
