// What an observer is told of is for reading.
// says: an observer takes
#include "ecs/observers.h"

#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    world.observers().on_add<Health>([](Entity, Health& health) { health.points = 1; });
#else
    world.observers().on_add<Health>([](Entity, const Health&) {});
#endif
}
