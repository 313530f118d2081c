#include "ecs/get_many.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// `count` entities in three archetypes, whose Health is their number.
std::vector<Entity> numbered(World& world, int count) {
    std::vector<Entity> entities;
    for (int i = 0; i < count; ++i) {
        entities.push_back(world.create(Health{i}));
        if (i % 3 == 1) world.add(entities.back(), Position{});
        if (i % 3 == 2) world.add(entities.back(), Frozen{});
    }
    return entities;
}

TEST(GetMany, HandsOutEveryValueInTheOrderOfTheList) {
    for (int count : {0, 1, 15, 16, 17, 31, 32, 33, 1000}) {  // around how far it looks ahead
        World world;
        std::vector<Entity> entities = numbered(world, count);
        std::vector<int> expected;
        for (int i = 0; i < count; ++i)
            expected.push_back(i);
        std::shuffle(expected.begin(), expected.end(), std::mt19937{1});
        std::vector<Entity> list;
        for (int number : expected)
            list.push_back(entities[static_cast<std::size_t>(number)]);
        std::vector<int> seen;
        world.get_many<Health>(list, [&](std::size_t i, const Health& health) {
            EXPECT_EQ(i, seen.size());
            seen.push_back(health.points);
        });
        EXPECT_EQ(seen, expected);
    }
}

TEST(GetMany, WritesAndCountsAsAChangeOfTheRowsChunks) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 3000; ++i)
        entities.push_back(world.create(Health{i}, Velocity{}));
    const std::uint32_t seen = world.advance_version();
    const std::vector<Entity> list{entities[2100], entities[5], entities[5]};
    world.get_many_mut<Health>(list,
                               [](std::size_t i, Health& health) { health.points += static_cast<int>(i); });
    EXPECT_EQ(world.get<Health>(entities[5]).points, 5 + 1 + 2) << "the same entity twice";
    Query<Changed<Health>> changed;
    EXPECT_EQ(changed.count(world, {seen}), 1024u + 3000u - 2048u);
    EXPECT_EQ((Query<Changed<Velocity>>{}.count(world, {seen})), 0u);
    const std::uint32_t later = world.advance_version();
    world.get_many<Health>(list, [](std::size_t, const Health&) {});
    EXPECT_EQ(changed.count(world, {later}), 0u) << "reading changes nothing";
}

TEST(GetMany, ReachesSparseValues) {
    World world;
    const std::vector<Entity> list{world.create(Burning{1}), world.create(Position{}, Burning{2})};
    int heat = 0;
    world.get_many_mut<Burning>(list, [](std::size_t, Burning& burning) { burning.heat *= 10; });
    world.get_many<Burning>(list, [&](std::size_t, const Burning& burning) { heat += burning.heat; });
    EXPECT_EQ(heat, 30);
}

TEST(GetMany, RefusesStaleHandlesMissingComponentsAndStructuralChanges) {
    World world;
    std::vector<Entity> entities = numbered(world, 100);
    const auto ignore = [](std::size_t, const auto&) {
    };
    EXPECT_THROW(world.get_many<Velocity>(entities, ignore), Misuse) << "never met";
    EXPECT_THROW(world.get_many<Position>(entities, ignore), Misuse) << "only some have it";
    EXPECT_THROW(
        world.get_many<Health>(entities, [&](std::size_t, const Health&) { world.destroy(entities[50]); }),
        Misuse);
    EXPECT_TRUE(world.alive(entities[50]));
    world.destroy(entities[99]);
    EXPECT_THROW(world.get_many<Health>(entities, ignore), Misuse);
    const std::vector<Entity> null{Entity{}};
    EXPECT_THROW(world.get_many<Health>(null, ignore), Misuse);
    EXPECT_NO_THROW(world.destroy(entities[0])) << "open again after an exception ended the walk";
}

}  // namespace
}  // namespace rambla::ecs
