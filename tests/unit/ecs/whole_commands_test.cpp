#include "ecs/whole_commands.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/commands.h"
#include "ecs/parent.h"
#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// 3000 with Health, so that columns have reservations; every third is Frozen, every fifth has a Velocity.
std::vector<Entity> fill(World& world) {
    std::vector<Entity> entities;
    for (int i = 0; i < 3000; ++i) {
        entities.push_back(world.create(Health{i}, Owner{std::make_unique<int>(i)}));
        if (i % 3 == 0) world.add(entities.back(), Frozen{});
        if (i % 5 == 0) world.add(entities.back(), Velocity{1, 1, 1});
    }
    return entities;
}

void expect_whole(World& world, const std::vector<Entity>& entities) {
    for (int i = 0; i < 3000; ++i) {
        const Entity entity = entities[static_cast<std::size_t>(i)];
        ASSERT_EQ(world.get<Health>(entity).points, i);
        ASSERT_EQ(*world.get<Owner>(entity).value, i);
    }
}

TEST(WholeCommands, GiveAComponentToAllThatFit) {
    World world;
    const std::vector<Entity> entities = fill(world);
    Commands commands;
    commands.add_to_all<Velocity, With<Health>, Without<Frozen>>({7, 8, 9});
    EXPECT_EQ(commands.apply(world).applied, 1u);
    expect_whole(world, entities);
    for (int i = 0; i < 3000; ++i) {
        const Velocity* velocity = world.try_get<Velocity>(entities[static_cast<std::size_t>(i)]);
        ASSERT_EQ(velocity != nullptr, i % 3 != 0 || i % 5 == 0) << i;
        if (velocity == nullptr) continue;
        ASSERT_EQ(*velocity, (i % 3 != 0 ? Velocity{7, 8, 9} : Velocity{1, 1, 1})) << i;
    }
}

TEST(WholeCommands, GoThereAndBackAndLeaveRoomToGrow) {
    World world;
    std::vector<Entity> entities = fill(world);
    Commands commands;
    for (int round = 0; round < 3; ++round) {
        commands.add_to_all<Position>({1, 2, 3});
        commands.add_to_all<Hidden>();
        commands.apply(world);
        expect_whole(world, entities);
        ASSERT_EQ(world.get<Position>(entities[2999]), (Position{1, 2, 3}));
        commands.remove_from_all<Position, With<Hidden>>();
        commands.remove_from_all<Hidden>();
        commands.apply(world);
        expect_whole(world, entities);
        ASSERT_FALSE(world.has<Position>(entities[0]));
        // The archetypes gave their columns away and got others: they must grow as before.
        for (int i = 0; i < 5000; ++i)
            world.create(Health{-1}, Owner{std::make_unique<int>(-1)}, Position{4, 5, 6});
        for (int i = 0; i < 5000; ++i)
            world.create(Health{-1}, Owner{std::make_unique<int>(-1)});
        Query<const Health, const Position> placed;
        placed.each(world, [](const Health& health, const Position& position) {
            ASSERT_EQ(health.points, -1);
            ASSERT_EQ(position, (Position{4, 5, 6}));
        });
        commands.destroy_all<With<Position>>();
        commands.apply(world);
        ASSERT_EQ(placed.count(world), 0u);
        std::vector<Entity> made;
        Query<Entity, const Health> all;
        all.each(world, [&](Entity entity, const Health& health) {
            if (health.points < 0) made.push_back(entity);
        });
        for (Entity entity : made)
            world.destroy(entity);
    }
    EXPECT_EQ(world.entity_count(), 3000u);
}

TEST(WholeCommands, StandWhereTheyWereRecordedAmongOthers) {
    World world;
    const Entity entity = world.create(Health{1});
    Commands commands;
    commands.add(entity, Velocity{1, 0, 0});
    const Entity early = commands.create(Health{2});
    commands.add_to_all<Velocity, With<Health>>({2, 0, 0});
    commands.add(early, Frozen{});
    commands.add(early, Parent{early});
    const Entity late = commands.create(Health{3});
    EXPECT_EQ(commands.apply(world).applied, 6u);
    EXPECT_EQ(world.get<Velocity>(entity).x, 2.0f);
    EXPECT_EQ(world.get<Velocity>(commands.created(early)).x, 2.0f);
    EXPECT_TRUE(world.has<Frozen>(commands.created(early)));
    EXPECT_EQ(world.get<Parent>(commands.created(early)).entity, commands.created(early));
    EXPECT_FALSE(world.has<Velocity>(commands.created(late)));
}

