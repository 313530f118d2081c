// Columns are aligned to 64 bytes, no more.
// says: a component is aligned to at most 64 bytes
#include "common.h"

struct alignas(128) Page {
    float value = 0.0f;
};
struct alignas(64) Line {
    float value = 0.0f;
};

void use(World& world) {
#ifdef RAMBLA_WRONG
    world.create(Page{});
#else
    world.create(Line{});
#endif
}
