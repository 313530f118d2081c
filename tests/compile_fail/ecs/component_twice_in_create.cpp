// An entity has one of a kind.
// says: an entity has each component once
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    world.create(Health{1}, Health{2});
#else
    world.create(Health{1}, Position{});
#endif
}
