#include "ecs/filters.h"

#include <gtest/gtest.h>

#include <concepts>
#include <span>
#include <utility>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

template <class Q>
std::vector<Entity> found(World& world, Q query) {
    std::vector<Entity> entities;
    query.each(world, [&](Entity entity) { entities.push_back(entity); });
    EXPECT_EQ(query.count(world), entities.size());
    return entities;
}

template <class Q>
std::vector<Entity> found(World& world, Q query, Since since) {
    std::vector<Entity> entities;
    query.each(world, since, [&](Entity entity) { entities.push_back(entity); });
    EXPECT_EQ(query.count(world, since), entities.size());
    return entities;
}

/// `count` entities with a Position, those whose number divides by `every` with a Burning of that number.
std::vector<Entity> burning_rows(World& world, int count, int every) {
    std::vector<Entity> entities;
    for (int i = 0; i < count; ++i) {
        entities.push_back(world.create(Position{}));
        if (i % every == 0) world.add(entities.back(), Burning{i});
    }
    return entities;
}

TEST(SparseTerms, HandOutOnlyRowsThatHaveAll) {
    for (int count : {1, 1023, 1024, 1025, 2500}) {
        World world;
        const std::vector<Entity> entities = burning_rows(world, count, 7);
        Query<Entity, Position, const Burning> query;
        std::vector<int> heats;
        for (const auto& chunk : query.chunks(world)) {
            auto [handles, positions, burning] = chunk;
            static_assert(std::same_as<decltype(positions), std::span<Position>>);
            EXPECT_EQ(positions.size(), chunk.size());
            for (std::size_t row : chunk.rows()) {
                EXPECT_EQ(burning.find(row), world.try_get<Burning>(handles[row]));
                heats.push_back(burning[row].heat);
            }
        }
        ASSERT_EQ(heats.size(), static_cast<std::size_t>((count + 6) / 7));
        for (std::size_t i = 0; i < heats.size(); ++i)
            ASSERT_EQ(heats[i], static_cast<int>(i) * 7);
        int calls = 0;
        query.each(world, [&](Entity entity, Position& position, const Burning& value) {
            EXPECT_EQ(entities[static_cast<std::size_t>(value.heat)], entity);
            position.x = 1;
            ++calls;
        });
        EXPECT_EQ(calls, (count + 6) / 7);
        EXPECT_EQ(query.count(world), static_cast<std::size_t>((count + 6) / 7));
    }
}

TEST(SparseTerms, FilterByWithWithoutAndOptional) {
    World world;
    const Entity plain = world.create(Position{});
    const Entity selected = world.create(Position{}, Selected{});
    const Entity burning = world.create(Position{}, Burning{5});
    const Entity both = world.create(Health{}, Selected{}, Burning{6});
    EXPECT_EQ(found(world, Query<Entity, With<Selected>>{}), (std::vector{selected, both}));
    EXPECT_EQ(found(world, Query<Entity, With<Selected>, With<Position>>{}), (std::vector{selected}));
    EXPECT_EQ(found(world, Query<Entity, Without<Selected>>{}), (std::vector{plain, burning}));
    EXPECT_EQ(found(world, Query<Entity, With<Burning>, Without<Selected>>{}), (std::vector{burning}));
    Query<Entity, Optional<Burning>> optional;
    int heat = 0;
    int rows = 0;
    optional.each(world, [&](Entity entity, Burning* value) {
        EXPECT_EQ(value != nullptr, entity == burning || entity == both);
        if (value != nullptr) heat += value->heat;
        ++rows;
    });
    EXPECT_EQ(rows, 4);
    EXPECT_EQ(heat, 11);
}

TEST(SparseTerms, OfAComponentThatTheWorldNeverMetHoldNoRow) {
    World world;
    const Entity entity = world.create(Position{});
    Query<Entity, With<Selected>> with;
    Query<Entity, Without<Selected>> without;
    EXPECT_EQ(with.count(world), 0u);
    EXPECT_EQ(without.count(world), 1u);
    world.add<Selected>(entity);
    EXPECT_EQ(with.count(world), 1u) << "found though no archetype was born";
    EXPECT_EQ(without.count(world), 0u);
}

