// What a view only reads stays as it is: systems that read it run side by side.
// says: discards qualifiers|drops .*const.* qualifier|no matching function|cannot be used|no match for call
#include "ecs/schedule.h"

#include "common.h"

void use(Schedule& schedule) {
#ifdef RAMBLA_WRONG
    schedule.add("heal", [](View<const Health> all) { all.each([](Health& health) { ++health.points; }); });
#else
    schedule.add("heal", [](View<Health> all) { all.each([](Health& health) { ++health.points; }); });
#endif
}
