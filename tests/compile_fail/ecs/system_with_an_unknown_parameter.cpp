// The schedule knows what to provide, or says so.
// says: a parameter of a system is a View, Lookup, Res, ResMut or EventReader
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("heal", [](Health) {});
#else
    schedule.add("heal", [](ResMut<Health>) {});
#endif
}
