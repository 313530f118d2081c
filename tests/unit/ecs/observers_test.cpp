#include "ecs/observers.h"

#include <gtest/gtest.h>

#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/create_many.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Writes down what observers of Health, Burning and Frozen are told: "+h 3" for an entity that gets 3
/// points.
class Diary {
public:
    explicit Diary(World& world) {
        Observers& observers = world.observers();
        observers.on_add<Health>([this](Entity, const Health& health) { note("+h", health.points); });
        observers.on_set<Health>([this](Entity, const Health& health) { note("=h", health.points); });
        observers.on_remove<Health>([this](Entity, const Health& health) { note("-h", health.points); });
        observers.on_add<Burning>([this](Entity, const Burning& burning) { note("+b", burning.heat); });
        observers.on_set<Burning>([this](Entity, const Burning& burning) { note("=b", burning.heat); });
        observers.on_remove<Burning>([this](Entity, const Burning& burning) { note("-b", burning.heat); });
        observers.on_add<Frozen>([this](Entity entity) { note("+f", static_cast<int>(entity.index)); });
        observers.on_remove<Frozen>([this](Entity entity) { note("-f", static_cast<int>(entity.index)); });
    }

    /// What was noted since the last call, in one line.
    std::string read() { return std::exchange(text_, {}); }

private:
    void note(const char* what, int number) {
        if (!text_.empty()) text_ += ", ";
        text_.append(what).append(" ").append(std::to_string(number));
    }

    std::string text_;
};

TEST(Observers, AreToldOfDirectChangesAtOnce) {
    World world;
    Diary diary{world};
    const Entity entity = world.create(Health{1}, Position{});
    EXPECT_EQ(diary.read(), "+h 1");
    world.add(entity, Health{2});
    EXPECT_EQ(diary.read(), "=h 2");
    world.add(entity, Burning{3});
    world.add(entity, Burning{4});
    world.add(entity, Frozen{});
    world.add(entity, Frozen{});
    EXPECT_EQ(diary.read(), "+b 3, =b 4, +f 0") << "a tag that is there already does not come";
    world.remove<Health>(entity);
    world.remove<Burning>(entity);
    world.remove<Frozen>(entity);
    EXPECT_EQ(diary.read(), "-h 2, -b 4, -f 0");
    world.add(entity, Velocity{});
    world.remove<Velocity>(entity);
    world.get_mut<Position>(entity).x = 1;
    EXPECT_EQ(diary.read(), "") << "nobody observes these";
}

TEST(Observers, AreToldOfAllComponentsThatEndWithAnEntity) {
    World world;
    Diary diary{world};
    const Entity one = world.create(Burning{7}, Frozen{}, Health{5}, Position{});
    const Entity two = world.create(Health{6});
    EXPECT_EQ(diary.read(), "+h 5, +b 7, +f 0, +h 6");
    world.destroy(one);
    EXPECT_EQ(diary.read(), "-h 5, -b 7, -f 0");
    world.destroy(two);
    EXPECT_EQ(diary.read(), "-h 6");
}

TEST(Observers, SeeWhatAPlaybackComesDownTo) {
    World world;
    const Entity bare = world.create(Position{});
    const Entity healthy = world.create(Health{1}, Burning{1});
    Diary diary{world};
    Commands commands;
    commands.add(bare, Health{2});
    commands.remove<Health>(bare);
    commands.add(bare, Burning{2});
    commands.remove<Burning>(bare);
    commands.apply(world);
    EXPECT_EQ(diary.read(), "") << "what comes and goes was never there";

    commands.remove<Health>(healthy);
    commands.add(healthy, Health{3});
    commands.remove<Burning>(healthy);
    commands.add(healthy, Burning{3});
    commands.apply(world);
    EXPECT_EQ(diary.read(), "=h 3, =b 3") << "what goes and comes again is set";

    commands.add(healthy, Health{4});
    commands.add(healthy, Health{5});
    commands.add(healthy, Frozen{});
    commands.apply(world);
    EXPECT_EQ(diary.read(), "+f 1, =h 5");

    commands.add(healthy, Health{6});
    commands.destroy(healthy);
    const Entity short_lived = commands.create(Health{7}, Burning{7});
    commands.destroy(short_lived);
    commands.apply(world);
    EXPECT_EQ(diary.read(), "-h 5, -b 3, -f 1") << "the last value that was really there";
}

