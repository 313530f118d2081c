// An entity has one of a kind.
// says: an entity has each component once
#include "common.h"

void use(Commands& commands) {
#ifdef RAMBLA_WRONG
    commands.create(Health{1}, Health{2});
#else
    commands.create(Health{1}, Position{});
#endif
}
