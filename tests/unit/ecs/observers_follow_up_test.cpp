#include <gtest/gtest.h>

#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "ecs/create_many.h"
#include "ecs/observers.h"
#include "support/allocation_counter.h"
#include "unit/ecs/diary.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(ObserversFollowUp, RecordCommandsThatArePlayedAfterwards) {
    World world;
    Diary diary{world};
    world.observers().on_add<Burning>([&](Entity entity, const Burning& burning, Commands& commands) {
        EXPECT_THROW(world.add(entity, Frozen{}), Misuse);
        if (world.has<Frozen>(entity)) commands.remove<Frozen>(entity);
        commands.add(commands.create(Health{burning.heat}), Position{});
    });
    world.observers().on_remove<Frozen>([](Entity entity, Commands& commands) { commands.destroy(entity); });
    const Entity entity = world.create(Frozen{});
    Commands commands;
    commands.add(entity, Burning{3});
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 1u) << "of the recording itself";
    EXPECT_EQ(diary.read(), "+f 0, +b 3, -f 0, +h 3, -b 3");
    EXPECT_FALSE(world.alive(entity));
    EXPECT_EQ(world.entity_count(), 1u);

    world.add(world.create(), Burning{4});
    EXPECT_EQ(diary.read(), "+b 4, +h 4") << "the same after a direct change";
    EXPECT_EQ(world.entity_count(), 3u);
}

TEST(ObserversFollowUp, ThatCauseEachOtherWithoutEndAreStopped) {
    World world;
    int calls = 0;
    world.observers().on_add<Health>([&](Entity, const Health& health, Commands& commands) {
        ++calls;
        commands.create(Health{health.points + 1});
    });
    try {
        world.create(Health{0});
        ADD_FAILURE() << "no end was set";
    } catch (const Misuse& misuse) {
        EXPECT_NE(std::string{misuse.what()}.find("on_add<rambla::ecs::test::Health>"), std::string::npos)
            << misuse.what();
    }
    EXPECT_EQ(calls, static_cast<int>(Observers::k_cascade_limit) + 1);
    EXPECT_EQ(world.entity_count(), Observers::k_cascade_limit + 1u) << "what was played stays";
    world.create(Position{});
    EXPECT_EQ(world.entity_count(), Observers::k_cascade_limit + 2u) << "nothing is left to be played";
}

TEST(ObserversFollowUp, MayCauseAsManyPlaybacksInARowAsTheLimitSays) {
    World world;
    world.observers().on_add<Health>([&](Entity, const Health& health, Commands& commands) {
        if (health.points != 0) commands.create(Health{health.points - 1});
    });
    EXPECT_NO_THROW(world.create(Health{static_cast<int>(Observers::k_cascade_limit)}));
    EXPECT_EQ(world.entity_count(), Observers::k_cascade_limit + 1u);
}

TEST(ObserversFollowUp, ThatThrowLeaveTheChangeMadeAndTheRestUncalled) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 4; ++i)
        entities.push_back(world.create(Health{i}));
    int removals = 0;
    int additions = 0;
    world.observers().on_remove<Health>([&](Entity, const Health& health, Commands& commands) {
        ++removals;
        commands.create(Position{});
        if (health.points == 1) throw std::runtime_error{"no"};
    });
    world.observers().on_add<Frozen>([&](Entity) { ++additions; });
    Commands commands;
    for (Entity entity : entities)
        commands.remove<Health>(entity);
    const Entity made = commands.create(Frozen{});
    commands.add_to_all<Velocity>({});
    EXPECT_THROW(commands.apply(world), std::runtime_error);
    EXPECT_EQ(removals, 2);
    EXPECT_EQ(additions, 0);
    for (Entity entity : entities) {
        EXPECT_FALSE(world.has<Health>(entity));
        EXPECT_TRUE(world.has<Velocity>(entity)) << "the recording is played to its end";
    }
    EXPECT_EQ(world.entity_count(), 5u) << "what observers recorded is dropped";
    EXPECT_TRUE(world.alive(commands.created(made)));
    EXPECT_TRUE(commands.empty());

    const Entity next = world.create(Health{1});
    EXPECT_THROW(world.destroy(next), std::runtime_error);
    EXPECT_FALSE(world.alive(next));
    world.create(Frozen{});
    EXPECT_EQ(additions, 1) << "and all goes on";
}

