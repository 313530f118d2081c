#include <benchmark/benchmark.h>

#include <cstddef>
#include <span>
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

BENCHMARK(iterate_bare)->Name("iterate_2/bare")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
BENCHMARK(iterate_rambla)->Name("iterate_2/rambla")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

}  // namespace
}  // namespace rambla::ecs
