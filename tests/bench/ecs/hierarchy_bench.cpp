#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "ecs/propagation.h"
#include "ecs/query.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

// Trees of 85 nodes: each node but the leaves has 4 children, four levels.
constexpr std::size_t k_branching = 4;
constexpr std::size_t k_tree_nodes = 1 + 4 + 16 + 64;

/// 3×4 affine map, columns.
struct Affine {
    std::array<float, 12> m{};
};
struct Local : Affine {};
struct Placed : Affine {};

Placed product(const Affine& parent, const Affine& local) {
    Placed result;
    for (std::size_t c = 0; c < 4; ++c) {
        const float x = local.m[c * 3], y = local.m[c * 3 + 1], z = local.m[c * 3 + 2];
        for (std::size_t r = 0; r < 3; ++r) {
            const float turned = parent.m[r] * x + parent.m[3 + r] * y + parent.m[6 + r] * z;
            result.m[c * 3 + r] = c == 3 ? turned + parent.m[9 + r] : turned;
        }
    }
    return result;
}

/// Rotations about Y with a step aside: results stay finite, and no two are alike.
Local random_local(std::mt19937& engine) {
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    const float t = unit(engine);
    const float sine = 2.0f * t / (1.0f + t * t), cosine = (1.0f - t * t) / (1.0f + t * t);
    return {{{cosine, 0, -sine, 0, 1, 0, sine, 0, cosine, unit(engine), unit(engine), unit(engine)}}};
}

/// The plain program: arrays in an order in which parents come first.
struct Arrays {
    static constexpr std::uint32_t k_root = 0xffffffffu;
    std::vector<std::uint32_t> parents;
    std::vector<Local> locals;
    std::vector<Placed> results;

    /// All roots, then all their children, and so on.
    static Arrays by_depth(std::size_t trees) {
        Arrays arrays;
        std::size_t level = trees;
        arrays.parents.assign(trees, k_root);
        for (std::size_t begin = 0; arrays.parents.size() < trees * k_tree_nodes;) {
            for (std::size_t parent = begin; parent < begin + level; ++parent)
                arrays.parents.insert(arrays.parents.end(), k_branching, static_cast<std::uint32_t>(parent));
            begin += level;
            level *= k_branching;
        }
        arrays.fill();
        return arrays;
    }

    /// One tree after the other, each by depth.
    static Arrays by_tree(std::size_t trees) {
        Arrays arrays;
        for (std::size_t tree = 0; tree < trees; ++tree) {
            const std::size_t first = tree * k_tree_nodes;
            arrays.parents.push_back(k_root);
            for (std::size_t node = 1; node < k_tree_nodes; ++node)
                arrays.parents.push_back(static_cast<std::uint32_t>(first + (node - 1) / k_branching));
        }
        arrays.fill();
        return arrays;
    }

    void fill() {
        std::mt19937 engine{1};
        for (std::size_t i = 0; i < parents.size(); ++i)
            locals.push_back(random_local(engine));
        results.resize(parents.size());
    }

    void propagate() {
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] == k_root) {
                results[i] = {locals[i]};
            } else {
                results[i] = product(results[parents[i]], locals[i]);
            }
        }
    }
};

/// The same in a world, created in the arrays' order.
struct Trees {
    World world;
    std::vector<Entity> roots;
    Propagation<const Local, Placed> propagation;

    explicit Trees(const Arrays& arrays) {
        std::vector<Entity> entities;
        for (std::size_t i = 0; i < arrays.parents.size(); ++i) {
            if (arrays.parents[i] == Arrays::k_root) {
                entities.push_back(world.create(arrays.locals[i], Placed{}));
                roots.push_back(entities.back());
            } else {
                entities.push_back(
                    world.create(arrays.locals[i], Placed{}, Parent{entities[arrays.parents[i]]}));
            }
        }
        propagate();
    }

    void propagate() {
        propagation(
            world, [](const Local& local) { return Placed{local}; },
            [](const Placed& parent, const Local& local) { return product(parent, local); });
    }

    void touch_all() {
        for (auto [locals] : every_.chunks(world))
            benchmark::DoNotOptimize(locals.data());
    }

private:
    Query<Local> every_;
};

std::size_t trees_of(const benchmark::State& state) {
    return static_cast<std::size_t>(state.range(0)) / k_tree_nodes;
}

void count(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(trees_of(state) * k_tree_nodes));
}

template <auto make_arrays>
void bare(benchmark::State& state) {
    Arrays arrays = make_arrays(trees_of(state));
    for (auto _ : state) {
        arrays.propagate();
        benchmark::ClobberMemory();
    }
    count(state);
}

template <auto make_arrays, std::size_t Threads>
void rambla(benchmark::State& state) {
    const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, Threads};
    Trees trees{make_arrays(trees_of(state))};
    for (auto _ : state) {
        trees.touch_all();
        trees.propagate();
        benchmark::ClobberMemory();
    }
    count(state);
}

/// Every hundredth tree moves; the plain program does all trees all the same, as it knows no better.
template <auto make_arrays>
void bare_dirty(benchmark::State& state) {
    Arrays arrays = make_arrays(trees_of(state));
    float turn = 0.0f;
    for (auto _ : state) {
        turn += 1.0f;
        for (std::size_t i = 0, root = 0; i < arrays.parents.size(); ++i) {
            if (arrays.parents[i] == Arrays::k_root && root++ % 100 == 0) arrays.locals[i].m[9] = turn;
        }
        arrays.propagate();
        benchmark::ClobberMemory();
    }
    count(state);
}

template <auto make_arrays>
void rambla_dirty(benchmark::State& state) {
    const tbb::global_control one{tbb::global_control::max_allowed_parallelism, 1};
    Trees trees{make_arrays(trees_of(state))};
    float turn = 0.0f;
    for (auto _ : state) {
        turn += 1.0f;
        for (std::size_t i = 0; i < trees.roots.size(); i += 100)
            trees.world.get_mut<Local>(trees.roots[i]).m[9] = turn;
        trees.propagate();
        benchmark::ClobberMemory();
    }
    count(state);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
}

BENCHMARK(bare<Arrays::by_depth>)->Name("hierarchy/bare")->Apply(sizes);
BENCHMARK(rambla<Arrays::by_depth, 1>)->Name("hierarchy/rambla")->Apply(sizes);
BENCHMARK(rambla<Arrays::by_depth, 2>)->Name("hierarchy/rambla_2threads")->Apply(sizes)->UseRealTime();
BENCHMARK(bare<Arrays::by_tree>)->Name("hierarchy_by_tree/bare")->Apply(sizes);
BENCHMARK(rambla<Arrays::by_tree, 1>)->Name("hierarchy_by_tree/rambla")->Apply(sizes);
BENCHMARK(bare_dirty<Arrays::by_tree>)->Name("hierarchy_dirty_1_percent/bare")->Apply(sizes);
BENCHMARK(rambla_dirty<Arrays::by_tree>)->Name("hierarchy_dirty_1_percent/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs
