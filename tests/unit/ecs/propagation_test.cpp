#include "ecs/propagation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "unit/ecs/parts.h"
#include "unit/ecs/paths.h"

namespace rambla::ecs {
namespace {

using namespace test;
using PropagationTo = Paths;

TEST_F(PropagationTo, ChildrenComesAfterParentsInAnyOrderOfCreation) {
    const Entity grandchild = child({}, 3), middle = child({}, 2), top = root(1);
    world.get_mut<Parent>(grandchild).entity = middle;
    world.get_mut<Parent>(middle).entity = top;
    propagate();
    EXPECT_EQ(path(grandchild), of_child(of_child(of_root({1}), {2}), {3}).value);
}

TEST_F(PropagationTo, NullParentsMakeRoots) {
    const Entity entity = child({}, 4);
    propagate();
    EXPECT_EQ(path(entity), of_root({4}).value);
}

TEST_F(PropagationTo, ChainsOf100000) {
    std::vector<Entity> chain{root(0)};
    for (std::uint64_t i = 1; i <= 100'000; ++i)
        chain.push_back(child(chain.back(), i));
    propagate();
    Path expected = of_root({0});
    for (std::uint64_t i = 1; i <= 100'000; ++i)
        expected = of_child(expected, {i});
    EXPECT_EQ(path(chain.back()), expected.value);
    world.get_mut<Step>(chain[99'999]).value = 0;
    EXPECT_LE(propagate(), static_cast<int>(k_chunk_rows) + 2);
}

TEST_F(PropagationTo, AMillionChildrenOfOneRootOneByOne) {
    const Entity top = root(1);
    for (std::uint64_t i = 0; i < 1'000'000; ++i)
        child(top, i);
    EXPECT_EQ(propagate(), 1'000'001);
    for (std::uint64_t i = 0; i < 2000; ++i) {  // each costs a segment of the order, not the whole
        const Entity late = child(top, i);
        ASSERT_LE(propagate(), static_cast<int>(k_chunk_rows));
        ASSERT_EQ(path(late), of_child(of_root({1}), {i}).value);
    }
}

TEST_F(PropagationTo, ParentsThatAreNoMembersCountAsTheyAre) {
    const Entity house = world.create(Path{7});
    const Entity door = child(house, 1), handle = child(door, 2);
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({7}, {1}), {2}).value);
    world.get_mut<Path>(house).value = 8;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {2}).value);
    EXPECT_EQ(path(house), 8u);
    world.remove<Path>(house);
    world.get_mut<Step>(handle).value = 5;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {2}).value)
        << "rests while its parent has no result";
    world.add(house, Path{8});
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {5}).value) << "and catches up";
    world.add(house, Step{9});  // now a member, a root
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child(of_root({9}), {1}), {5}).value);
    world.remove<Step>(house);
    world.get_mut<Path>(house).value = 1;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({1}, {1}), {5}).value);
}

TEST_F(PropagationTo, EveryChildOfAParentOutsideThatRests) {
    const Entity outside = world.create(Path{7});
    const Entity a = child(outside, 1);
    propagate();
    // All rows have something to do while what they hang from has not: the segment is written as a whole.
    for (const std::uint64_t step : {2u, 3u}) {
        world.get_mut<Step>(a).value = step;
        EXPECT_EQ(propagate(), 1);
        EXPECT_EQ(path(a), of_child({7}, Step{step}).value);
    }
    EXPECT_EQ(path(outside), 7u);
}

TEST_F(PropagationTo, OrphansRest) {
    const Entity top = root(1), middle = child(top, 2), leaf = child(middle, 3);
    propagate();
    const std::uint64_t before = path(leaf);
    world.destroy(top);
    world.get_mut<Step>(leaf).value = 9;
    propagate();
    EXPECT_EQ(path(leaf), before);
    const Entity other = root(5);
    world.get_mut<Parent>(middle).entity = other;
    propagate();
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({5}), {2}), {9}).value);
}

