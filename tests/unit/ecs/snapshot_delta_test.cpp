#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "ecs/checksum.h"
#include "ecs/commands.h"
#include "ecs/snapshot.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Changes a world by random operations, through every door there is.
class Player {
public:
    explicit Player(std::uint32_t seed) : random_{seed} {}

    void step(World& world) {
        const int n = static_cast<int>(below(1000));
        if (alive_.empty() || below(3) == 0) {
            create(world, n);
            return;
        }
        const std::size_t place = below(static_cast<std::uint32_t>(alive_.size()));
        const Entity entity = alive_[place];
        switch (below(19)) {
            case 0:
            case 1:
                world.destroy(entity);
                forget(place);
                break;
            case 2:
                world.add(entity, Label{std::to_string(n) + " is a label too long for the object itself", 1});
                break;
            case 3:
                if (world.has<Health>(entity)) world.remove<Health>(entity);
                break;
            case 4:
                world.add(entity, Frozen{});
                break;
            case 5:
                if (world.has<Frozen>(entity)) world.remove<Frozen>(entity);
                break;
            case 6:
                if (Health* health = world.try_get_mut<Health>(entity)) health->points = n;
                break;
            case 7:
                if (Label* label = world.try_get_mut<Label>(entity)) label->text += "!";
                break;
            case 8:
                world.set_resource(Weather{static_cast<float>(n), "wind"});
                break;
            case 9:
                if (below(20) == 0) positions_.each(world, [&](Position& position) { position.x += 1; });
                break;
            case 10:
                world.add(entity, Machine{});
                world.get_mut<Machine>(entity).driver =
                    alive_[below(static_cast<std::uint32_t>(alive_.size()))];
                break;
            case 11:
                world.add(entity, Mark{std::to_string(n)});
                break;
            case 12:
                if (world.has<Mark>(entity)) world.get_mut<Mark>(entity).reason += "?";
                break;
            case 13:
                if (world.has<Mark>(entity)) world.remove<Mark>(entity);
                break;
            case 14:
                if (!world.has<Engine>(entity)) world.add(entity, Engine{1});
                world.set_enabled<Engine>(entity, n % 2 == 0);
                break;
            case 15:
                world.add(entity, Chosen{});
                break;
            case 16:
                world.add(entity, Material{static_cast<std::uint32_t>(n % 5)});
                break;
            case 17:
                if (world.has<Material>(entity)) world.remove<Material>(entity);
                break;
            default: {
                commands_.add(entity, Byte{static_cast<std::uint8_t>(n)});
                const Entity made = commands_.create(Health{n}, Position{});
                commands_.apply(world);
                alive_.push_back(commands_.created(made));
            }
        }
    }

private:
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }

    void create(World& world, int n) {
        switch (below(4)) {
            case 0:
                alive_.push_back(world.create());
                break;
            case 1:
                alive_.push_back(world.create(Label{std::to_string(n), 2}, Health{n}));
                break;
            default:
                alive_.push_back(world.create(Position{static_cast<float>(n), 0, 0}, Velocity{}));
        }
    }

    void forget(std::size_t place) {
        alive_[place] = alive_.back();
        alive_.pop_back();
    }

    std::mt19937 random_;
    std::vector<Entity> alive_;
    Commands commands_;
    Query<Position> positions_;
};

TEST(SnapshotDelta, ReplayedOnItsBaseGivesTheSameBytes) {
    const TypeRegistry registry = parts_registry();
    for (std::uint32_t seed : {1u, 2u, 3u}) {
        World world;
        Player player{seed};
        for (int i = 0; i < 4000; ++i)
            player.step(world);
        SnapshotWriter writer{registry};
        RestoredWorld replica = read_snapshot(writer.write(world), registry);
        std::size_t smallest = ~std::size_t{0};
        for (int delta = 0; delta < 150; ++delta) {
            for (int i = delta % 40; i >= 0; --i)
                player.step(world);
            if (delta % 7 == 0) world.advance_version();
            const std::span<const std::byte> bytes = writer.write_delta(world);
            smallest = std::min(smallest, bytes.size());
            apply_delta(replica, bytes, registry);
            ASSERT_EQ(replica.position, writer.position());
            ASSERT_EQ(replica.world->entity_count(), world.entity_count());
            if (delta % 10 != 0) continue;
            // A snapshot of either ends its version, so the replica continues from the original's.
            const Bytes full = copy_of(writer.write(world));
            ASSERT_EQ(snapshot_of(*replica.world, registry), full) << "seed " << seed << ", delta " << delta;
            replica = read_snapshot(full, registry);
        }
        EXPECT_LT(smallest, writer.write(world).size() / 3) << "a delta tells only changes";
    }
}

TEST(SnapshotDelta, TellsOnlyChunksThatWereWritten) {
    const TypeRegistry registry = parts_registry();
    World world;
    for (std::uint32_t i = 0; i < 100 * k_chunk_rows; ++i)
        world.create(Health{static_cast<int>(i)}, Position{});
    for (std::uint32_t i = 0; i < 1000; ++i)
        world.destroy({i, 1});
    SnapshotWriter writer{registry};
    writer.write(world);
    const std::size_t quiet = writer.write_delta(world).size();
    EXPECT_LT(quiet, 600u) << "schemas and nothing else, not even the free slots that were told";
    world.get_mut<Health>({50 * k_chunk_rows, 1}).points = 0;
    constexpr std::size_t k_block = 5 * 4;  // archetype, rows, and how many runs of entities and two columns
    constexpr std::size_t k_run = 2 * 4;
    const std::size_t one_chunk = writer.write_delta(world).size();
    EXPECT_EQ(one_chunk, quiet + k_block + k_run + k_chunk_rows * sizeof(Health));
    EXPECT_EQ(writer.write_delta(world).size(), quiet);
}