TEST(ObserversFollowUp, ChangeNothingThemselves) {
    World world;
    const Entity entity = world.create(Position{});
    const Entity victim = world.create(Position{});
    int calls = 0;
    ObserverId id;
    id = world.observers().on_add<Health>([&](Entity, const Health&) {
        ++calls;
        Commands commands;
        commands.destroy(victim);
        EXPECT_THROW(world.create(), Misuse);
        EXPECT_THROW(world.create(Frozen{}), Misuse);
        EXPECT_THROW(world.destroy(victim), Misuse);
        EXPECT_THROW(world.add(victim, Health{}), Misuse);
        EXPECT_THROW(world.add(victim, Material{}), Misuse);
        EXPECT_THROW(world.remove<Position>(victim), Misuse);
        EXPECT_THROW((void)create_many(world, 2, Health{}), Misuse);
        EXPECT_THROW(commands.apply(world), Misuse);
        EXPECT_THROW(world.observers().end(id), Misuse);
        EXPECT_THROW(world.observers().on_add<Frozen>([](Entity) {}), Misuse);
        world.get_mut<Position>(victim).x = 5;
        World other;
        other.create(Health{});
    });
    world.add(entity, Health{1});
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(world.get<Position>(victim).x, 5.0f);
    EXPECT_EQ(world.entity_count(), 2u);
}

TEST(ObserversFollowUp, AreNotToldOfTheWorldsEnd) {
    int calls = 0;
    {
        World world;
        world.observers().on_remove<Health>([&](Entity, const Health&) { ++calls; });
        world.create(Health{});
    }
    EXPECT_EQ(calls, 0);
}

TEST(ObserversFollowUp, AreNotToldOfWhatFails) {
    World world{{.max_rows_per_archetype = 16}};
    std::vector<Entity> entities;
    for (int i = 0; i < 16; ++i)
        world.create(Health{}, Position{});
    const Entity entity = world.create(Health{});
    const Entity target = world.create(Burning{1});
    const Entity stuck = world.create(Health{}, Position{}, Frozen{});
    Diary diary{world};
    EXPECT_THROW(world.add(entity, Position{}), CapacityExceeded);
    EXPECT_THROW(world.remove<Frozen>(stuck), CapacityExceeded);
    EXPECT_THROW(world.create(Health{}, Position{}), CapacityExceeded);
    EXPECT_THROW(world.add(Entity{99, 1}, Health{}), Misuse);
    EXPECT_THROW(world.remove<Frozen>(entity), Misuse);
    Commands commands;
    commands.destroy(target);
    commands.create(Health{}, Position{});
    EXPECT_THROW(commands.apply(world), CapacityExceeded);
    EXPECT_EQ(diary.read(), "");
    world.remove<Burning>(target);
    EXPECT_EQ(diary.read(), "-b 1");
}

TEST(ObserversFollowUp, AreToldOfAnEntityOnlyIfAllOfItCouldBeMade) {
    int failures = 0;
    for (std::size_t number = 0; number < 100; ++number) {
        World world;
        int balance = 0;
        world.observers().on_add<Health>([&](Entity, const Health&) { ++balance; });
        world.observers().on_remove<Health>([&](Entity, const Health&) { --balance; });
        world.create(Health{});
        balance = 0;
        const rambla::test::FailingAllocation failing{number};
        bool made = true;
        try {
            world.create(Health{}, SparseAnchored{1});
        } catch (const std::bad_alloc&) {
            made = false;
            ++failures;
        }
        EXPECT_EQ(balance, made ? 1 : 0) << number;
        if (!failing.happened()) break;
    }
    EXPECT_GT(failures, 3);
}

TEST(ObserversFollowUp, AllocateNothingInASteadyState) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 500; ++i)
        entities.push_back(world.create(Position{}));
    std::size_t calls = 0;
    world.observers().on_add<Health>([&](Entity entity, const Health&, Commands& commands) {
        ++calls;
        commands.add(entity, Burning{1});
    });
    world.observers().on_remove<Burning>([&](Entity, const Burning&) { ++calls; });
    Commands commands;
    const auto turn = [&] {
        for (Entity entity : entities)
            commands.add(entity, Health{1});
        commands.apply(world);
        for (Entity entity : entities) {
            commands.remove<Health>(entity);
            commands.remove<Burning>(entity);
        }
        commands.apply(world);
    };
    turn();
    turn();
    const std::size_t before = rambla::test::allocation_count();
    turn();
    EXPECT_EQ(rambla::test::allocation_count(), before);
    EXPECT_EQ(calls, 3000u);
}

}  // namespace
}  // namespace rambla::ecs
