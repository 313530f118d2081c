// Nobody would play a copy's commands.
// says: takes World, Query, Commands, JobCommands and EventWriter by reference
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("spawn", [](Commands commands) { commands.create(Health{1}); });
#else
    schedule.add("spawn", [](Commands& commands) { commands.create(Health{1}); });
#endif
}
