#include "ecs/snapshot.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ecs/commands.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

Machine machine(std::uint64_t serial, Entity driver) {
    Machine made;
    made.on = serial % 2 == 0;
    made.hours = 0.1 * static_cast<double>(serial);
    made.gear = serial % 3 == 0 ? Gear::reverse : Gear::drive;
    made.slope = static_cast<std::int16_t>(-static_cast<int>(serial));
    made.driver = driver;
    made.loads = {1, 2, static_cast<float>(serial)};
    made.place = {4, 5, 6};
    made.wheels[1] = {7, 8, 9};
    made.serial = serial << 40u;
    return made;
}

TEST(Snapshot, GivesBackEveryValueUnderTheSameHandles) {
    const TypeRegistry registry = parts_registry();
    World world;
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Entity driver = i == 0 ? Entity{} : entities.back();
        entities.push_back(i % 3 == 0
                               ? world.create(Position{static_cast<float>(i), 1, 2}, machine(i, driver))
                           : i % 3 == 1 ? world.create(Label{"label " + std::to_string(i), i}, Frozen{})
                                        : world.create());
    }
    world.set_resource(Weather{3.5f, "breeze"});
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    const World& copy = *restored.world;
    ASSERT_EQ(copy.entity_count(), 3000u);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Entity entity = entities[i];
        ASSERT_TRUE(copy.alive(entity));
        ASSERT_EQ(copy.has<Machine>(entity), i % 3 == 0);
        ASSERT_EQ(copy.has<Frozen>(entity), i % 3 == 1);
        if (i % 3 == 0) {
            ASSERT_EQ(copy.get<Machine>(entity), world.get<Machine>(entity)) << i;
            ASSERT_EQ(copy.get<Position>(entity).x, static_cast<float>(i));
        }
        if (i % 3 == 1) {
            ASSERT_EQ(copy.get<Label>(entity), (Label{"label " + std::to_string(i), i}));
        }
    }
    EXPECT_EQ(copy.resource<Weather>(), (Weather{3.5f, "breeze"}));
}

TEST(Snapshot, OfTheRestoredWorldIsTheSame) {
    const TypeRegistry registry = parts_registry();
    World world;
    for (int i = 0; i < 2500; ++i)
        world.create(Health{i}, Byte{static_cast<std::uint8_t>(i)});
    for (std::uint32_t i = 0; i < 500; ++i)
        world.add(Entity{i * 3, 1}, Label{std::to_string(i)});
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    EXPECT_EQ(snapshot_of(*restored.world, registry), snapshot_of(world, registry));
}

TEST(Snapshot, KeepsTheOrderInWhichSlotsAndRowsAreUsedNext) {
    const TypeRegistry registry = parts_registry();
    World world;
    for (int i = 0; i < 100; ++i)
        world.create(Health{i});
    for (std::uint32_t i : {7u, 3u, 99u, 50u})
        world.destroy({i, 1});
    world.destroy(world.create(Health{}));  // generation 2 of slot 50 ends too
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(restored.world->create(Health{i}), world.create(Health{i}));
    EXPECT_TRUE(world.alive({50, 3}));
    Query<Entity, const Health> query;
    std::vector<Entity> order;
    query.each(world, [&](Entity entity, const Health&) { order.push_back(entity); });
    std::size_t row = 0;
    query.each(*restored.world, [&](Entity entity, const Health&) { EXPECT_EQ(entity, order[row++]); });
    EXPECT_EQ(row, 106u);
}

TEST(Snapshot, OfAnEmptyWorldIsAnEmptyWorld) {
    const TypeRegistry registry = parts_registry();
    World world;
    const Bytes bytes = snapshot_of(world, registry);
    const RestoredWorld restored = read_snapshot(bytes, registry);
    EXPECT_EQ(restored.world->entity_count(), 0u);
    EXPECT_FALSE(restored.world->has_resource<Weather>());
    EXPECT_EQ(restored.world->create(), (Entity{0, 1}));
}

TEST(Snapshot, CountsEverythingAsWrittenWhenItWasTaken) {
    const TypeRegistry registry = parts_registry();
    World world;
    const Entity entity = world.create(Health{1});
    world.advance_version();
    SnapshotWriter writer{registry};
    const RestoredWorld restored = read_snapshot(writer.write(world), registry);
    EXPECT_EQ(restored.position, writer.position());
    EXPECT_EQ(restored.position.version, 2u);
    EXPECT_EQ(restored.world->version(), world.version());
    Query<const Health> query;
    const auto changed = [&](std::uint32_t seen) {
        for (const auto& chunk : query.chunks(*restored.world))
            return chunk.changed_since<Health>(seen);
        return false;
    };
    EXPECT_TRUE(changed(1));
    EXPECT_FALSE(changed(2));
    restored.world->get_mut<Health>(entity).points = 2;
    EXPECT_TRUE(changed(2));
}

TEST(Snapshot, ResetsTransientComponents) {
    const TypeRegistry registry = parts_registry();
    World world;
    const Entity entity = world.create(Cache{5}, Health{6});
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    EXPECT_EQ(restored.world->get<Cache>(entity).value, Cache{}.value);
    EXPECT_EQ(restored.world->get<Health>(entity).points, 6);
}