TEST(SnapshotDelta, OfAnotherPositionIsRefused) {
    const TypeRegistry registry = parts_registry();
    World world;
    const Entity entity = world.create(Health{1});
    SnapshotWriter writer{registry};
    const Bytes base = copy_of(writer.write(world));
    world.get_mut<Health>(entity).points = 2;
    const Bytes first = copy_of(writer.write_delta(world));
    world.get_mut<Health>(entity).points = 3;
    const Bytes second = copy_of(writer.write_delta(world));

    RestoredWorld restored = read_snapshot(base, registry);
    EXPECT_THROW(apply_delta(restored, second, registry), SnapshotError) << "one is missing";
    EXPECT_THROW(apply_delta(restored, base, registry), SnapshotError) << "no delta";
    EXPECT_THROW((void)read_snapshot(first, registry), SnapshotError) << "no snapshot";
    EXPECT_EQ(restored.world->get<Health>(entity).points, 1) << "untouched";
    apply_delta(restored, first, registry);
    EXPECT_THROW(apply_delta(restored, first, registry), SnapshotError) << "twice";
    apply_delta(restored, second, registry);
    EXPECT_EQ(restored.world->get<Health>(entity).points, 3);
}

TEST(SnapshotDelta, OfAWorldThatWasChangedSinceIsRefused) {
    const TypeRegistry registry = parts_registry();
    World world;
    const Entity entity = world.create(Health{1});
    SnapshotWriter writer{registry};
    const Bytes base = copy_of(writer.write(world));
    const Bytes delta = copy_of(writer.write_delta(world));
    const auto refused_after = [&](auto change) {
        RestoredWorld restored = read_snapshot(base, registry);
        change(*restored.world);
        EXPECT_THROW(apply_delta(restored, delta, registry), Misuse);
    };
    refused_after([&](World& copy) { copy.get_mut<Health>(entity).points = 2; });
    refused_after([&](World& copy) { copy.destroy(entity); });
    refused_after([&](World& copy) { copy.create(); });
    refused_after([&](World& copy) { copy.add(entity, Mark{}); });
    refused_after([&](World& copy) { copy.advance_version(); });
    RestoredWorld restored = read_snapshot(base, registry);
    EXPECT_NO_THROW(apply_delta(restored, delta, registry));
}

TEST(SnapshotDelta, NeedsAStreamOfTheSameWorldBefore) {
    const TypeRegistry registry = parts_registry();
    World world;
    World other;
    SnapshotWriter writer{registry};
    EXPECT_THROW(writer.write_delta(world), Misuse);
    writer.write(world);
    EXPECT_THROW(writer.write_delta(other), Misuse);
    EXPECT_NO_THROW(writer.write_delta(world));
}

TEST(SnapshotDelta, WorksAcrossTheWrapAroundOfVersions) {
    const TypeRegistry registry = parts_registry();
    World world{{.first_version = 0xffffffffu}};
    const Entity entity = world.create(Health{1});
    SnapshotWriter writer{registry};
    RestoredWorld restored = read_snapshot(writer.write(world), registry);
    world.get_mut<Health>(entity).points = 9;
    EXPECT_EQ(world.version(), 0u);
    apply_delta(restored, writer.write_delta(world), registry);
    EXPECT_EQ(restored.world->get<Health>(entity).points, 9);
    EXPECT_EQ(restored.world->version(), world.version());
}

TEST(SnapshotDelta, DamagedUnderARightChecksumLeavesAConsistentWorld) {
    const TypeRegistry registry = parts_registry();
    World world;
    Player player{4};
    for (int i = 0; i < 60; ++i)
        player.step(world);
    SnapshotWriter writer{registry};
    const Bytes base = copy_of(writer.write(world));
    for (int i = 0; i < 30; ++i)
        player.step(world);
    const Bytes delta = copy_of(writer.write_delta(world));
    std::mt19937 random{6};
    std::size_t applied = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        RestoredWorld restored = read_snapshot(base, registry);
        const std::size_t count = restored.world->entity_count();
        Bytes damaged = delta;
        const std::size_t at = 40 + random() % (damaged.size() - 48);
        damaged[at] ^= static_cast<std::byte>(1u << random() % 8);
        const std::uint64_t sum = checksum(std::span{damaged}.first(damaged.size() - 8));
        std::memcpy(damaged.data() + damaged.size() - 8, &sum, 8);
        try {
            apply_delta(restored, damaged, registry);
            ++applied;
        } catch (const SnapshotError&) {
            ASSERT_EQ(restored.world->entity_count(), count);
            ASSERT_NO_THROW(apply_delta(restored, delta, registry))
                << "untouched, so the right one still fits";
        } catch (const CapacityExceeded&) {
            ASSERT_EQ(restored.world->entity_count(), count);
        }
        ASSERT_TRUE(sparse_sets_are_sound(*restored.world));
        Query<Entity> query;
        std::vector<Entity> all;
        query.each(*restored.world, [&](Entity entity) { all.push_back(entity); });
        ASSERT_EQ(all.size(), restored.world->entity_count());
        for (const Entity& entity : all)
            restored.world->destroy(entity);
    }
    EXPECT_GT(applied, 100u);
}

}  // namespace
}  // namespace rambla::ecs
