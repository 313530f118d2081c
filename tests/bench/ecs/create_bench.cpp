#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "bench/ecs/parts.h"
#include "ecs/commands.h"
#include "ecs/create_many.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

using namespace bench;

/// A handle's slot as a bare program keeps it: where the row is, and how often the slot was used.
struct Slot {
    std::uint32_t row;
    std::uint32_t generation;
};

void bare(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    for (auto _ : state) {
        std::vector<Entity> entities;
        std::vector<Place> places;
        std::vector<Speed> speeds;
        std::vector<Slot> slots;
        for (std::uint32_t i = 0; i < count; ++i) {
            slots.push_back({i, 1});
            entities.push_back({i, 1});
            places.push_back({});
            speeds.push_back({});
        }
        benchmark::DoNotOptimize(places.data());
        benchmark::DoNotOptimize(speeds.data());
        benchmark::DoNotOptimize(entities.data());
        benchmark::DoNotOptimize(slots.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

/// A world whose memory was used before: a round of creating and destroying came first.
class WarmWorld {
public:
    explicit WarmWorld(std::uint32_t count) : entities_(count) {
        fill();
        empty();
    }
    void fill() {
        for (Entity& entity : entities_)
            entity = world_.create(Place{}, Speed{});
    }
    void empty() {
        for (Entity entity : entities_)
            world_.destroy(entity);
    }

private:
    World world_;
    std::vector<Entity> entities_;
};

void rambla(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    WarmWorld warm{count};
    for (auto _ : state) {
        warm.fill();
        state.PauseTiming();
        warm.empty();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

/// The same arrays in one piece each: what a program does that knows the number beforehand.
void bare_many(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    for (auto _ : state) {
        std::vector<Entity> entities(count);
        std::vector<Slot> slots(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            slots[i] = {i, 1};
            entities[i] = {i, 1};
        }
        std::vector<Place> places(count);
        std::vector<Speed> speeds(count);
        benchmark::DoNotOptimize(places.data());
        benchmark::DoNotOptimize(speeds.data());
        benchmark::DoNotOptimize(entities.data());
        benchmark::DoNotOptimize(slots.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void rambla_many(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    World world;
    Commands commands;
    for (auto _ : state) {
        benchmark::DoNotOptimize(create_many(world, count, Place{}, Speed{}).data());
        benchmark::ClobberMemory();
        state.PauseTiming();
        commands.destroy_all();
        commands.apply(world);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK(bare)->Name("create/bare")->Apply(sizes);
BENCHMARK(rambla)->Name("create/rambla")->Apply(sizes);
BENCHMARK(bare_many)->Name("create_many/bare")->Apply(sizes);
BENCHMARK(rambla_many)->Name("create_many/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs
