#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

#include "bench/ecs/parts.h"
#include "ecs/query.h"
#include "ecs/world.h"

namespace rambla::ecs::bench {

/// What few have: stored sparse.
struct Burning {
    float heat = 1.0f;
};

}  // namespace rambla::ecs::bench

template <>
struct rambla::ecs::component_options<rambla::ecs::bench::Burning> {
    static constexpr Storage storage = Storage::sparse;
};

namespace rambla::ecs::bench {
namespace {

constexpr std::size_t k_holders = 100;

/// Rows of the holders, anywhere among all, ascending.
std::vector<std::size_t> holders_of(std::size_t rows) {
    std::vector<std::size_t> all(rows);
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<std::size_t> chosen;
    std::mt19937 engine{1};
    std::ranges::sample(all, std::back_inserter(chosen), k_holders, engine);
    return chosen;
}

void iterate_sparse_bare(benchmark::State& state) {
    std::vector<Place> places(static_cast<std::size_t>(state.range(0)));
    const std::vector<std::size_t> rows = holders_of(places.size());
    const std::vector<Burning> burning(rows.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            places[rows[i]].y += burning[i].heat;
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(k_holders));
}

void iterate_sparse_rambla(benchmark::State& state) {
    World world;
    std::vector<Entity> entities;
    for (std::int64_t i = 0; i < state.range(0); ++i)
        entities.push_back(world.create(Place{}));
    for (const std::size_t row : holders_of(entities.size()))
        world.add(entities[row], Burning{});
    Query<Place, const Burning> query;
    for (auto _ : state) {
        query.each(world, [](Place& place, const Burning& burning) { place.y += burning.heat; });
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(k_holders));
}

BENCHMARK(iterate_sparse_bare)->Name("iterate_sparse_100/bare")->Apply(sizes);
BENCHMARK(iterate_sparse_rambla)->Name("iterate_sparse_100/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs::bench
