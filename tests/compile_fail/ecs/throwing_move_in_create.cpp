// A component whose move may fail could stop an operation half-way through a row.
// says: moving and ending a component cannot fail
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

void use(World& world) {
#ifdef RAMBLA_WRONG
    world.create(Throwing{});
#else
    world.create(Quiet{});
#endif
}
