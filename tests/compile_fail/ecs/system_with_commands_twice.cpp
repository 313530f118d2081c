// Both would be the same recording.
// says: a system has one Commands&
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("spawn", [](Commands&, Commands&) {});
#else
    schedule.add("spawn", [](Commands&, JobCommands&) {});
#endif
}
