#include "ecs/row_changes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "ecs/world_access.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(ChunkChanges, TellsTheRowsOfTheLastFourWritingVersions) {
    for (std::uint32_t start : {10u, 0xffff'fffeu}) {  // the second one wraps around
        ChunkChanges changes{start};
        EXPECT_EQ(changes.after(start), 0u);
        for (std::uint32_t i = 1; i <= 4; ++i)
            changes.mark(std::uint64_t{1} << i, start + i);
        changes.mark(1, start + 4);
        EXPECT_EQ(changes.after(start + 4), 0u);
        EXPECT_EQ(changes.after(start + 3), 0b10001u);
        EXPECT_EQ(changes.after(start + 1), 0b11101u);
        EXPECT_EQ(changes.after(start), 0b11111u) << "nothing is forgotten yet";
        changes.mark(1u << 5u, start + 9);
        EXPECT_EQ(changes.after(start + 1), 0b111101u);
        EXPECT_EQ(changes.after(start), ChunkChanges::k_all) << "what version 1 wrote is forgotten";
    }
}

/// changed_rows of every chunk.
std::vector<std::uint64_t> changed(const World& world, std::uint32_t seen) {
    Query<const Score> query;
    std::vector<std::uint64_t> rows;
    for (const auto& chunk : query.chunks(world))
        rows.push_back(chunk.changed_rows<Score>(seen));
    return rows;
}

TEST(RowChanges, WritingByHandleMarksSixteenRowsAndAQueryAll) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 1025; ++i)
        entities.push_back(world.create(Score{i}, Position{}));
    std::uint32_t seen = world.advance_version();
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{0, 0}));
    world.get_mut<Score>(entities[0]).points = 1;
    world.add(entities[1023], Score{2});
    world.mark_changed<Score>(entities[40]);
    world.get_mut<Position>(entities[500]).x = 1;
    constexpr std::uint64_t k_three = 1u | (1u << 2u) | (std::uint64_t{1} << 63u);
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{k_three, 0}));
    const std::uint32_t before = seen;
    seen = world.advance_version();
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{0, 0}));
    world.get_many_mut<Score>(std::vector{entities[20]}, [](std::size_t, Score&) {});
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{0b10, 0}));
    EXPECT_EQ(changed(world, before), (std::vector<std::uint64_t>{k_three | 0b10, 0}));
    seen = world.advance_version();
    Query<Score> writer;
    for (const auto& chunk : writer.chunks(world)) {
        EXPECT_EQ(chunk.changed_rows<Score>(seen), ChunkChanges::k_all);
        break;
    }
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{ChunkChanges::k_all, 0}));
    seen = world.advance_version();
    world.destroy(entities[3]);  // the last row takes its place
    EXPECT_EQ(changed(world, seen), (std::vector<std::uint64_t>{ChunkChanges::k_all}));
}

TEST(ArchetypeVersions, StayInOrderBeyondHalfTheCount) {
    // Raised now and then, versions never get so far apart that an old one looks newer than a reader's.
    World world;
    const Entity entity = world.create(Score{}, Burning{});
    world.create(Position{});
    for (int round = 0; round < 12; ++round) {  // 12 × 2²⁹: past 2³¹ and past 2³²
        detail::WorldAccess::set_version(world, world.version() | ((1u << 29u) - 1));
        (void)world.advance_version();
        const std::uint32_t seen = world.version() - 1;
        ASSERT_EQ((Query<Changed<Position>>{}.count(world, {seen})), 0u) << round;
        ASSERT_EQ((Query<Changed<Score>>{}.count(world, {seen})), 0u) << round;
        ASSERT_EQ((Query<Changed<Burning>>{}.count(world, {seen})), 0u) << round;
        ASSERT_EQ(changed(world, seen)[0], 0u) << round;
        if (round % 5 == 0) world.mark_changed<Score>(entity);
        if (round % 5 == 0) {
            ASSERT_EQ(changed(world, seen)[0], 1u) << round;
        }
    }
}

}  // namespace
}  // namespace rambla::ecs
