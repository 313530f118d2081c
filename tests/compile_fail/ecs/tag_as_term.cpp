// Tags have no values to hand out.
// says: a tag has no column: use With or Without
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    Query<Frozen> query;
#else
    Query<With<Frozen> > query;
#endif
    (void)query.count(world);
}
