// A component cannot be required and excluded.
// says: a query names each component once
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    Query<Position, Without<Position>> query;
#else
    Query<Position, Without<Health>> query;
#endif
    (void)query.count(world);
}
