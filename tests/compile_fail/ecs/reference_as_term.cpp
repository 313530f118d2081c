// A term is a type of component, not a reference to one.
// says: a term is Entity, a component or one of the terms
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    Query<Position&> query;
#else
    Query<Position> query;
#endif
    (void)query.count(world);
}
