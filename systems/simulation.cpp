#include "systems/simulation.h"

#include "systems/components.h"
#include "systems/simulate/actors.h"
#include "systems/simulate/animation.h"
#include "systems/simulate/deformation.h"
#include "systems/simulate/movers.h"
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
    schedule.add("movers", advance_movers).after("wheels");
    schedule.add("players", advance_players);
    schedule.add("poses", pose_nodes).after("players").after("movers");
    schedule.add("morph weights", pose_weights).after("players");
    schedule.add("transforms", TransformPropagation{})
        .after("poses")
        .reads<Parent>()
        .writes<LocalTransform, Cell, WorldTransform, PreviousWorldTransform>();
    schedule.add("deformations", gather_deformations).after("transforms").after("morph weights");
    schedule.add("bounds of morphed", bound_morphed).after("deformations");
    schedule.add("bounds of skinned", bound_skinned).after("bounds of morphed");
    schedule.add("clock", count_step);
    return simulation;
}

}  // namespace rambla::systems
