// A component whose move may fail could stop an operation half-way through a row.
// says: is_nothrow_move_constructible_v
#include "common.h"

struct Throwing {
    Throwing() = default;
    Throwing(Throwing&& other) : value{other.value} {}
    int value = 0;
};
struct Quiet {
    Quiet() = default;
    Quiet(Quiet&& other) noexcept : value{other.value} {}
    int value = 0;
};

void use(World& world, Entity entity) {
#ifdef RAMBLA_WRONG
    world.add(entity, Throwing{});
#else
    world.add(entity, Quiet{});
#endif
}
