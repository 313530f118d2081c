#include "ecs/query.h"

#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(Query, HandsOutSpansOfEqualLengthInChunksOf1024Rows) {
    World world;
    std::vector<Entity> made;
    for (int i = 0; i < 2500; ++i) {
        made.push_back(world.create(Position{static_cast<float>(i), 0, 0}, Velocity{1, 0, 0}));
    }
    Query<Entity, const Position, Velocity> query;
    std::vector<std::size_t> sizes;
    std::vector<Entity> seen;
    for (auto [entities, positions, velocities] : query.chunks(world)) {
        static_assert(std::same_as<decltype(entities), std::span<const Entity>>);
        static_assert(std::same_as<decltype(positions), std::span<const Position>>);
        static_assert(std::same_as<decltype(velocities), std::span<Velocity>>);
        ASSERT_EQ(entities.size(), positions.size());
        ASSERT_EQ(entities.size(), velocities.size());
        sizes.push_back(entities.size());
        seen.insert(seen.end(), entities.begin(), entities.end());
        for (std::size_t i = 0; i < positions.size(); ++i)
            velocities[i].y = positions[i].x;
    }
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1024, 1024, 452}));
    EXPECT_EQ(seen, made) << "rows in the order of creation";
    EXPECT_EQ(world.get<Velocity>(made[2100]).y, 2100.0f);
}

TEST(Query, FiltersByTagsAndComponents) {
    World world;
    const Entity plain = world.create(Position{});
    const Entity frozen = world.create(Position{}, Frozen{});
    const Entity both = world.create(Position{}, Frozen{}, Velocity{});
    world.create(Velocity{});
    const auto found = [&](auto query) {
        std::vector<Entity> entities;
        query.each(world, [&](Entity entity) { entities.push_back(entity); });
        return entities;
    };
    EXPECT_EQ(found(Query<Entity, With<Position>>{}), (std::vector{plain, frozen, both}));
    EXPECT_EQ(found(Query<Entity, With<Position>, Without<Frozen>>{}), (std::vector{plain}));
    EXPECT_EQ(found(Query<Entity, With<Frozen>, With<Velocity>>{}), (std::vector{both}));
    EXPECT_EQ(found(Query<Entity, With<Hidden>>{}), (std::vector<Entity>{})) << "never met by the world";
    EXPECT_EQ(found(Query<Entity, With<Position>, Without<Hidden>>{}).size(), 3u);
}

TEST(Query, HandsOutAnEmptySpanForAnOptionalThatIsNotThere) {
    World world;
    world.create(Position{1, 0, 0});
    world.create(Position{2, 0, 0}, Health{7});
    Query<const Position, Optional<const Health>, Optional<Velocity>> query;
    std::vector<std::size_t> lengths;
    for (auto [positions, healths, velocities] : query.chunks(world)) {
        static_assert(std::same_as<decltype(healths), std::span<const Health>>);
        static_assert(std::same_as<decltype(velocities), std::span<Velocity>>);
        lengths.push_back(healths.size());
        EXPECT_TRUE(velocities.empty());
    }
    EXPECT_EQ(lengths, (std::vector<std::size_t>{0, 1}));
    int points = 0;
    query.each(world, [&](const Position& position, const Health* health, Velocity* velocity) {
        EXPECT_EQ(health != nullptr, position.x == 2.0f);
        EXPECT_EQ(velocity, nullptr);
        if (health != nullptr) points += health->points;
    });
    EXPECT_EQ(points, 7);
}

TEST(Query, EachSeesEveryRowOnceAcrossArchetypes) {
    World world;
    for (int i = 0; i < 1500; ++i)
        world.create(Health{1});
    for (int i = 0; i < 700; ++i)
        world.create(Health{1}, Frozen{});
    for (int i = 0; i < 20; ++i)
        world.create(Health{1}, Position{}, Velocity{});
    Query<Health> query;
    query.each(world, [](Health& health) { ++health.points; });
    int sum = 0;
    Query<const Health> reader;
    reader.each(std::as_const(world), [&](const Health& health) { sum += health.points; });
    EXPECT_EQ(sum, 2 * 2220);
    EXPECT_EQ(reader.count(world), 2220u);
}

TEST(Query, FindsArchetypesBornLater) {
    World world;
    Query<const Position> query;
    EXPECT_EQ(query.count(world), 0u);
    world.create(Position{});
    EXPECT_EQ(query.count(world), 1u);
    world.create(Position{}, Health{});
    EXPECT_EQ(query.count(world), 2u);
}

TEST(Query, ServesSeveralWorlds) {
    World a;
    a.create(Position{});
    Query<const Position> query;
    EXPECT_EQ(query.count(a), 1u);
    {
        World b;
        for (int i = 0; i < 5; ++i)
            b.create(Health{}, Position{});
        EXPECT_EQ(query.count(b), 5u);
    }
    World c;
    EXPECT_EQ(query.count(c), 0u) << "though it may lie where b was";
    EXPECT_EQ(query.count(a), 1u);
}

