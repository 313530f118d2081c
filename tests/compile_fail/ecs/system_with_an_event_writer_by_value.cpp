// What a copy emits would be lost.
// says: takes World, Query, Commands, JobCommands and EventWriter by reference
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("hit", [](EventWriter<Health> hits) { hits.emit({1}); });
#else
    schedule.add("hit", [](EventWriter<Health>& hits) { hits.emit({1}); });
#endif
}