TEST(WholeCommands, EndWhatTheyTakeAway) {
    World world;
    for (int i = 0; i < 2000; ++i)
        world.create(Anchored{i}, Health{i});
    Commands commands;
    commands.remove_from_all<Anchored>();
    commands.apply(world);
    EXPECT_EQ(Anchored::alive, 0);
    EXPECT_EQ(world.entity_count(), 2000u);
    for (int i = 0; i < 2000; ++i)
        world.create(Anchored{i});
    commands.destroy_all<With<Anchored>>();
    commands.apply(world);
    EXPECT_EQ(Anchored::alive, 0);
    EXPECT_EQ(world.entity_count(), 2000u);
}

TEST(WholeCommands, CountAsAChangeOfWhatTheyTouch) {
    World world;
    for (int i = 0; i < 2000; ++i)
        world.create(Health{i}, Velocity{});
    Query<const Velocity> query;
    const std::uint32_t seen = world.advance_version();
    Commands commands;
    commands.add_to_all<Velocity>({3, 0, 0});
    commands.apply(world);
    std::size_t chunks = 0;
    for (const auto& chunk : query.chunks(world)) {
        EXPECT_TRUE(chunk.changed_since<Velocity>(seen));
        ++chunks;
    }
    EXPECT_EQ(chunks, 2u);
}

TEST(WholeCommands, ASteadyUseDoesNotAllocate) {
    World world;
    fill(world);
    Commands commands;
    const auto frame = [&] {
        commands.add_to_all<Position, With<Health>>({1, 2, 3});
        commands.apply(world);
        commands.remove_from_all<Position>();
        commands.apply(world);
    };
    frame();
    frame();
    const std::size_t before = rambla::test::allocation_count();
    frame();
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

TEST(WholeCommands, DoNotMixUpSparseValuesOfEntitiesCreatedAroundThem) {
    World world;
    Commands commands;
    const Entity before = commands.create(Burning{1});
    commands.add_to_all<Frozen>();
    const Entity behind = commands.create(Burning{2});
    commands.apply(world);
    EXPECT_EQ(world.get<Burning>(commands.created(before)).heat, 1);
    EXPECT_EQ(world.get<Burning>(commands.created(behind)).heat, 2);
    EXPECT_TRUE(world.has<Frozen>(commands.created(before)));
    EXPECT_FALSE(world.has<Frozen>(commands.created(behind)));
}

TEST(WholeCommands, LeaveEnableBitsAsTheyWere) {
    for (const int count : {200, 1000}) {  // in a block of the pool, and in columns that change hands
        World world;
        std::vector<Entity> entities;
        for (int i = 0; i < count; ++i) {
            entities.push_back(world.create(Light{}));
            world.set_enabled<Light>(entities.back(), i % 3 != 0);
        }
        Commands commands;
        commands.add_to_all<Health>({7});
        commands.apply(world);
        for (int i = 0; i < count; ++i)
            ASSERT_EQ(world.enabled<Light>(entities[static_cast<std::size_t>(i)]), i % 3 != 0) << i;
    }
}

TEST(WholeCommands, ColumnsThatChangedHandsKeepTheirRowsWhenMemoryIsGivenBack) {
    // Health begins 960 bytes into its range as third column, 320 as first: with so many rows it ends just
    // behind a page's end, and just before one if it is taken to begin where a first column does.
    constexpr int k_rows = 3920;
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < k_rows; ++i)
        entities.push_back(world.create(Position{}, Velocity{}, Health{i}, Line{}));
    Commands commands;
    commands.remove_from_all<Position>();
    commands.remove_from_all<Velocity>();
    commands.apply(world);
    world.compact();
    for (int i = 0; i < 1024; ++i)
        world.create(Health{-1}, Line{});
    for (int i = 0; i < k_rows; ++i)
        ASSERT_EQ(world.get<Health>(entities[static_cast<std::size_t>(i)]).points, i);
}

TEST(WholeCommands, PlaceholdersInTheirValuesAreThoseOfTheirRecording) {
    World world;
    world.create(Health{1});
    CommandQueue queue;
    queue.recording({0, 0}).create(Byte{100});
    Commands& second = queue.recording({0, 1});
    const Entity made = second.create(Byte{200});
    second.add_to_all<Parent, With<Health>>({made});
    queue.apply(world);
    Query<const Parent> query;
    query.each(world, [&](const Parent& parent) { EXPECT_EQ(world.get<Byte>(parent.entity).value, 200); });
    EXPECT_EQ(query.count(world), 1u);
}

}  // namespace
}  // namespace rambla::ecs
