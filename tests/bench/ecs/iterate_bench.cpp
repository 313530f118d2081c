#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Velocity {
    float x = 1.0f, y = 2.0f, z = 3.0f;
};

/// The work of both variants.
inline void integrate(std::span<Position> positions, std::span<const Velocity> velocities) {
    constexpr float k_step_s = 1.0f / 60.0f;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i].x += velocities[i].x * k_step_s;
        positions[i].y += velocities[i].y * k_step_s;
        positions[i].z += velocities[i].z * k_step_s;
    }
}

void iterate_bare(benchmark::State& state) {
    std::vector<Position> positions(static_cast<std::size_t>(state.range(0)));
    const std::vector<Velocity> velocities(positions.size());
    for (auto _ : state) {
        integrate(positions, velocities);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void iterate_rambla(benchmark::State& state) {
    World world;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        world.create(Position{}, Velocity{});
    Query<Position, const Velocity> moving;
    for (auto _ : state) {
        world.advance_version();
        for (auto [positions, velocities] : moving.chunks(world))
            integrate(positions, velocities);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Seven components, of which the loop reads all and writes three.
struct Force {
    float x = 0.1f, y = 0.2f, z = 0.3f;
};
struct Mass {
    float kilograms = 2.0f;
};
struct Drag {
    float per_second = 0.1f;
};
struct Wind {
    float x = 1.0f, y = 0.0f, z = 0.5f;
};
struct Travelled {
    float metres = 0.0f;
};

[[gnu::noinline]] void simulate(std::span<Position> positions, std::span<Velocity> velocities,
                                std::span<Travelled> travelled, std::span<const Force> forces,
                                std::span<const Mass> masses, std::span<const Drag> drags,
                                std::span<const Wind> winds) {
    constexpr float k_step_s = 1.0f / 60.0f;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const float impulse = k_step_s / masses[i].kilograms;
        const float slowed = drags[i].per_second * k_step_s;
        Velocity velocity = velocities[i];
        velocity.x += forces[i].x * impulse - (velocity.x - winds[i].x) * slowed;
        velocity.y += forces[i].y * impulse - (velocity.y - winds[i].y) * slowed;
        velocity.z += forces[i].z * impulse - (velocity.z - winds[i].z) * slowed;
        positions[i].x += velocity.x * k_step_s;
        positions[i].y += velocity.y * k_step_s;
        positions[i].z += velocity.z * k_step_s;
        travelled[i].metres += (velocity.x + velocity.y + velocity.z) * k_step_s;
        velocities[i] = velocity;
    }
}

constexpr unsigned k_archetypes = 32;

template <int N>
struct Tag {};

/// The archetype of the n-th entity ever made: any of the 32, at random, but the same in every run.
unsigned archetype_of(std::uint32_t n) {
    return (n * 2654435761u) >> 27u;
}

/// One table per archetype.
struct Table {
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
    std::vector<Travelled> travelled;
    std::vector<Force> forces;
    std::vector<Mass> masses;
    std::vector<Drag> drags;
    std::vector<Wind> winds;

    void resize(std::size_t rows) {
        positions.resize(rows);
        velocities.resize(rows);
        travelled.resize(rows);
        forces.resize(rows);
        masses.resize(rows);
        drags.resize(rows);
        winds.resize(rows);
    }
};

template <int... Bits>
Entity create_in(World& world, unsigned archetype, std::integer_sequence<int, Bits...>) {
    const Entity entity = world.create(Position{}, Velocity{}, Travelled{}, Force{}, Mass{}, Drag{}, Wind{});
    const auto one = [&]<int Bit>(std::integral_constant<int, Bit>) {
        if ((archetype >> static_cast<unsigned>(Bit) & 1u) != 0) world.add<Tag<Bit>>(entity);
    };
    (one(std::integral_constant<int, Bits>{}), ...);
    return entity;
}

/// Fills all, then ends a random half and makes as many anew. Returns the rows per archetype.
std::vector<std::size_t> churn(World& world, std::size_t entities) {
    std::vector<Entity> alive;
    std::vector<unsigned> archetypes;
    std::vector<std::size_t> rows(k_archetypes);
    std::uint32_t made = 0;
    const auto make = [&] {
        const unsigned archetype = archetype_of(made++);
        ++rows[archetype];
        archetypes.push_back(archetype);
        return create_in(world, archetype, std::make_integer_sequence<int, 5>{});
    };
    for (std::size_t i = 0; i < entities; ++i)
        alive.push_back(make());
    std::mt19937 random{1};
    for (std::size_t i = 0; i < entities / 2; ++i) {
        const std::size_t victim = random() % alive.size();
        world.destroy(alive[victim]);
        --rows[archetypes[victim]];
        alive[victim] = alive.back();
        archetypes[victim] = archetypes.back();
        alive.pop_back();
        archetypes.pop_back();
    }
    while (alive.size() < entities)
        alive.push_back(make());
    return rows;
}

void iterate_7_bare(benchmark::State& state) {
    std::vector<Table> tables(k_archetypes);
    {
        World world;
        const std::vector<std::size_t> rows = churn(world, static_cast<std::size_t>(state.range(0)));
        for (unsigned i = 0; i < k_archetypes; ++i)
            tables[i].resize(rows[i]);
    }
    for (auto _ : state) {
        for (Table& table : tables)
            simulate(table.positions, table.velocities, table.travelled, table.forces, table.masses,
                     table.drags, table.winds);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void iterate_7(benchmark::State& state, const WorldOptions& options) {
    World world{options};
    churn(world, static_cast<std::size_t>(state.range(0)));
    Query<Position, Velocity, Travelled, const Force, const Mass, const Drag, const Wind> query;
    for (auto _ : state) {
        world.advance_version();
        for (auto [positions, velocities, travelled, forces, masses, drags, winds] : query.chunks(world))
            simulate(positions, velocities, travelled, forces, masses, drags, winds);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void iterate_7_rambla(benchmark::State& state) {
    iterate_7(state, {});
}

/// With each archetype's columns side by side in one block, instead of in ranges of address space of their
/// own.
void iterate_7_blocks(benchmark::State& state) {
    iterate_7(state, {.reserve_address_space = false});
}

/// All that a walk costs apart from its rows.
void query_one_rambla(benchmark::State& state) {
    World world;
    world.create(Position{}, Velocity{});
    Query<Position, const Velocity> query;
    for (auto _ : state) {
        for (auto [positions, velocities] : query.chunks(world))
            positions[0].x += velocities[0].x;
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations());
}

BENCHMARK(iterate_bare)->Name("iterate_2/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_rambla)->Name("iterate_2/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_7_bare)->Name("iterate_7_churned/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_7_rambla)->Name("iterate_7_churned/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_7_bare)->Name("iterate_7_blocks/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_7_blocks)->Name("iterate_7_blocks/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(query_one_rambla)->Name("query_one/rambla")->Arg(1);

}  // namespace
}  // namespace rambla::ecs
