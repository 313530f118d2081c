#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "ecs/propagation.h"
#include "ecs/world.h"

namespace rambla::ecs::test {

/// What an entity adds to its path.
struct Step {
    std::uint64_t value = 0;
};
/// Depends on all steps from the root down and on their order.
struct Path {
    std::uint64_t value = 0;
    bool operator==(const Path&) const = default;
};

inline Path of_root(const Step& step) {
    return {step.value + 1};
}
inline Path of_child(const Path& parent, const Step& step) {
    return {parent.value * 6364136223846793005u + step.value + 1};
}

/// A world of steps, and what is propagated through it.
struct Paths : ::testing::Test {
    World world;
    Propagation<const Step, Path> propagation;
    std::atomic<int> calls{0};

    /// Returns how many members were visited.
    int propagate() {
        calls = 0;
        propagation(
            world,
            [&](const Step& step) {
                ++calls;
                return of_root(step);
            },
            [&](const Path& parent, const Step& step) {
                ++calls;
                return of_child(parent, step);
            });
        return calls;
    }
    Entity root(std::uint64_t step) { return world.create(Step{step}, Path{}); }
    Entity child(Entity parent, std::uint64_t step) {
        return world.create(Step{step}, Path{}, Parent{parent});
    }
    [[nodiscard]] std::uint64_t path(Entity entity) const { return world.get<Path>(entity).value; }
};

/// Tries of 85: each node but the leaves has 4 children.
inline std::vector<Entity> tree(World& world, std::mt19937& engine) {
    std::vector<Entity> nodes{world.create(Step{engine() % 100}, Path{})};
    for (std::size_t i = 1; i < 85; ++i)
        nodes.push_back(world.create(Step{engine() % 100}, Path{}, Parent{nodes[(i - 1) / 4]}));
    return nodes;
}

}  // namespace rambla::ecs::test
