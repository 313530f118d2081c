#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "ecs/query.h"
#include "ecs/schedule.h"
#include "ecs/view.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"
#include "unit/ecs/paths.h"

namespace rambla::ecs {
namespace {

using namespace test;
using PropagationSkips = Paths;

TEST_F(PropagationSkips, EverythingWhenNothingChanged) {
    std::mt19937 engine{1};
    for (int i = 0; i < 50; ++i)
        tree(world, engine);
    EXPECT_EQ(propagate(), 50 * 85);
    EXPECT_EQ(propagate(), 0);
    world.create(Health{});  // rows elsewhere do not matter
    EXPECT_EQ(propagate(), 0);
}

TEST_F(PropagationSkips, TreesWhoseRootsDidNotMove) {
    std::mt19937 engine{1};
    std::vector<std::vector<Entity>> trees;
    for (int i = 0; i < 100; ++i)
        trees.push_back(tree(world, engine));
    propagate();
    world.get_mut<Step>(trees[40][0]).value += 1;
    // All roots share a chunk, so that all are looked at; only one has another result.
    EXPECT_EQ(propagate(), 100 + 84);
    world.get_mut<Step>(trees[40][0]).value += 0;
    EXPECT_EQ(propagate(), 100);
}

TEST_F(PropagationSkips, NoSubtreeThatGotAnotherParent) {
    const Entity a = root(1), b = root(2), middle = child(a, 3), leaf = child(middle, 4);
    propagate();
    world.get_mut<Parent>(middle).entity = b;
    propagate();
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({2}), {3}), {4}).value);
}

TEST_F(PropagationSkips, NoChangeThatMovedToAnotherRow) {
    const Entity a = root(1), b = root(2);
    propagate();
    world.get_mut<Step>(b).value = 9;
    world.destroy(a);  // b takes over its row
    propagate();
    EXPECT_EQ(path(b), of_root({9}).value);
    world.remove<Step>(b);
    world.add(b, Step{11});  // the same row again
    propagate();
    EXPECT_EQ(path(b), of_root({11}).value);
}

TEST_F(PropagationSkips, ChunksWithoutNewResultsWhenStamping) {
    const Entity quiet = child(root(1), 2);
    for (int i = 0; i < 2000; ++i)
        child(quiet, 3);
    propagate();
    const std::uint32_t before = world.version() - 1;
    world.get_mut<Step>(child(quiet, 3)).value = 4;
    propagate();
    Query<const Path, const Parent> query;
    std::vector<bool> changed;
    for (const auto& chunk : query.chunks(world))
        changed.push_back(chunk.changed_since<Path>(before));
    EXPECT_THAT(changed, ::testing::ElementsAre(false, true));
}

TEST_F(PropagationSkips, NothingAfterAFunctionThrew) {
    const Entity a = root(1), b = child(a, 2), leaf = child(b, 3);
    propagate();
    world.get_mut<Step>(a).value = 5;
    const auto refuse = [](const Path& parent, const Step& step) -> Path {
        if (step.value == 2) throw std::runtime_error{"refused"};
        return of_child(parent, step);
    };
    EXPECT_THROW(propagation(world, of_root, refuse), std::runtime_error);
    propagate();  // though a's result is not another one than the call that failed left
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({5}), {2}), {3}).value);
}

TEST_F(PropagationSkips, AllAllocationWhileTheStructureStays) {
    std::mt19937 engine{1};
    std::vector<std::vector<Entity>> trees;
    for (int i = 0; i < 200; ++i)
        trees.push_back(tree(world, engine));
    const Entity house = world.create(Path{1});
    child(house, 1);
    propagate();
    for (const bool everything : {false, true}) {
        world.get_mut<Step>(trees[3][0]).value += 1;
        world.get_mut<Path>(house).value += 1;
        Query<Step> steps;
        if (everything) steps.each(world, [](Step& step) { step.value += 1; });
        const std::size_t before = rambla::test::allocation_count();
        propagate();
        EXPECT_EQ(rambla::test::allocation_count(), before);
    }
}

TEST_F(PropagationSkips, NoLocalThatItsFunctionStillChanges) {
    Propagation<Step, Path> halving;
    const Entity entity = root(5), steady = root(0);
    int visits = 0;
    const auto halve = [&](Step& step) {
        ++visits;
        return Path{step.value /= 2};
    };
    for (int i = 0; i < 10; ++i)
        halving(world, halve, of_child);
    EXPECT_EQ(path(entity), 0u);
    EXPECT_EQ(path(steady), 0u);
    EXPECT_EQ(visits, 2 * 4) << "5, 2, 1, 0, and once more to see that it stays";
}

TEST_F(PropagationSkips, NothingThatOthersWroteInASharedRunOfASchedule) {
    const Entity top = root(1), below = child(top, 1);
    Schedule schedule;
    schedule.add("early", [](View<Step, Without<Parent>> steps) {
        for (const auto& chunk : steps.chunks())
            chunk.each([](Step& step) { ++step.value; });
    });
    schedule
        .add("propagate",
             [this](World& shared) {
                 EXPECT_EQ(&shared, &world);
                 propagate();
             })
        .after("early")
        .reads<Step, Parent>()
        .writes<Path>();
    schedule
        .add("late",
             [](View<Step, With<Parent>> steps) {
                 for (const auto& chunk : steps.chunks())
                     chunk.each([](Step& step) { ++step.value; });
             })
        .after("propagate");
    for (std::uint64_t run = 0; run < 5; ++run) {
        schedule.run(world);
        EXPECT_EQ(path(below), of_child(of_root({2 + run}), {1 + run}).value);
    }
}

}  // namespace
}  // namespace rambla::ecs
