// A bare handle says nothing: a component wraps it and gives it a name.
// says: a component wraps an Entity and gives it a meaning
#include "common.h"

struct Link {
    Entity to;
};

void use(World& world) {
#ifdef RAMBLA_WRONG
    world.create(Entity{});
#else
    world.create(Link{});
#endif
}
