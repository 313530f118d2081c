// What a system touches follows from its parameters, so it needs some.
// says: a system is a function that returns nothing
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("look", [](auto view) { (void)view; });
#else
    schedule.add("look", [](View<const Health> view) { (void)view; });
#endif
}
