// A view is made for each run.
// says: by value, not by reference
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("look", [](View<const Health>&) {});
#else
    schedule.add("look", [](View<const Health>) {});
#endif
}
