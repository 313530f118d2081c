// Others may look up the same entity at the same time.
// says: a Lookup only reads
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("heal", [](Lookup<Health>) {});
#else
    schedule.add("heal", [](Lookup<const Health>) {});
#endif
}
