#include "bench/ecs/targets.h"
#include "bench/harness/run.h"

int main(int argc, char** argv) {
    return rambla::bench::run("Rambla ecs against bare arrays: medians, nanoseconds per entity",
                              rambla::bench::k_ecs_targets, argc, argv);
}