TEST(Query, CannotBeTakenToAnotherWorldWhileItIsWalkedOver) {
    World a;
    World b;
    a.create(Position{});
    b.create(Position{});
    Query<const Position> query;
    for (const auto& chunk : query.chunks(a)) {
        EXPECT_EQ(chunk.size(), 1u);
        EXPECT_EQ(query.count(a), 1u);
        EXPECT_THROW((void)query.count(b), Misuse);
    }
    EXPECT_EQ(query.count(b), 1u);
}

TEST(Query, OnlyFilteringWorksToo) {
    World world;
    world.create(Frozen{});
    world.create(Frozen{}, Hidden{});
    Query<With<Frozen>, Without<Hidden>> query;
    int calls = 0;
    query.each(world, [&] { ++calls; });
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(query.count(world), 1u);
}

TEST(Query, OnlyReadOnlyQueriesTakeAConstWorld) {
    const auto takes_const = []<class Q>(Q) {
        return requires(Q q, const World& world) {
            q.chunks(world);
        };
    };
    EXPECT_TRUE(takes_const(Query<const Position, Optional<const Velocity>, With<Frozen>>{}));
    EXPECT_FALSE(takes_const(Query<const Position, Velocity>{}));
    EXPECT_FALSE(takes_const(Query<const Position, Optional<Velocity>>{}));
}

TEST(Query, IteratingDoesNotAllocate) {
    World world;
    for (int i = 0; i < 5000; ++i)
        world.create(Position{}, Velocity{1, 1, 1});
    for (int i = 0; i < 50; ++i)
        world.create(Position{}, Velocity{1, 1, 1}, Frozen{});
    Query<Position, const Velocity> query;
    (void)query.count(world);
    const std::size_t before = rambla::test::allocation_count();
    for (auto [positions, velocities] : query.chunks(world))
        positions[0].x += velocities[0].x;
    query.each(world, [](Position& position, const Velocity& velocity) { position.x += velocity.x; });
    (void)query.count(world);
    EXPECT_EQ(rambla::test::allocation_count(), before);
    world.create(Position{}, Velocity{}, Hidden{});
    EXPECT_GT(rambla::test::allocation_count(), before) << "the counter counts";
}

/// The chunks of `query` that changed since `seen`.
template <class C>
std::vector<bool> changed(const World& world, std::uint32_t seen) {
    Query<const C> query;
    std::vector<bool> result;
    for (const auto& chunk : query.chunks(world))
        result.push_back(chunk.template changed_since<C>(seen));
    return result;
}

TEST(ChunkVersion, WritingThroughAQueryMarksOnlyWhatItHandsOut) {
    World world;
    for (int i = 0; i < 2500; ++i)
        world.create(Position{}, Velocity{});
    std::uint32_t seen = world.advance_version();
    Query<Position, const Velocity> query;
    for (const auto& chunk : query.chunks(world)) {
        EXPECT_EQ(chunk.version<Position>(), world.version());
        break;
    }
    EXPECT_EQ(changed<Position>(world, seen), (std::vector{true, false, false}));
    EXPECT_EQ(changed<Velocity>(world, seen), (std::vector{false, false, false}));
    seen = world.advance_version();
    Query<const Position> reader;
    reader.each(world, [](const Position&) {});
    EXPECT_EQ(changed<Position>(world, seen), (std::vector{false, false, false})) << "reading marks nothing";
}

TEST(ChunkVersion, WritingByHandleAndMovingRowsMarksTheChunk) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 2500; ++i)
        entities.push_back(world.create(Position{}, Velocity{}));
    std::uint32_t seen = world.advance_version();
    world.get_mut<Position>(entities[1500]).x = 1;
    (void)world.get<Position>(entities[0]);
    EXPECT_EQ(changed<Position>(world, seen), (std::vector{false, true, false}));
    EXPECT_EQ(changed<Velocity>(world, seen), (std::vector{false, false, false}));
    seen = world.advance_version();
    world.destroy(entities[3]);  // the last row takes its place
    EXPECT_EQ(changed<Velocity>(world, seen), (std::vector{true, false, true}));
    seen = world.advance_version();
    world.add(entities[1100], Position{5, 5, 5});  // replaces
    EXPECT_EQ(changed<Position>(world, seen), (std::vector{false, true, false}));
    EXPECT_EQ(changed<Velocity>(world, seen), (std::vector{false, false, false}));
    seen = world.advance_version();
    world.create(Position{}, Velocity{});
    EXPECT_EQ(changed<Position>(world, seen), (std::vector{false, false, true}));
}

TEST(ChunkVersion, SurvivesTheWrapOfTheCounter) {
    World world;
    const Entity entity = world.create(Position{});
    // The chunk's own stamp is at 1; a reader that saw version 0xffffffff looked just before.
    EXPECT_EQ(changed<Position>(world, 0xffffffffu), (std::vector{true}));
    EXPECT_EQ(changed<Position>(world, 1u), (std::vector{false}));
    (void)entity;
}

TEST(ChunkVersion, OfAnOptionalThatIsNotThereIsZero) {
    World world;
    world.create(Position{});
    Query<const Position, Optional<const Health>> query;
    for (const auto& chunk : query.chunks(world))
        EXPECT_EQ(chunk.version<Health>(), 0u);
}

}  // namespace
}  // namespace rambla::ecs
