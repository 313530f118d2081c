// A chunk knows the versions of its own columns.
// says: not a term of this query that hands something out
#include "common.h"

void use(const World& world) {
    Query<const Health> query;
    for (const auto& chunk : query.chunks(world)) {
#ifdef RAMBLA_WRONG
        (void)chunk.version<Position>();
#else
        (void)chunk.version<Health>();
#endif
    }
}