TEST(Observers, AreToldOfRemovalsThenAdditionsThenSetsInTheOrderOfRows) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 4; ++i)
        entities.push_back(world.create(Health{i}));
    const Entity other = world.create(Position{}, Health{4});
    Diary diary{world};
    Commands commands;
    const Entity made = commands.create(Health{20}, Frozen{});
    commands.add(made, Burning{21});
    commands.add(other, Health{14});
    commands.remove<Health>(entities[3]);
    commands.add(entities[2], Health{12});
    commands.destroy(entities[1]);
    commands.add(entities[3], Burning{13});
    commands.add(entities[0], Burning{10});
    commands.apply(world);
    EXPECT_EQ(diary.read(), "-h 1, -h 3, +h 20, +b 10, +b 13, +b 21, +f 1, =h 12, =h 14");
}

TEST(Observers, OfWholeArchetypesAreToldOfEveryEntity) {
    World world;
    world.create(Health{1});
    world.create(Health{2}, Burning{2});
    world.create(Position{});
    Diary diary{world};
    Commands commands;
    commands.add_to_all<Frozen, With<Health>>();
    commands.add_to_all<Health>({9});
    commands.remove_from_all<Frozen>();
    commands.destroy_all();
    commands.apply(world);
    EXPECT_EQ(diary.read(), "+f 0, +f 1, +h 9, =h 9, =h 9, -f 0, -f 1, -h 9, -h 9, -h 9, -b 2");
}

TEST(Observers, OfSharedValuesSeeThemChange) {
    World world;
    std::string text;
    world.observers().on_add<Material>(
        [&](Entity, const Material& m) { text.append("+").append(std::to_string(m.number)); });
    world.observers().on_set<Material>(
        [&](Entity, const Material& m) { text.append("=").append(std::to_string(m.number)); });
    world.observers().on_remove<Material>(
        [&](Entity, const Material& m) { text.append("-").append(std::to_string(m.number)); });
    const Entity entity = world.create(Material{1}, Health{});
    world.add(entity, Material{1});
    world.add(entity, Material{2});
    Commands commands;
    commands.add(entity, Material{2});
    commands.apply(world);
    commands.add(entity, Material{3});
    commands.apply(world);
    commands.remove<Material>(entity);
    commands.apply(world);
    world.add(entity, Material{4});
    world.destroy(entity);
    EXPECT_EQ(text, "+1=2=3-3+4-4");
}

TEST(Observers, SeeFinalValuesInTheirPlacesAndOldOnesBeforeTheyEnd) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 3000; ++i)
        entities.push_back(world.create(Anchored{i}));
    int added = 0;
    int removed = 0;
    world.observers().on_add<Health>([&](Entity entity, const Health& health) {
        EXPECT_EQ(&world.get<Health>(entity), &health);
        EXPECT_TRUE(world.get<Anchored>(entity).intact());
        EXPECT_EQ(world.get<Anchored>(entity).number(), health.points);
        EXPECT_EQ(world.entity_count(), 2000u) << "the whole playback is made";
        ++added;
    });
    world.observers().on_remove<Anchored>([&](Entity entity, const Anchored& anchored) {
        EXPECT_EQ(&world.get<Anchored>(entity), &anchored);
        EXPECT_TRUE(anchored.intact());
        EXPECT_EQ(entities[static_cast<std::size_t>(anchored.number())], entity);
        EXPECT_EQ(world.entity_count(), 3000u);
        ++removed;
    });
    Commands commands;
    for (int i = 0; i < 3000; ++i) {
        if (i % 3 == 0) commands.destroy(entities[static_cast<std::size_t>(i)]);
        if (i % 3 == 1) commands.add(entities[static_cast<std::size_t>(i)], Health{i});
    }
    commands.apply(world);
    EXPECT_EQ(added, 1000);
    EXPECT_EQ(removed, 1000);
}

