#include "ecs/commands.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(Commands, DoNothingUntilApplied) {
    World world;
    const Entity entity = world.create(Position{});
    Commands commands;
    commands.add(entity, Health{3});
    commands.create(Position{});
    EXPECT_FALSE(world.has<Health>(entity));
    EXPECT_EQ(commands.size(), 2u);
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 2u);
    EXPECT_EQ(playback.dropped, 0u);
    EXPECT_EQ(world.get<Health>(entity).points, 3);
    EXPECT_EQ(world.entity_count(), 2u);
    EXPECT_TRUE(commands.empty());
}

TEST(Commands, CanBeRecordedWhileIterating) {
    World world;
    for (int i = 0; i < 3000; ++i)
        world.create(Health{i});
    Commands commands;
    Query<Entity, const Health> query;
    query.each(world, [&](Entity entity, const Health& health) {
        if (health.points % 3 == 0) commands.destroy(entity);
        if (health.points % 3 == 1) commands.add(entity, Frozen{});
        if (health.points % 3 == 2) commands.remove<Health>(entity);
        EXPECT_THROW(commands.apply(world), Misuse);
    });
    EXPECT_EQ(commands.apply(world).applied, 3000u);
    EXPECT_EQ(world.entity_count(), 2000u);
    EXPECT_EQ(query.count(world), 1000u);
    Query<With<Frozen>, const Health> frozen;
    frozen.each(world, [](const Health& health) { EXPECT_EQ(health.points % 3, 1); });
}

TEST(Commands, APlaceholderStandsForTheEntityToBe) {
    World world;
    world.destroy(world.create());  // so that indices and placeholders differ
    world.create();
    Commands commands;
    const Entity root = commands.create(Position{1, 0, 0});
    const Entity child = commands.create(Parent{root}, Health{1});
    const Entity doomed = commands.create(Health{2});
    commands.add(root, Velocity{2, 0, 0});
    const Entity late = commands.create();
    commands.add(late, Parent{child});
    commands.destroy(doomed);
    commands.apply(world);
    const Entity made = commands.created(root);
    EXPECT_TRUE(world.alive(made));
    EXPECT_EQ(world.get<Velocity>(made).x, 2.0f);
    EXPECT_EQ(world.get<Parent>(commands.created(child)).entity, made);
    EXPECT_EQ(world.get<Parent>(commands.created(late)).entity, commands.created(child));
    EXPECT_FALSE(world.alive(commands.created(doomed)));
    EXPECT_THROW((void)commands.created(Entity{4, 0}), Misuse);
    EXPECT_THROW((void)commands.created(made), Misuse);
    EXPECT_THROW((void)world.get<Position>(root), Misuse) << "a placeholder is no entity";
}

TEST(Commands, ApplyInTheOrderOfTheirRecording) {
    World world;
    const Entity entity = world.create();
    Commands commands;
    commands.add(entity, Health{1});
    commands.add(entity, Health{2});
    commands.remove<Health>(entity);
    commands.add(entity, Health{3});
    commands.apply(world);
    EXPECT_EQ(world.get<Health>(entity).points, 3);
}

TEST(Commands, CreateLandsDirectlyInTheFinalArchetype) {
    World world;
    Commands commands;
    commands.create(Position{}, Velocity{}, Frozen{}, Health{});
    commands.create();
    commands.apply(world);
    EXPECT_EQ(world.archetype_count(), 2u);
}

TEST(Commands, DropWhatHasNoTargetAndSaySo) {
    World world;
    const Entity entity = world.create(Health{});
    Commands commands;
    commands.destroy(entity);
    commands.destroy(entity);
    commands.add(entity, Anchored{1});
    commands.remove<Health>(entity);
    const Entity other = world.create();
    commands.remove<Health>(other);
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 1u);
    EXPECT_EQ(playback.dropped, 4u);
    EXPECT_EQ(Anchored::alive, 0) << "values that found no place end";
}

TEST(Commands, WhatGoesAndComesAgainInOnePlaybackIsEnabled) {
    for (const bool moves : {false, true}) {
        World world;
        const Entity entity = world.create(Light{1.0f});
        world.set_enabled<Light>(entity, false);
        Commands commands;
        commands.remove<Light>(entity);
        commands.add(entity, Light{2.0f});
        if (moves) commands.add(entity, Health{});
        commands.apply(world);
        EXPECT_EQ(world.get<Light>(entity).lux, 2.0f);
        EXPECT_TRUE(world.enabled<Light>(entity)) << moves;

        world.set_enabled<Light>(entity, false);
        commands.remove<Light>(entity);
        commands.add(entity, Light{});
        commands.remove<Light>(entity);
        commands.apply(world);
        EXPECT_FALSE(world.has<Light>(entity));

        world.add(entity, Light{});
        world.set_enabled<Light>(entity, false);
        commands.add(entity, Light{3.0f});
        commands.apply(world);
        EXPECT_FALSE(world.enabled<Light>(entity)) << "a value replaced switches nothing";
    }
}

