// A query that writes needs a world that may be written.
// says: no matching (member )?function|discards qualifiers
#include "common.h"

void use(const World& world) {
#ifdef RAMBLA_WRONG
    Query<Health> query;
#else
    Query<const Health> query;
#endif
    for (auto [healths] : query.chunks(world))
        (void)healths;
}