TEST(Snapshot, KeepsSparseComponentsInTheirOrderAndWhatIsSwitchedOff) {
    const TypeRegistry registry = parts_registry();
    World world;
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        entities.push_back(world.create(Engine{static_cast<float>(i)}));
        if (i % 3 == 0) world.add(entities[i], Mark{std::to_string(i)});
        if (i % 5 == 0) world.add(entities[i], Chosen{});
        if (i % 7 == 0) world.set_enabled<Engine>(entities[i], false);
    }
    world.remove<Mark>(entities[0]);  // the last one takes its place
    world.destroy(entities[9]);
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    const World& copy = *restored.world;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        if (i == 9) continue;
        ASSERT_EQ(copy.has<Mark>(entities[i]), i % 3 == 0 && i != 0) << i;
        if (i % 3 == 0 && i != 0) {
            ASSERT_EQ(copy.get<Mark>(entities[i]), Mark{std::to_string(i)});
        }
        ASSERT_EQ(copy.has<Chosen>(entities[i]), i % 5 == 0);
        ASSERT_EQ(copy.enabled<Engine>(entities[i]), i % 7 != 0);
        ASSERT_EQ(copy.get<Engine>(entities[i]).power_w, static_cast<float>(i));
    }
    EXPECT_EQ(snapshot_of(*restored.world, registry), snapshot_of(world, registry)) << "dense order too";
}

TEST(Snapshot, KeepsSharedValues) {
    const TypeRegistry registry = parts_registry();
    World world;
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < 300; ++i) {
        entities.push_back(world.create(Health{static_cast<int>(i)}, Material{i % 7}));
        if (i % 2 == 0) world.add(entities[i], Tint{static_cast<std::uint8_t>(i % 3), 0.5});
    }
    const RestoredWorld restored = read_snapshot(snapshot_of(world, registry), registry);
    for (std::uint32_t i = 0; i < 300; ++i) {
        ASSERT_EQ(restored.world->get<Material>(entities[i]).number, i % 7);
        ASSERT_EQ(restored.world->has<Tint>(entities[i]), i % 2 == 0);
        if (i % 2 == 0) {
            ASSERT_EQ(restored.world->get<Tint>(entities[i]), (Tint{static_cast<std::uint8_t>(i % 3), 0.5}));
        }
    }
    EXPECT_EQ(restored.world->archetype_count(), world.archetype_count());
    EXPECT_EQ(snapshot_of(*restored.world, registry), snapshot_of(world, registry));
}

TEST(Snapshot, RefusesComponentsThatNobodyDescribed) {
    const TypeRegistry registry = parts_registry();
    World world;
    world.create(Line{});
    SnapshotWriter writer{registry};
    const std::uint32_t version = world.version();
    try {
        writer.write(world);
        FAIL();
    } catch (const Misuse& error) {
        EXPECT_NE(std::string{error.what()}.find("Line"), std::string::npos) << error.what();
    }
    EXPECT_EQ(world.version(), version);
}

TEST(Snapshot, CannotBeTakenWhileItsWorldIsWalkedOver) {
    const TypeRegistry registry = parts_registry();
    World world;
    world.create(Health{1});
    SnapshotWriter writer{registry};
    Query<Health> query;
    for ([[maybe_unused]] const auto& chunk : query.chunks(world))
        EXPECT_THROW(writer.write(world), Misuse);
}

TEST(Snapshot, RespectsTheLimitsOfTheWorldItMakes) {
    const TypeRegistry registry = parts_registry();
    World world;
    for (int i = 0; i < 100; ++i)
        world.create(Health{i});
    const Bytes bytes = snapshot_of(world, registry);
    EXPECT_THROW((void)read_snapshot(bytes, registry, {.world = {.max_entities = 99}}), CapacityExceeded);
    EXPECT_THROW((void)read_snapshot(bytes, registry, {.world = {.max_rows_per_archetype = 90}}),
                 CapacityExceeded);
    EXPECT_EQ(read_snapshot(bytes, registry, {.world = {.max_entities = 100}}).world->entity_count(), 100u);
    EXPECT_EQ(
        read_snapshot(bytes, registry, {.world = {.reserve_address_space = false}}).world->entity_count(),
        100u);
}

TEST(Snapshot, OfAMillionEntitiesReadsBackEqual) {
    const TypeRegistry registry = parts_registry();
    World world;
    for (int i = 0; i < 1'000'000; ++i) {
        world.create(Position{static_cast<float>(i), 1, 2}, Velocity{3, static_cast<float>(i), 5});
    }
    SnapshotWriter writer{registry};
    const Bytes first = copy_of(writer.write(world));
    const RestoredWorld restored = read_snapshot(first, registry);
    EXPECT_EQ(snapshot_of(*restored.world, registry), copy_of(writer.write(world)));
    EXPECT_EQ(restored.world->get<Position>({999'999, 1}).x, 999'999.0f);
}

}  // namespace
}  // namespace rambla::ecs
