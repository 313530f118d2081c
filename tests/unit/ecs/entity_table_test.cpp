#include "ecs/entity_table.h"

#include <gtest/gtest.h>

#include <unordered_set>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

Entity take(EntityTable& table) {
    table.reserve_one();
    return table.take(0, 0);
}

TEST(Entity, NullIsTheDefaultAndPrintsItsParts) {
    EXPECT_EQ(Entity{}, (Entity{0xffffffffu, 0}));
    EXPECT_EQ(to_string(Entity{}), "null");
    EXPECT_EQ(to_string(Entity{12, 3}), "12v3");
    EXPECT_EQ(to_string(Entity{4, 0}), "placeholder 4");
}

TEST(Entity, HashesByIndexAndGeneration) {
    std::unordered_set<Entity> set{{1, 1}, {1, 2}, {2, 1}, {1, 1}};
    EXPECT_EQ(set.size(), 3u);
}

TEST(EntityTable, NeverFindsWhatIsNotAlive) {
    EntityTable table{100};
    const Entity entity = take(table);
    EXPECT_NE(table.find(entity), nullptr);
    EXPECT_EQ(table.find({}), nullptr);
    EXPECT_EQ(table.find({entity.index, 0}), nullptr) << "a placeholder";
    EXPECT_EQ(table.find({entity.index + 1, 1}), nullptr) << "a slot never used";
    table.give_back(entity.index);
    EXPECT_EQ(table.find(entity), nullptr);
    EXPECT_EQ(table.find({entity.index, entity.generation + 1}), nullptr)
        << "free, though the generation agrees";
}

TEST(EntityTable, UsesTheSlotFreedLastFirstWithTheNextGeneration) {
    EntityTable table{100};
    const Entity a = take(table);
    const Entity b = take(table);
    table.give_back(a.index);
    table.give_back(b.index);
    EXPECT_EQ(take(table), (Entity{b.index, 2}));
    EXPECT_EQ(take(table), (Entity{a.index, 2}));
    EXPECT_EQ(take(table), (Entity{2, 1}));
}

TEST(EntityTable, RetiresASlotWhoseGenerationsAreUsedUp) {
    EntityTable table{100};
    const Entity entity = take(table);
    table[entity.index].generation = 0xffffffffu;
    table.give_back(entity.index);
    EXPECT_EQ(take(table).index, 1u) << "slot 0 would hand out generations that were used before";
    EXPECT_EQ(table.find({entity.index, 0xffffffffu}), nullptr);
}

TEST(EntityTable, RefusesMoreThanItsMaximum) {
    EntityTable table{3};
    for (int i = 0; i < 3; ++i)
        take(table);
    EXPECT_THROW(table.reserve_one(), CapacityExceeded);
    table.give_back(1);
    EXPECT_NO_THROW(table.reserve_one());
    EXPECT_EQ(table.alive_count(), 2u);
}

TEST(EntityTable, HoldsLittleMoreThanTwelveBytesPerEntity) {
    EntityTable table{1u << 28u};
    for (int i = 0; i < 1'000'000; ++i)
        take(table);
    EXPECT_LT(table.memory_bytes(), 14'000'000u) << "records of 12 bytes, grown by an eighth at a time";
}

}  // namespace
}  // namespace rambla::ecs
