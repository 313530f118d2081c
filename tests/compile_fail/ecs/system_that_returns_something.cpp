// Nobody would read it.
// says: a system is a function that returns nothing
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("count", [](View<const Health> all) { return all.count(); });
#else
    schedule.add("count", [](View<const Health> all) { (void)all.count(); });
#endif
}
