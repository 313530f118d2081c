// A query outlives the walk over its chunks.
// says: passing .*discards qualifiers|no matching member function
#include "common.h"

void use(World& world) {
#ifdef RAMBLA_WRONG
    for (auto [healths] : Query<Health>{}.chunks(world))
#else
    Query<Health> query;
    for (auto [healths] : query.chunks(world))
#endif
        (void)healths;
}
