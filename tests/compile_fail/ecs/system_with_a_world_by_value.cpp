// A copy of the world would be changed in vain.
// says: takes World, Query, Commands, JobCommands and EventWriter by reference
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("count", [](World) {});
#else
    schedule.add("count", [](World&) {});
#endif
}