TEST(SparseTerms, SkipChunksWithoutAnyRow) {
    World world;
    const std::vector<Entity> entities = burning_rows(world, 5000, 5000);
    world.add<Selected>(entities[3000]);
    Query<Entity, With<Selected>, Position> query;
    const std::uint32_t seen = world.advance_version();
    std::size_t chunks = 0;
    for (const auto& chunk : query.chunks(world)) {
        ++chunks;
        EXPECT_EQ(chunk.rows().count(), 1u);
        EXPECT_TRUE(chunk.rows().test(3000 % 1024));
    }
    EXPECT_EQ(chunks, 1u);
    EXPECT_EQ(found(world, Query<Entity, Changed<Position>>{}, {seen}).size(), 1024u)
        << "only the chunk that was handed out counts as written";
}

TEST(AnyOfTerm, TakesWhoHasAtLeastOne) {
    World world;
    world.create(Position{});
    const Entity frozen = world.create(Position{}, Frozen{});
    const Entity moving = world.create(Position{}, Velocity{});
    const Entity both = world.create(Position{}, Velocity{}, Frozen{});
    EXPECT_EQ(found(world, Query<Entity, AnyOf<Frozen, Velocity>>{}), (std::vector{frozen, moving, both}));
    EXPECT_EQ(found(world, Query<Entity, AnyOf<Hidden, Health>>{}), (std::vector<Entity>{}));
    const Entity selected = world.create(Position{}, Selected{});
    EXPECT_EQ(found(world, Query<Entity, AnyOf<Selected, Velocity>>{}), (std::vector{selected, moving, both}))
        << "archetypes in the order of their birth";
}

TEST(EnableBit, SwitchesRowsWithoutMovingThem) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 1025; ++i)
        entities.push_back(world.create(Light{static_cast<float>(i)}));
    const Light* light = &world.get<Light>(entities[3]);
    EXPECT_TRUE(world.enabled<Light>(entities[3])) << "from the start";
    world.set_enabled<Light>(entities[3], false);
    world.set_enabled<Light>(entities[1024], false);
    EXPECT_FALSE(world.enabled<Light>(entities[3]));
    EXPECT_EQ(&world.get<Light>(entities[3]), light);
    EXPECT_TRUE(world.has<Light>(entities[3])) << "disabled, but there";
    EXPECT_EQ(found(world, Query<Entity, Disabled<Light>>{}), (std::vector{entities[3], entities[1024]}));
    EXPECT_EQ((Query<Enabled<Light>, const Light>{}.count(world)), 1023u);
    EXPECT_EQ((Query<const Light>{}.count(world)), 1025u) << "a plain term does not ask";
    for (Entity entity : entities)
        world.set_enabled<Light>(entity, false);
    Query<Enabled<Light>, Light> none;
    for (const auto& chunk : none.chunks(world))
        FAIL() << "all are disabled, yet there are " << chunk.rows().count();
    world.set_enabled<Light>(entities[5], true);
    EXPECT_EQ(found(world, Query<Entity, Enabled<Light>>{}), (std::vector{entities[5]}));
}

TEST(EnableBit, MovesWithItsRowAndBeginsEnabled) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 600; ++i) {  // out of the pool on the way
        entities.push_back(world.create(Light{}));
        if (i % 3 == 0) world.set_enabled<Light>(entities.back(), false);
    }
    world.destroy(entities[1]);  // the last row takes its place
    entities.erase(entities.begin() + 1);
    for (std::size_t i = 0; i < entities.size(); i += 2)
        world.add(entities[i], Position{});
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::size_t number = i == 0 ? 0 : i + 1;
        ASSERT_EQ(world.enabled<Light>(entities[i]), number % 3 != 0) << number;
    }
    world.remove<Light>(entities[0]);
    EXPECT_FALSE(world.has<EnableState<Light>>(entities[0]));
    EXPECT_THROW(world.set_enabled<Light>(entities[0], true), Misuse);
    EXPECT_THROW((void)world.enabled<Light>(entities[0]), Misuse);
    world.add(entities[0], Light{});
    EXPECT_TRUE(world.enabled<Light>(entities[0])) << "a new component is enabled";
    for (std::size_t i = entities.size() - 20; i < entities.size(); ++i)
        world.destroy(entities[i]);
    for (int i = 0; i < 20; ++i)
        EXPECT_TRUE(world.enabled<Light>(world.create(Light{}))) << "in rows that others left disabled";
}

