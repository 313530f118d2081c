#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(Compact, GivesBackWhatNoEntityNeedsAndKeepsEveryHandle) {
    for (bool reserves : {true, false}) {
        World world{{.reserve_address_space = reserves}};
        std::vector<Entity> entities;
        for (int i = 0; i < 200'000; ++i) {
            entities.push_back(world.create(Health{i}, Anchored{i}, Light{}));
            if (i % 2 == 0) world.add(entities.back(), Burning{i});
            if (i % 4 == 0) world.add(entities.back(), Position{});
            if (i % 10 == 0) world.set_enabled<Light>(entities.back(), false);
        }
        const std::size_t full = world.memory_bytes();
        for (std::size_t kept :
             {100'000u, 3000u, 100u, 0u}) {  // reserved columns, then a block, then nothing
            while (entities.size() > kept) {
                world.destroy(entities.back());
                entities.pop_back();
            }
            world.compact();
            for (std::size_t i = 0; i < kept; ++i) {
                const int number = static_cast<int>(i);
                ASSERT_EQ(world.get<Health>(entities[i]).points, number);
                ASSERT_TRUE(world.get<Anchored>(entities[i]).intact());
                ASSERT_EQ(world.enabled<Light>(entities[i]), number % 10 != 0);
                ASSERT_EQ(world.has<Burning>(entities[i]), number % 2 == 0);
                ASSERT_EQ(world.has<Position>(entities[i]), number % 4 == 0);
            }
            const std::size_t held = world.memory_bytes();
            if (ReservedMemory::grows_in_place && reserves) {
                // Records of slots once used stay, 12 bytes each; the rest shrinks with the entities.
                EXPECT_LT(held, 200'000u * 12 + kept * (full / 200'000) * 5 / 4 + 300'000) << kept;
            }
        }
        EXPECT_EQ(Anchored::alive, 0);
        for (int i = 0; i < 2000; ++i)
            entities.push_back(world.create(Health{i}, Anchored{i}, Light{}));
        for (int i = 0; i < 2000; ++i) {
            ASSERT_EQ(world.get<Health>(entities[static_cast<std::size_t>(i)]).points, i);
            ASSERT_TRUE(world.enabled<Light>(entities[static_cast<std::size_t>(i)]));
        }
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(Compact, KeepsChangeVersions) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 5000; ++i)
        entities.push_back(world.create(Health{i}, Score{}));
    while (entities.size() > 2000) {
        world.destroy(entities.back());
        entities.pop_back();
    }
    const std::uint32_t seen = world.advance_version();
    world.get_mut<Score>(entities[1500]).points = 1;
    world.compact();
    EXPECT_EQ((Query<Changed<Score>>{}.count(world, {seen})), 2000u - 1024u);
    EXPECT_EQ((Query<Changed<Health>>{}.count(world, {seen})), 0u);
}

TEST(Compact, IsAStructuralChange) {
    World world;
    world.create(Health{});
    Query<const Health> query;
    for (const auto& chunk : query.chunks(world)) {
        EXPECT_EQ(chunk.size(), 1u);
        EXPECT_THROW(world.compact(), Misuse);
    }
}

TEST(ArchetypeStats, TellEachArchetypesRowsAndBytes) {
    World world;
    for (int i = 0; i < 3; ++i)
        world.create(Position{}, Frozen{});
    for (int i = 0; i < 3000; ++i)
        world.create(Health{});
    const std::vector<ArchetypeStats> all = world.archetype_stats();
    ASSERT_EQ(all.size(), world.archetype_count());
    const ArchetypeStats& small = all[1];
    ASSERT_EQ(small.components.size(), 2u);
    EXPECT_NE(small.components[0].find("Position"), std::string_view::npos);
    EXPECT_NE(small.components[1].find("Frozen"), std::string_view::npos);
    EXPECT_EQ(small.rows, 3u);
    EXPECT_EQ(small.capacity, 16u);
    EXPECT_EQ(small.row_bytes, 16u * (8 + 12)) << "handles and positions";
    EXPECT_FALSE(small.has_reservation);
    const ArchetypeStats& large = all[2];
    EXPECT_EQ(large.rows, 3000u);
    EXPECT_GE(large.row_bytes, large.capacity * std::size_t{8 + 4});
    EXPECT_EQ(large.has_reservation, ReservedMemory::grows_in_place);
    std::size_t bytes = 0;
    for (const ArchetypeStats& stats : all)
        bytes += stats.row_bytes + stats.table_bytes;
    EXPECT_LT(bytes, world.memory_bytes() + BlockPool::k_slab_bytes);
}

}  // namespace
}  // namespace rambla::ecs
