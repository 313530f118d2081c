// One component cannot be handed out twice.
// says: a query names each component once
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    Query<Position, const Position> query;
#else
    Query<Position, const Health> query;
#endif
    (void)query.count(world);
}