TEST(ChangedTerm, HandsOutOnlyChunksWrittenSince) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 3000; ++i)
        entities.push_back(world.create(Position{}, Velocity{}));
    for (int i = 0; i < 2; ++i)
        world.create(Position{}, Frozen{});
    Query<const Position, Changed<Position>> query;
    EXPECT_EQ(query.count(world, {0}), 3002u) << "rows that came";
    std::uint32_t seen = world.advance_version();
    EXPECT_EQ(query.count(world, {seen}), 0u);
    world.get_mut<Position>(entities[1500]).x = 1;
    EXPECT_EQ(query.count(world, {seen}), 1024u);
    EXPECT_EQ((Query<Changed<Velocity>>{}.count(world, {seen})), 0u);
    EXPECT_EQ((Query<Changed<Velocity, Position>>{}.count(world, {seen})), 1024u) << "any of them";
    EXPECT_EQ((Query<Changed<Velocity>, Changed<Position>>{}.count(world, {seen})), 0u) << "all of them";
    seen = world.advance_version();
    world.destroy(entities[2999]);
    EXPECT_EQ(query.count(world, {seen}), 2999u - 2048u) << "rows that went";
    seen = world.advance_version();
    Query<Position, With<Frozen>> writer;
    writer.each(world, [](Position& position) { position.x = 2; });
    EXPECT_EQ(query.count(world, {seen}), 2u);
}

TEST(ChangedTerm, OfASparseComponentTellsSingleEntities) {
    World world;
    const std::vector<Entity> entities = burning_rows(world, 100, 10);
    const std::uint32_t seen = world.advance_version();
    Query<Entity, Changed<Burning>> query;
    EXPECT_TRUE(found(world, query, {seen}).empty());
    world.get_mut<Burning>(entities[20]).heat = 1;
    world.add(entities[31], Burning{});
    (void)world.get<Burning>(entities[40]);
    EXPECT_EQ(found(world, query, {seen}), (std::vector{entities[20], entities[31]}));
    Query<Burning> writer;
    writer.each(world, [](Burning&) {});
    EXPECT_EQ(found(world, query, {seen}).size(), 11u);
}

TEST(ChangedTerm, StaysRightWhenVersionsWrapAround) {
    World world{{.first_version = 0xffff'fffeu}};
    std::vector<Entity> entities;
    for (int i = 0; i < 2000; ++i)
        entities.push_back(world.create(Position{}, Burning{}));
    Query<Entity, Changed<Position>> query;
    Query<Entity, Changed<Burning>> sparse;
    for (int step = 0; step < 6; ++step) {
        const std::uint32_t seen = world.advance_version();
        EXPECT_EQ(query.count(world, {seen}), 0u) << seen;
        EXPECT_EQ(sparse.count(world, {seen}), 0u) << seen;
        (void)world.get_mut<Position>(entities[1]);
        (void)world.get_mut<Burning>(entities[1]);
        EXPECT_EQ(query.count(world, {seen}), 1024u) << seen;
        EXPECT_EQ(sparse.count(world, {seen}), 1u) << seen;
    }
    EXPECT_EQ(world.version(), 4u);
}

TEST(ChangedTerm, KnowsWhatWasNeverWrittenLateInTheCount) {
    World world{{.first_version = 0x9000'0000u}};  // further than 2³¹ from 0
    world.create(Position{});
    const std::uint32_t seen = world.advance_version();
    EXPECT_EQ((Query<Changed<Position>>{}.count(world, {seen})), 0u);
    EXPECT_EQ((Query<Changed<Position>>{}.count(world, {seen - 1})), 1u);
}

TEST(ChangedTerm, SinceNothingMeansVersion0WhichIsBeforeAllForHalfTheCount) {
    const auto written = [](const World& world, Since since) {
        return Query<Changed<Position>>{}.count(world, since);
    };
    World young;
    young.create(Position{});
    EXPECT_EQ(written(young, Since{}), 1u) << "a new world begins with version 1";
    EXPECT_EQ(written(young, Since{young.advance_version()}), 0u);
    EXPECT_EQ(written(young, Since{}), 1u);
    World last{{.first_version = 0x7fff'ffffu}};
    last.create(Position{});
    EXPECT_EQ(written(last, Since{}), 1u);
    World late{{.first_version = 0x8000'0001u}};
    late.create(Position{});
    EXPECT_EQ(written(late, Since{}), 0u) << "version 0 is yet to come";
    for (const World* world : {&young, &last, &late})
        EXPECT_EQ(written(*world, Since{world->version() - k_before_all_versions}), 1u);
}

}  // namespace
}  // namespace rambla::ecs
