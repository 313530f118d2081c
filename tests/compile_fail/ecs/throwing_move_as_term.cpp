// A type that cannot be a component cannot be a term.
// says: a term is Entity, a component or one of the terms
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
    Query<Throwing> query;
#else
    Query<Quiet> query;
#endif
    (void)query.count(world);
}
