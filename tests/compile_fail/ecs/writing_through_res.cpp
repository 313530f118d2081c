// Res reads, ResMut writes.
// says: read-only|const-qualified type
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("heal", [](Res<Health> health) { health->points = 1; });
#else
    schedule.add("heal", [](ResMut<Health> health) { health->points = 1; });
#endif
}
