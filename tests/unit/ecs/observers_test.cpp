#include "ecs/observers.h"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/create_many.h"
#include "unit/ecs/diary.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

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

}  // namespace
}  // namespace rambla::ecs
