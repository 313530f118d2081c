// A const world can be read by many threads: nobody changes it.
// says: discards qualifiers|marked const
#include "common.h"

void use(const World& world) {
#ifdef RAMBLA_WRONG
    world.create(Health{1});
#else
    (void)world.entity_count();
#endif
}