TEST(Observers, RecordCommandsThatArePlayedAfterwards) {
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

TEST(Observers, ThatCauseEachOtherWithoutEndAreStopped) {
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

TEST(Observers, MayCauseAsManyPlaybacksInARowAsTheLimitSays) {
    World world;
    world.observers().on_add<Health>([&](Entity, const Health& health, Commands& commands) {
        if (health.points != 0) commands.create(Health{health.points - 1});
    });
    EXPECT_NO_THROW(world.create(Health{static_cast<int>(Observers::k_cascade_limit)}));
    EXPECT_EQ(world.entity_count(), Observers::k_cascade_limit + 1u);
}

TEST(Observers, ThatThrowLeaveTheChangeMadeAndTheRestUncalled) {
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

TEST(Observers, ChangeNothingThemselves) {
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

TEST(Observers, EndWhenToldTo) {
    World world;
    std::string text;
    Observers& observers = world.observers();
    const ObserverId first = observers.on_add<Frozen>([&](Entity) { text += "a"; });
    const ObserverId second = observers.on_add<Frozen>([&](Entity) { text += "b"; });
    world.create(Frozen{});
    EXPECT_EQ(text, "ab") << "in the order in which they were added";
    observers.end(first);
    world.create(Frozen{});
    EXPECT_EQ(text, "abb");
    EXPECT_THROW(observers.end(first), Misuse);
    EXPECT_EQ(observers.size(), 1u);
    observers.end(second);
    world.create(Frozen{});
    EXPECT_EQ(text, "abb");
}

TEST(Observers, AreToldOfArchetypesThatNobodyObservedBefore) {
    World world;
    Observers& observers = world.observers();
    (void)observers.on_add<Frozen>([](Entity) {});
    const Entity first = world.create(Health{});
    world.create(Position{});
    std::string text;
    (void)observers.on_add<Health>([&](Entity, const Health&) { text += "+h"; });
    (void)observers.on_remove<Health>([&](Entity, const Health&) { text += "-h"; });
    world.create(Health{});
    world.destroy(first);
    EXPECT_EQ(text, "+h-h");
    (void)observers.on_remove<Burning>([&](Entity, const Burning&) { text += "-b"; });
    const Entity burning = world.create(Position{});
    world.add(burning, Burning{});
    world.destroy(burning);
    EXPECT_EQ(text, "+h-h-b") << "sparse ones may be anywhere";
}

TEST(Observers, AreToldInTheOrderOfKeysWhoeverRecordedFirst) {
    const auto play = [](bool backwards) {
        World world;
        std::vector<Entity> entities;
        for (int i = 0; i < 6; ++i)
            entities.push_back(world.create(Position{}));
        Diary diary{world};
        CommandQueue queue;
        for (std::uint32_t i = 0; i < 6; ++i) {
            const std::uint32_t chunk = backwards ? 5 - i : i;
            Commands& commands = queue.recording({0, chunk});
            commands.add(entities[chunk], Burning{static_cast<int>(chunk)});
            commands.create(Health{static_cast<int>(chunk)});
        }
        queue.apply(world);
        return diary.read();
    };
    EXPECT_EQ(play(false), play(true));
    EXPECT_EQ(play(true), "+h 0, +h 1, +h 2, +h 3, +h 4, +h 5, +b 0, +b 1, +b 2, +b 3, +b 4, +b 5");
}

TEST(Observers, AreToldOfManyNewEntitiesOnceTheyAreFilled) {
    World world;
    Diary diary{world};
    world.observers().on_add<Health>([](Entity entity, const Health&, Commands& commands) {
        if (entity.index == 0) commands.add(entity, Frozen{});
    });
    const std::span<const Entity> same = create_many(world, 3, Health{0}, Position{});
    EXPECT_EQ(diary.read(), "+h 0, +h 0, +h 0, +f 0");
    ASSERT_EQ(same.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(same[i], (Entity{i, 1})) << "even where observers have moved them";

    const auto number = [](std::span<const Entity>, std::span<Health> healths) {
        int next = 1;
        for (Health& health : healths)
            health.points = next++;
    };
    (void)create_many_with<Health>(world, 3, number);
    EXPECT_EQ(diary.read(), "+h 1, +h 2, +h 3");
    const auto fail = [](std::span<const Entity>, std::span<Health> healths) {
        healths[0].points = 8;
        throw std::runtime_error{"no"};
    };
    EXPECT_THROW((void)create_many_with<Health>(world, 1, fail), std::runtime_error);
    EXPECT_EQ(diary.read(), "+h 8") << "it stays";
}

TEST(Observers, AreNotToldOfTheWorldsEnd) {
    int calls = 0;
    {
        World world;
        world.observers().on_remove<Health>([&](Entity, const Health&) { ++calls; });
        world.create(Health{});
    }
    EXPECT_EQ(calls, 0);
}

TEST(Observers, AreNotToldOfWhatFails) {
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

TEST(Observers, AreToldOfAnEntityOnlyIfAllOfItCouldBeMade) {
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

TEST(Observers, AllocateNothingInASteadyState) {
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
