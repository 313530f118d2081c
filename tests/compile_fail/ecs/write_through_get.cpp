// get() only reads: writing goes through get_mut(), which counts as a change.
// says: read-only object|const-qualified
#include "common.h"

void use(World& world, Entity entity) {
#ifdef RAMBLA_WRONG
    world.get<Health>(entity).points = 1;
#else
    world.get_mut<Health>(entity).points = 1;
#endif
}
