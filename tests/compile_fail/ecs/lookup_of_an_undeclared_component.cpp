// A system touches what its parameters name.
// says: constraints not satisfied|no matching member function
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("look", [](Lookup<const Health> of) { (void)of.try_get<Position>(Entity{}); });
#else
    schedule.add("look", [](Lookup<const Health> of) { (void)of.try_get<Health>(Entity{}); });
#endif
}
