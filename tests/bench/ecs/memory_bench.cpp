#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>

#include "ecs/world.h"

namespace rambla::ecs {
namespace {

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Velocity {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};

/// What a world of entities with 24 bytes of components holds, per entity.
void memory(benchmark::State& state) {
    std::size_t bytes = 0;
    for (auto _ : state) {
        World world;
        for (std::int64_t i = 0; i < state.range(0); ++i)
            world.create(Position{}, Velocity{});
        bytes = world.memory_bytes();
    }
    state.counters["bytes_per_entity"] = static_cast<double>(bytes) / static_cast<double>(state.range(0));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(memory)->Name("memory/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

}  // namespace
}  // namespace rambla::ecs