TEST(Commands, MoveValuesThatKnowTheirAddress) {
    {
        World world;
        Commands commands;
        std::vector<Entity> placeholders;
        for (int i = 0; i < 5000; ++i) {
            placeholders.push_back(commands.create(Anchored{i}, Owner{std::make_unique<int>(i)}, Line{}));
        }
        commands.apply(world);
        for (int i = 0; i < 5000; ++i) {
            const Entity entity = commands.created(placeholders[static_cast<std::size_t>(i)]);
            ASSERT_TRUE(world.get<Anchored>(entity).intact());
            ASSERT_EQ(world.get<Anchored>(entity).number(), i);
            ASSERT_EQ(*world.get<Owner>(entity).value, i);
        }
        EXPECT_EQ(Anchored::alive, 5000);
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(Commands, ValuesGoToTheirRowsWhileOthersLeaveTheSameArchetype) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i)
        entities.push_back(world.create(Health{i}, Anchored{i}));
    Commands commands;
    commands.add(entities[2], Position{});
    commands.add(entities[9], Anchored{90});
    commands.add(entities[5], Health{50});
    commands.apply(world);
    for (int i = 0; i < 10; ++i) {
        const Entity entity = entities[static_cast<std::size_t>(i)];
        EXPECT_EQ(world.get<Health>(entity).points, i == 5 ? 50 : i);
        EXPECT_EQ(world.get<Anchored>(entity).number(), i == 9 ? 90 : i);
        EXPECT_TRUE(world.get<Anchored>(entity).intact());
    }
}

TEST(Commands, EndWhatWasNeverApplied) {
    {
        Commands commands;
        commands.create(Anchored{1}, Owner{std::make_unique<int>(1)});
        commands.clear();
        EXPECT_EQ(Anchored::alive, 0);
        commands.add(Entity{1, 1}, Anchored{2});
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(Commands, ChangeNothingWhenTheWorldIsFull) {
    World world{{.max_entities = 3}};
    const Entity entity = world.create(Health{1});
    Commands commands;
    commands.add(entity, Health{2});
    for (int i = 0; i < 3; ++i)
        commands.create(Anchored{i});
    EXPECT_THROW(commands.apply(world), CapacityExceeded);
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_EQ(world.get<Health>(entity).points, 1);
    EXPECT_EQ(Anchored::alive, 0);
    EXPECT_TRUE(commands.empty());
    commands.destroy(entity);
    for (int i = 0; i < 3; ++i)
        commands.create(Anchored{i});
    EXPECT_EQ(commands.apply(world).applied, 4u) << "those that leave make room first";
    Query<const Anchored> query;
    int next = 0;
    query.each(world, [&](const Anchored& anchored) { EXPECT_EQ(anchored.number(), next++); });
    EXPECT_EQ(next, 3);
}

TEST(Commands, ChangeNothingWhenAnArchetypeIsFull) {
    World world{{.max_rows_per_archetype = 16}};
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i) {
        entities.push_back(world.create(Health{i}));
        world.create(Health{}, Velocity{});
    }
    Commands commands;
    commands.destroy(entities[0]);
    for (int i = 1; i < 10; ++i)
        commands.add(entities[static_cast<std::size_t>(i)], Velocity{});
    EXPECT_THROW(commands.apply(world), CapacityExceeded);
    EXPECT_TRUE(commands.empty());
    for (Entity entity : entities)
        EXPECT_FALSE(world.has<Velocity>(entity));
}

TEST(Commands, ASteadyUseDoesNotAllocate) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 2000; ++i)
        entities.push_back(world.create(Position{}));
    Commands commands;
    const auto frame = [&] {
        for (Entity entity : entities)
            commands.add(entity, Velocity{1, 2, 3});
        for (int i = 0; i < 100; ++i)
            commands.destroy(commands.create(Position{}, Health{}));
        commands.apply(world);
        for (Entity entity : entities)
            commands.remove<Velocity>(entity);
        commands.apply(world);
    };
    frame();
    const std::size_t before = rambla::test::allocation_count();
    frame();
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

TEST(Commands, TwoWorldsFedTheSameAreTheSame) {
    const auto run = [] {
        World world;
        Commands commands;
        std::vector<Entity> order;
        for (int i = 0; i < 500; ++i) {
            const Entity placeholder = commands.create(Health{i});
            if (i % 3 == 0) commands.destroy(placeholder);
            if (i % 4 == 0) commands.add(placeholder, Frozen{});
        }
        commands.apply(world);
        for (int i = 0; i < 50; ++i)
            commands.create(Health{-i}, Frozen{});
        commands.apply(world);
        Query<Entity, const Health> query;
        query.each(world, [&](Entity entity, const Health&) { order.push_back(entity); });
        return order;
    };
    const std::vector<Entity> first = run();
    EXPECT_EQ(first.size(), 383u);
    EXPECT_EQ(run(), first);
}

}  // namespace
}  // namespace rambla::ecs
