// Tags have no values that could be there or not.
// says: Optional takes a component with a value of its own
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    Query<Position, Optional<Frozen>> query;
#else
    Query<Position, Optional<Health>> query;
#endif
    (void)query.count(world);
}
