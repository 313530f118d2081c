// There is nothing to read from a tag.
// says: a tag has no value: ask has<C>\(\)
#include "common.h"

void use(World& world, Entity entity) {
#ifdef RAMBLA_WRONG
    (void)world.get<Frozen>(entity);
#else
    (void)world.has<Frozen>(entity);
#endif
}