TEST_F(PropagationTo, AParentWhoseNumberIsUsedAgainIsDead) {
    const Entity first = root(1), orphan = child(first, 2);
    propagate();
    const std::uint64_t before = path(orphan);
    world.destroy(first);
    const Entity second = root(50);
    ASSERT_EQ(second.index, first.index);
    propagate();
    EXPECT_EQ(path(orphan), before);
    world.get_mut<Parent>(orphan).entity = second;
    propagate();
    EXPECT_EQ(path(orphan), of_child(of_root({50}), {2}).value);
}

TEST_F(PropagationTo, RingsRestWithWhatHangsFromThem) {
    const Entity a = child({}, 1), b = child(a, 2), below = child(b, 3), self = child({}, 4);
    world.get_mut<Parent>(a).entity = b;
    world.get_mut<Parent>(self).entity = self;
    const Entity apart = root(5);
    propagate();
    EXPECT_EQ(path(below), 0u);
    EXPECT_EQ(path(self), 0u);
    EXPECT_EQ(path(apart), of_root({5}).value);
    world.get_mut<Parent>(a).entity = {};
    propagate();
    EXPECT_EQ(path(below), of_child(of_child(of_root({1}), {2}), {3}).value);
}

TEST_F(PropagationTo, HandlesOfAnotherWorldMeanWhateverHasTheirNumberHere) {
    World other;
    const Entity stranger = other.create();
    const Entity nobody_here = child(stranger, 1);  // is number 0 itself: its own parent
    propagate();
    EXPECT_EQ(path(nobody_here), 0u);
    const Entity beyond = child({12'345'678, 3}, 1);
    propagate();
    EXPECT_EQ(path(beyond), 0u);
}

TEST_F(PropagationTo, SeveralWorldsInTurn) {
    const Entity here = child(root(1), 2);
    propagate();
    World there;
    const Entity other = there.create(Step{8}, Path{});
    propagation(there, of_root, of_child);
    EXPECT_EQ(there.get<Path>(other).value, of_root({8}).value);
    world.get_mut<Step>(here).value = 3;
    propagate();
    EXPECT_EQ(path(here), of_child(of_root({1}), {3}).value);
}

TEST_F(PropagationTo, ResultsThatAreNotNumbersHarmOnlyWhatHangsFromThem) {
    World numbers;
    Propagation<const Position, Velocity> positions;
    const float bad = std::numeric_limits<float>::quiet_NaN();
    const Entity root = numbers.create(Position{bad, 0, 1}, Velocity{});
    const Entity child = numbers.create(Position{1, 0, 1}, Velocity{}, Parent{root});
    const Entity apart = numbers.create(Position{1, 2, 3}, Velocity{});
    const auto place = [&] {
        positions(
            numbers,
            [](const Position& p) {
                return Velocity{p.x, p.y, p.z};
            },
            [](const Velocity& v, const Position& p) {
                return Velocity{v.x * p.x, v.y * p.y, v.z * p.z};
            });
    };
    place();
    place();
    EXPECT_TRUE(std::isnan(numbers.get<Velocity>(child).x));
    EXPECT_EQ(numbers.get<Velocity>(child).y, 0.0f);
    EXPECT_EQ(numbers.get<Velocity>(apart), (Velocity{1, 2, 3}));
}

TEST_F(PropagationTo, TermsFilterAndReachTheFunctions) {
    Propagation<Step, Path, With<Frozen>, Optional<Health>, const Byte> with_terms;
    const Entity top = world.create(Step{1}, Path{}, Frozen{}, Byte{10});
    const Entity below = world.create(Step{2}, Path{}, Frozen{}, Byte{20}, Health{5}, Parent{top});
    const Entity left_out = root(3);
    with_terms(
        world,
        [](Step& step, Health* health, const Byte& byte) {
            EXPECT_EQ(health, nullptr);
            ++step.value;
            return Path{byte.value};
        },
        [](const Path& parent, Step& step, Health* health, const Byte& byte) {
            ++step.value;
            return Path{parent.value + byte.value + static_cast<std::uint64_t>(health->points++)};
        });
    EXPECT_EQ(path(below), 35u);
    EXPECT_EQ(world.get<Health>(below).points, 6);
    EXPECT_EQ(world.get<Step>(top).value, 2u);
    EXPECT_EQ(path(left_out), 0u);
}

}  // namespace
}  // namespace rambla::ecs
