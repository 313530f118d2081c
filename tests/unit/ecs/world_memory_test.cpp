#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/lender.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Blocks are lent in slabs of this size, larger ones singly.
constexpr std::size_t k_slab_bytes = 64 * 1024;
constexpr std::size_t k_largest_pooled = 16 * 1024;

TEST(WorldMemory, RowsOfSmallArchetypesComeFromTheGivenOne) {
    Lender lender;
    World world{{.memory = &lender}};
    for (int i = 0; i < 200; ++i) {
        world.create(Position{});
        world.create(Position{}, Velocity{}, Health{i});
    }
    std::size_t blocks = 0;
    for (const ArchetypeStats& stats : world.archetype_stats())
        blocks += stats.row_bytes;
    EXPECT_GE(blocks, 200 * (sizeof(Position) + sizeof(Position) + sizeof(Velocity) + sizeof(Health)));
    EXPECT_GE(lender.lent, blocks);
    EXPECT_LE(lender.lent, blocks + k_slab_bytes + k_largest_pooled) << "what is begun of a slab";
}

TEST(WorldMemory, RowsOfLargerArchetypesDoNotWhereTheyHaveAddressRanges) {
    constexpr std::size_t k_count = 50'000;
    Lender with_ranges;
    Lender without;
    World ranges{{.memory = &with_ranges}};
    World blocks{{.reserve_address_space = false, .memory = &without}};
    for (std::size_t i = 0; i < k_count; ++i) {
        ranges.create(Position{});
        blocks.create(Position{});
    }
    EXPECT_LE(with_ranges.lent, ReservedMemory::grows_in_place ? k_slab_bytes : Lender::k_none);
    EXPECT_GE(without.lent, k_count * (sizeof(Entity) + sizeof(Position)));
}

TEST(WorldMemory, SparseAndSharedValuesComeFromTheGivenOne) {
    constexpr std::size_t k_count = 20'000;
    Lender lender;
    World world{{.memory = &lender}};
    std::vector<Entity> entities;
    for (std::size_t i = 0; i < k_count; ++i)
        entities.push_back(world.create(Health{}));
    const std::size_t before = lender.lent;
    for (const Entity entity : entities)
        world.add(entity, Burning{1});
    const std::size_t sparse = lender.lent - before;
    EXPECT_GE(sparse + k_slab_bytes, k_count * (sizeof(Burning) + sizeof(std::uint32_t)))
        << "values, and their places";
    for (std::uint32_t i = 0; i < 3'000; ++i)
        world.create(Material{i});
    EXPECT_GE(lender.lent, before + sparse + 3'000 * (16 * sizeof(Entity) + 64)) << "rows, and a value, each";
}

TEST(WorldMemory, GoesBackWithTheWorldAndByCompact) {
    Lender lender;
    {
        World world{{.reserve_address_space = false, .memory = &lender}};
        std::vector<Entity> entities;
        for (int i = 0; i < 5'000; ++i)
            entities.push_back(world.create(Health{i}, Burning{i}));
        const std::size_t full = lender.lent;
        for (const Entity entity : entities)
            world.destroy(entity);
        EXPECT_EQ(lender.lent, full);
        world.compact();
        EXPECT_LT(lender.lent, full / 4);
        world.create(Material{1}, Anchored{2}, SparseAnchored{3});
    }
    EXPECT_EQ(lender.lent, 0u);
    EXPECT_EQ(Anchored::alive, 0);
}

/// Every row of what is made here is in use: what comes next needs another block.
struct Crowded {
    Lender lender;
    World world{{.reserve_address_space = false, .memory = &lender}};
    std::vector<Entity> entities;

    Crowded() {
        for (int i = 0; i < 2'048; ++i)
            entities.push_back(world.create(Health{i}, Anchored{i}));
        for (int i = 0; i < 2'048; ++i)
            world.create(Position{}, Health{i}, Anchored{i});
    }
    [[nodiscard]] std::string state() {
        Query<Entity, const Health, const Anchored, Optional<const Position>> all;
        std::string text = std::to_string(world.entity_count());
        all.each(world, [&](Entity entity, const Health& health, const Anchored& anchored,
                            const Position* position) {
            text += to_string(entity) + std::to_string(health.points) + (anchored.intact() ? "" : "damaged") +
                    (position != nullptr ? "p" : "");
        });
        return text;
    }
};

/// Refuses every request of `change` in turn, until it makes no more: each time nothing has changed, and it
/// can be made afterwards. Returns how many requests there were.
std::size_t refuse_each(const std::function<void(Crowded&)>& change) {
    for (std::size_t number = 0;; ++number) {
        Crowded crowded;
        const std::string before = crowded.state();
        crowded.lender.refused = crowded.lender.requests + number;
        bool refused = false;
        try {
            change(crowded);
        } catch (const CapacityExceeded&) {
            refused = true;
        }
        EXPECT_EQ(refused, crowded.lender.requests > crowded.lender.refused) << "request " << number;
        if (!refused) return number;
        EXPECT_EQ(crowded.state(), before) << "request " << number;
        crowded.lender.refused = Lender::k_none;
        change(crowded);
        EXPECT_NE(crowded.state(), before) << "request " << number;
        if (testing::Test::HasFailure()) return number;
    }
}

TEST(WorldMemory, ThatIsRefusedChangesNothing) {
    EXPECT_EQ(refuse_each([](Crowded& crowded) { crowded.world.create(Health{1}, Anchored{1}); }), 1u);
    EXPECT_EQ(refuse_each([](Crowded& crowded) {
                  crowded.world.add(crowded.entities[7], Position{1, 2, 3});
              }),
              1u);
    EXPECT_EQ(refuse_each([](Crowded& crowded) {
                  Commands commands;
                  commands.create(Health{1}, Anchored{1});
                  commands.add(crowded.entities[7], Position{1, 2, 3});
                  commands.destroy(crowded.entities[8]);
                  commands.apply(crowded.world);
              }),
              2u)
        << "for rows of two archetypes";
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(WorldMemory, ThatIsRefusedGivesNoSparseOrSharedValue) {
    Crowded crowded;
    World& world = crowded.world;
    const auto until_refused = [&](const auto& change) {
        crowded.lender.limit = crowded.lender.lent;
        for (std::uint32_t i = 0; i < crowded.entities.size(); ++i) {
            try {
                change(i);
            } catch (const CapacityExceeded&) {
                crowded.lender.limit = Lender::k_none;
                return i;
            }
        }
        ADD_FAILURE() << "never refused";
        return 0u;
    };
    const std::uint32_t cold = until_refused(
        [&](std::uint32_t i) { world.add(crowded.entities[i], SparseAnchored{static_cast<int>(i)}); });
    EXPECT_FALSE(world.has<SparseAnchored>(crowded.entities[cold]));
    EXPECT_EQ(world.get<SparseAnchored>(crowded.entities[cold - 1]).number(), static_cast<int>(cold) - 1);
    world.add(crowded.entities[cold], SparseAnchored{5});
    EXPECT_EQ(world.get<SparseAnchored>(crowded.entities[cold]).number(), 5);

    const std::size_t before = world.entity_count();
    const std::uint32_t made = until_refused([&](std::uint32_t i) { world.create(Material{i}); });
    EXPECT_EQ(world.entity_count(), before + made);
    EXPECT_EQ(world.get<Material>(world.create(Material{made})).number, made);
}

}  // namespace
}  // namespace rambla::ecs
