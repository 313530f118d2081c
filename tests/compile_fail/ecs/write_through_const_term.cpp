// What a query names const is handed out const.
// says: read-only object|const-qualified
#include "common.h"

void use(World& world) {
    Query<Position, const Health> query;
    for (auto [positions, healths] : query.chunks(world)) {
#ifdef RAMBLA_WRONG
        healths[0].points = 1;
#else
        positions[0].x = static_cast<float>(healths[0].points);
#endif
    }
}
