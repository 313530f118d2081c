#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <string>

#include "ecs/checksum.h"
#include "ecs/snapshot.h"
#include "unit/ecs/reflected_parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Every kind of thing that a stream may hold, in few bytes.
void populate(World& world) {
    for (std::uint32_t i = 0; i < 5; ++i) {
        world.create(Health{static_cast<int>(i)}, Frozen{});
        world.create(Machine{}, Label{std::to_string(i) + " x", i});
        world.create(Parent{{i, 1}}, Cache{});
    }
    world.add(Entity{1, 1}, Mark{"first"});
    world.add(Entity{2, 1}, Mark{"second"});
    world.add(Entity{7, 1}, Chosen{});
    world.set_enabled<Engine>(world.create(Engine{5}), false);
    world.create(Material{1}, Tint{2, 0.5});
    world.create(Material{3}, Tint{2, 0.5});
    world.destroy({4, 1});
    world.destroy({9, 1});
    world.set_resource(Weather{1.5f, "calm"});
}

/// Makes the checksum right again, so that only the checks behind it can refuse.
void fix_checksum(Bytes& bytes) {
    const std::uint64_t sum = checksum(std::span{bytes}.first(bytes.size() - 8));
    std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
}

void flip(Bytes& bytes, std::size_t bit) {
    bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
}

/// Reads, and uses what was read; whatever the bytes are, only these errors may come out.
bool survives(const Bytes& bytes, const TypeRegistry& registry, bool drop) {
    try {
        const RestoredWorld restored =
            read_snapshot(bytes, registry, {.world = {}, .drop_unknown_components = drop});
        World& world = *restored.world;
        EXPECT_TRUE(sparse_sets_are_sound(world));
        Query<Entity> query;
        std::vector<Entity> all;
        query.each(world, [&](Entity entity) { all.push_back(entity); });
        EXPECT_EQ(all.size(), world.entity_count());
        for (const Entity& entity : all) {
            EXPECT_TRUE(world.alive(entity));
            world.add(entity, Byte{1});
            world.add(entity, Mark{"again"});
        }
        for (const Entity& entity : all)
            world.destroy(entity);
        for (int i = 0; i < 50; ++i)
            world.create(Health{i});
        EXPECT_EQ(world.entity_count(), 50u);
        return true;
    } catch (const SnapshotError&) {
    } catch (const CapacityExceeded&) {
    }
    return false;
}

TEST(SnapshotCorruption, EveryTruncationIsRefused) {
    const TypeRegistry registry = parts_registry();
    World world;
    populate(world);
    const Bytes whole = snapshot_of(world, registry);
    ASSERT_NO_THROW((void)read_snapshot(whole, registry));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::span<const std::byte> part = std::span{whole}.first(length);
        ASSERT_THROW((void)read_snapshot(part, registry), SnapshotError) << length << " bytes";
    }
    Bytes longer = whole;
    longer.push_back({});
    EXPECT_THROW((void)read_snapshot(longer, registry), SnapshotError);
}

TEST(SnapshotCorruption, EveryFlippedBitIsRefused) {
    const TypeRegistry registry = parts_registry();
    World world;
    populate(world);
    Bytes bytes = snapshot_of(world, registry);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        flip(bytes, bit);
        ASSERT_THROW((void)read_snapshot(bytes, registry), SnapshotError) << "bit " << bit;
        flip(bytes, bit);
    }
}

TEST(SnapshotCorruption, MessagesSayWhatWasFoundAndExpectedWhere) {
    const TypeRegistry registry = parts_registry();
    World world;
    populate(world);
    const Bytes whole = snapshot_of(world, registry);
    const auto message = [&](const Bytes& bytes) -> std::string {
        try {
            (void)read_snapshot(bytes, registry);
        } catch (const SnapshotError& error) {
            return error.what();
        }
        return "none";
    };
    Bytes other_format = whole;
    other_format[8] = std::byte{9};
    EXPECT_EQ(message(other_format), "snapshot, byte 8: found format 9, expected format 1");
    EXPECT_EQ(message(Bytes(7)), "snapshot, byte 7: found 7 bytes, expected at least 48");
    Bytes other_file(100);
    EXPECT_EQ(message(other_file),
              "snapshot, byte 0: found other bytes, expected the beginning of a snapshot of ours");
    Bytes shorter{whole.begin(), whole.end() - 1};
    EXPECT_EQ(message(shorter), "snapshot, byte 16: found " + std::to_string(whole.size() - 1) +
                                    " bytes, expected " + std::to_string(whole.size()));
}

TEST(SnapshotCorruption, BitsFlippedUnderARightChecksumNeverCrash) {
    const TypeRegistry registry = parts_registry();
    World world;
    populate(world);
    Bytes bytes = snapshot_of(world, registry);
    std::size_t survived = 0;
    for (std::size_t bit = 0; bit < (bytes.size() - 8) * 8; ++bit) {
        flip(bytes, bit);
        fix_checksum(bytes);
        survived += survives(bytes, registry, bit % 2 == 0) ? 1 : 0;
        flip(bytes, bit);
    }
    EXPECT_GT(survived, 500u) << "bits of values only change values";
}

TEST(SnapshotCorruption, RandomDamageUnderARightChecksumNeverCrashes) {
    const TypeRegistry registry = parts_registry();
    World world;
    populate(world);
    const Bytes whole = snapshot_of(world, registry);
    std::mt19937 random{5};
    const auto below = [&](std::size_t end) {
        return random() % end;
    };
    constexpr std::uint32_t k_telling[] = {0, 1, 2, 0xffffffffu, 0x7fffffffu, 0x80000000u, 0xffffu, 1024};
    for (int trial = 0; trial < 20'000; ++trial) {
        Bytes bytes = whole;
        for (std::size_t damages = 1 + below(3); damages != 0; --damages) {
            const std::size_t at = 40 + below(bytes.size() - 56);
            switch (below(3)) {
                case 0:
                    bytes[at] = static_cast<std::byte>(random());
                    break;
                case 1:
                    std::memcpy(bytes.data() + at, &k_telling[below(std::size(k_telling))], 4);
                    break;
                default: {
                    const std::size_t from = 40 + below(bytes.size() - 56);
                    std::memmove(bytes.data() + at, bytes.data() + from, 8);
                }
            }
        }
        fix_checksum(bytes);
        survives(bytes, registry, trial % 2 == 0);
        if (HasFailure()) FAIL() << "trial " << trial;
    }
}

}  // namespace
}  // namespace rambla::ecs
