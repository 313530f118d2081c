// A const world can be read by many threads: nobody changes it.
// says: discards qualifiers|marked const
#include "common.h"

void use(const World& world, Entity entity) {
#ifdef RAMBLA_WRONG
    (void)world.get_mut<Health>(entity);
#else
    (void)world.get<Health>(entity);
#endif
}
