#include "ecs/create_many.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(CreateMany, CopiesValuesIntoNewRows) {
    World world;
    const Entity before = world.create(Health{1}, Frozen{});
    const std::span<const Entity> made = create_many(world, 3000, Health{7}, Frozen{}, Line{{1, 2}});
    EXPECT_EQ(made.size(), 3000u);
    EXPECT_EQ(world.entity_count(), 3001u);
    for (Entity entity : made) {
        ASSERT_TRUE(world.has<Frozen>(entity));
        ASSERT_EQ(world.get<Health>(entity).points, 7);
        ASSERT_EQ(world.get<Line>(entity).values[1], 2.0f);
    }
    EXPECT_EQ(world.get<Health>(before).points, 1);
}

TEST(CreateMany, HandsOutStretchesWithinChunks) {
    World world;
    for (int i = 0; i < 1000; ++i)
        world.create(Health{-1}, Position{});
    std::vector<std::size_t> sizes;
    int next = 0;
    const std::span<const Entity> made = create_many_with<Position, Health>(
        world, 1100,
        [&](std::span<const Entity> entities, std::span<Position> places, std::span<Health> healths) {
            ASSERT_EQ(entities.size(), places.size());
            ASSERT_EQ(places[0], Position{});
            sizes.push_back(entities.size());
            for (Health& health : healths)
                health.points = next++;
            EXPECT_THROW(world.create(), Misuse) << "rows may not move meanwhile";
        });
    EXPECT_EQ(sizes, (std::vector<std::size_t>{24, 1024, 52}));
    for (std::size_t i = 0; i < made.size(); ++i)
        ASSERT_EQ(world.get<Health>(made[i]).points, static_cast<int>(i));
}

TEST(CreateMany, UsesTheSlotsThatCreateWouldUse) {
    const auto handles = [](bool many) {
        World world;
        std::vector<Entity> first;
        for (int i = 0; i < 100; ++i)
            first.push_back(world.create(Health{}));
        for (int i = 0; i < 100; i += 3)
            world.destroy(first[static_cast<std::size_t>(i)]);
        std::vector<Entity> made;
        if (many) {
            const std::span<const Entity> span = create_many(world, 60, Health{});
            made.assign(span.begin(), span.end());
        } else {
            for (int i = 0; i < 60; ++i)
                made.push_back(world.create(Health{}));
        }
        return made;
    };
    EXPECT_EQ(handles(true), handles(false));
}

TEST(CreateMany, ChangesNothingWhenTheWorldIsFull) {
    World world{{.max_entities = 10}};
    world.create(Health{});
    EXPECT_THROW(create_many(world, 10, Health{}), CapacityExceeded);
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_EQ(create_many(world, 9, Health{}).size(), 9u);
    EXPECT_TRUE(create_many(world, 0, Health{}).empty());
}

TEST(CreateMany, LeavesWholeEntitiesWhenFillThrows) {
    World world;
    EXPECT_THROW(create_many_with<Health>(
                     world, 2000,
                     [](std::span<const Entity>, std::span<Health>) { throw std::runtime_error{"fill"}; }),
                 std::runtime_error);
    EXPECT_EQ(world.entity_count(), 2000u);
    Query<const Health> query;
    query.each(world, [](const Health& health) { ASSERT_EQ(health.points, 0); });
    EXPECT_NO_THROW(world.create()) << "the walk is over";
}

TEST(DestroyMany, EndsEachOnceAndCountsTheRestAsDropped) {
    World world;
    const std::span<const Entity> span = create_many(world, 3000, Health{1});
    const std::vector<Entity> made{span.begin(), span.end()};
    Commands commands;
    commands.destroy_many(std::span{made}.first(2000));
    commands.destroy_many(std::span{made}.subspan(1500, 1000));
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 2500u);
    EXPECT_EQ(playback.dropped, 500u);
    EXPECT_EQ(world.entity_count(), 500u);
    for (std::size_t i = 0; i < made.size(); ++i)
        ASSERT_EQ(world.alive(made[i]), i >= 2500);
}

}  // namespace
}  // namespace rambla::ecs
