#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "ecs/world.h"

namespace rambla::ecs {
namespace {

struct Position {
    float x = 1.0f, y = 0.0f, z = 0.0f;
};
struct Velocity {
    float x = 1.0f, y = 0.0f, z = 0.0f;
};

/// The usual slot map: a handle names a slot, the slot tells generation and place.
class SlotMap {
public:
    Entity insert(const Position& value) {
        slots_.push_back({1, static_cast<std::uint32_t>(values_.size())});
        values_.push_back(value);
        return {static_cast<std::uint32_t>(slots_.size()) - 1, 1};
    }
    /// Null for a stale handle.
    [[nodiscard]] const Position* find(Entity entity) const {
        if (entity.index >= slots_.size()) return nullptr;
        const Slot& slot = slots_[entity.index];
        return slot.generation == entity.generation ? &values_[slot.place] : nullptr;
    }

private:
    struct Slot {
        std::uint32_t generation;
        std::uint32_t place;
    };
    std::vector<Slot> slots_;
    std::vector<Position> values_;
};

void shuffle(std::vector<Entity>& entities) {
    std::shuffle(entities.begin(), entities.end(), std::mt19937{1});
}

void random_get_bare(benchmark::State& state) {
    SlotMap map;
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        entities.push_back(map.insert({}));
    shuffle(entities);
    for (auto _ : state) {
        float sum = 0.0f;
        for (Entity entity : entities) {
            if (const Position* position = map.find(entity)) sum += position->x;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

std::vector<Entity> fill(World& world, std::int64_t count) {
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < count; ++i)
        entities.push_back(world.create(Position{}, Velocity{}));
    return entities;
}

void random_get_rambla(benchmark::State& state) {
    World world;
    std::vector<Entity> entities = fill(world, state.range(0));
    shuffle(entities);
    for (auto _ : state) {
        float sum = 0.0f;
        world.get_many<Position>(entities, [&](std::size_t, const Position& position) { sum += position.x; });
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The same by single calls.
void random_get_rambla_single(benchmark::State& state) {
    World world;
    std::vector<Entity> entities = fill(world, state.range(0));
    shuffle(entities);
    for (auto _ : state) {
        float sum = 0.0f;
        for (Entity entity : entities)
            sum += world.get<Position>(entity).x;
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(random_get_bare)->Name("random_get/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(random_get_rambla)->Name("random_get/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(random_get_rambla_single)
    ->Name("random_get/rambla_single")
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000);

}  // namespace
}  // namespace rambla::ecs
