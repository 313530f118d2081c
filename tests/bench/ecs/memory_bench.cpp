#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <utility>

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

template <std::size_t N>
struct Part {
    float value = 0.0f;
};

/// Gives the components whose bits are set, from the lowest on: on its way the entity passes only archetypes
/// of smaller numbers.
template <std::size_t... N>
void add_parts(World& world, Entity entity, std::size_t bits, std::index_sequence<N...>) {
    ((bits >> N & 1u ? world.add(entity, Part<N>{}) : void()), ...);
}

/// What a world holds per archetype where every entity has components of its own: 10 000 archetypes of one
/// entity each, with up to 14 components of 4 bytes, 6.5 on average.
void archetypes_10000(benchmark::State& state) {
    constexpr std::size_t k_archetypes = 10'000;
    double bytes = 0.0;
    for (auto _ : state) {
        World world;
        for (std::size_t i = 0; i < k_archetypes; ++i)
            add_parts(world, world.create(), i, std::make_index_sequence<14>{});
        if (world.archetype_count() != k_archetypes) state.SkipWithError("not 10 000 archetypes");
        bytes = static_cast<double>(world.memory_bytes());
    }
    state.counters["bytes_per_archetype"] = bytes / static_cast<double>(k_archetypes);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(k_archetypes));
}

BENCHMARK(archetypes_10000)->Name("archetypes_10000/rambla");
BENCHMARK(memory)->Name("memory/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

}  // namespace
}  // namespace rambla::ecs
