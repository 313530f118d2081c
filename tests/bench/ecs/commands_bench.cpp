#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "bench/ecs/parts.h"
#include "ecs/commands.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

using namespace bench;

struct Force {
    float x = 7.0f, y = 8.0f, z = 9.0f;
};

/// The same data by hand: two tables of arrays without gaps, and a slot per handle that says where its row
/// is.
class Tables {
public:
    explicit Tables(std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            slots_.push_back({i, 1, false});
            still_.entities.push_back({i, 1});
            still_.places.push_back({});
            still_.speeds.push_back({});
        }
    }

    void add(Entity entity, Force force) {
        Slot& slot = slots_[entity.index];
        if (slot.generation != entity.generation || slot.forced) return;
        const std::uint32_t row = slot.row;
        slot.row = static_cast<std::uint32_t>(forced_.entities.size());
        slot.forced = true;
        forced_.entities.push_back(still_.entities[row]);
        forced_.places.push_back(still_.places[row]);
        forced_.speeds.push_back(still_.speeds[row]);
        forces_.push_back(force);
        leave(still_, row);
    }

    void remove(Entity entity) {
        Slot& slot = slots_[entity.index];
        if (slot.generation != entity.generation || !slot.forced) return;
        const std::uint32_t row = slot.row;
        slot.row = static_cast<std::uint32_t>(still_.entities.size());
        slot.forced = false;
        still_.entities.push_back(forced_.entities[row]);
        still_.places.push_back(forced_.places[row]);
        still_.speeds.push_back(forced_.speeds[row]);
        forces_[row] = forces_.back();
        forces_.pop_back();
        leave(forced_, row);
    }

private:
    struct Slot {
        std::uint32_t row;
        std::uint32_t generation;
        bool forced;
    };
    struct Table {
        std::vector<Entity> entities;
        std::vector<Place> places;
        std::vector<Speed> speeds;
    };

    void leave(Table& table, std::uint32_t row) {
        if (row + 1 != table.entities.size()) {
            table.entities[row] = table.entities.back();
            table.places[row] = table.places.back();
            table.speeds[row] = table.speeds.back();
            slots_[table.entities[row].index].row = row;
        }
        table.entities.pop_back();
        table.places.pop_back();
        table.speeds.pop_back();
    }

    std::vector<Slot> slots_;
    Table still_;
    Table forced_;
    std::vector<Force> forces_;
};

/// Tenths of all entities at random places in random order, each chosen anew: were an entity always chosen
/// with the same others, they would come to lie side by side, and nothing would be random after a while.
class Tenths {
public:
    explicit Tenths(std::vector<Entity> entities) {
        std::mt19937 random{1};
        const std::size_t size = entities.size() / 10;
        for (std::vector<Entity>& tenth : tenths_) {
            for (std::size_t i = 0; i < size; ++i)
                std::swap(entities[i],
                          entities[std::uniform_int_distribution{i, entities.size() - 1}(random)]);
            tenth.assign(entities.begin(), entities.begin() + static_cast<std::ptrdiff_t>(size));
        }
    }
    std::span<const Entity> next() {
        turn_ = (turn_ + 1) % tenths_.size();
        return tenths_[turn_];
    }

private:
    std::array<std::vector<Entity>, 50> tenths_;
    std::size_t turn_ = 0;
};

std::vector<Entity> bare_handles(std::uint32_t count) {
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < count; ++i)
        entities.push_back({i, 1});
    return entities;
}

void bare_random_tenth(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    Tables tables{count};
    Tenths tenths{bare_handles(count)};
    for (auto _ : state) {
        const std::span<const Entity> tenth = tenths.next();
        for (Entity entity : tenth)
            tables.add(entity, {});
        benchmark::ClobberMemory();
        state.PauseTiming();
        for (Entity entity : tenth)
            tables.remove(entity);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * (count / 10));
}

void rambla_random_tenth(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    World world;
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < count; ++i)
        entities.push_back(world.create(Place{}, Speed{}));
    Tenths tenths{std::move(entities)};
    Commands commands;
    for (auto _ : state) {
        const std::span<const Entity> tenth = tenths.next();
        for (Entity entity : tenth)
            commands.add(entity, Force{});
        commands.apply(world);
        benchmark::ClobberMemory();
        state.PauseTiming();
        for (Entity entity : tenth)
            world.remove<Force>(entity);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * (count / 10));
}

void bare_all(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    Tables tables{count};
    const std::vector<Entity> entities = bare_handles(count);
    for (auto _ : state) {
        for (Entity entity : entities)
            tables.add(entity, {});
        benchmark::ClobberMemory();
        state.PauseTiming();
        for (Entity entity : entities)
            tables.remove(entity);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

void rambla_all(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    World world;
    for (std::uint32_t i = 0; i < count; ++i)
        world.create(Place{}, Speed{});
    Commands commands;
    for (auto _ : state) {
        commands.add_to_all<Force, With<Place>>({});
        commands.apply(world);
        benchmark::ClobberMemory();
        state.PauseTiming();
        commands.remove_from_all<Force>();
        commands.apply(world);
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK(bare_random_tenth)->Name("add_to_random_tenth/bare")->Apply(sizes);
BENCHMARK(rambla_random_tenth)->Name("add_to_random_tenth/rambla")->Apply(sizes);
BENCHMARK(bare_all)->Name("add_to_all/bare")->Apply(sizes);
BENCHMARK(rambla_all)->Name("add_to_all/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs
