#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "bench/ecs/parts.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

using namespace bench;

/// The same arrays, kept by hand: rows without gaps, and a slot per handle that says where its row is.
class Table {
public:
    explicit Table(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            slots_.push_back({i, 1});
            entities_.push_back({i, 1});
            places_.push_back({});
            speeds_.push_back({});
        }
    }

    void destroy(Entity entity) {
        Slot& slot = slots_[entity.index];
        if (slot.generation != entity.generation) return;
        const std::uint32_t row = slot.row;
        ++slot.generation;
        slot.row = first_free_;
        first_free_ = entity.index;
        if (row + 1 != entities_.size()) {
            entities_[row] = entities_.back();
            places_[row] = places_.back();
            speeds_[row] = speeds_.back();
            slots_[entities_[row].index].row = row;
        }
        entities_.pop_back();
        places_.pop_back();
        speeds_.pop_back();
    }

    [[nodiscard]] const std::vector<Entity>& entities() const { return entities_; }

private:
    struct Slot {
        std::uint32_t row;
        std::uint32_t generation;
    };

    std::vector<Slot> slots_;
    std::vector<Entity> entities_;
    std::vector<Place> places_;
    std::vector<Speed> speeds_;
    std::uint32_t first_free_ = 0xffffffffu;
};

void bare_each(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    const Table full{count};
    for (auto _ : state) {
        state.PauseTiming();
        Table table = full;
        state.ResumeTiming();
        for (Entity entity : full.entities())
            table.destroy(entity);
        benchmark::ClobberMemory();
        state.PauseTiming();
        { [[maybe_unused]] const Table ended = std::move(table); }
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void rambla_each(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    World world;
    std::vector<Entity> entities(count);
    for (auto _ : state) {
        state.PauseTiming();
        for (std::uint32_t i = 0; i < count; ++i)
            entities[i] = world.create(Place{}, Speed{});
        state.ResumeTiming();
        for (Entity entity : entities)
            world.destroy(entity);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK(bare_each)->Name("destroy_each/bare")->Apply(sizes);
BENCHMARK(rambla_each)->Name("destroy_each/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs
