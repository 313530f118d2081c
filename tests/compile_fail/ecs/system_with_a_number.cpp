// What a system has of its own stands in it, not in its parameters.
// says: values of its own belong to the system itself
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("wait", [](float) {});
#else
    schedule.add("wait", [step_s = 0.5f](View<const Health>) { (void)step_s; });
#endif
}
