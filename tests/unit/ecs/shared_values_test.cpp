#include "ecs/shared_values.h"

#include <gtest/gtest.h>

#include <concepts>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(SharedValue, IsStoredOncePerArchetype) {
    World world;
    std::vector<Entity> entities;
    for (std::uint32_t i = 0; i < 3000; ++i)
        entities.push_back(world.create(Position{static_cast<float>(i), 0, 0}, Material{i % 3}));
    for (std::uint32_t i = 0; i < 3000; ++i)
        ASSERT_EQ(world.get<Material>(entities[i]).number, i % 3);
    EXPECT_EQ(&world.get<Material>(entities[0]), &world.get<Material>(entities[3]));
    EXPECT_EQ(world.archetype_count(), 2u + 3u) << "the empty one, without a value, one per value";
    std::map<std::uint32_t, std::size_t> rows;
    Query<const Position, Shared<Material>> query;
    for (auto [positions, material] : query.chunks(world)) {
        static_assert(std::same_as<decltype(material), const Material>);
        rows[material.number] += positions.size();
    }
    EXPECT_EQ(rows, (std::map<std::uint32_t, std::size_t>{{0, 1000}, {1, 1000}, {2, 1000}}));
    query.each(world, [](const Position& position, const Material& material) {
        ASSERT_EQ(static_cast<std::uint32_t>(position.x) % 3, material.number);
    });
}

TEST(SharedValue, ChangingItMovesTheEntity) {
    World world;
    const Entity entity = world.create(Position{1, 2, 3});
    const Entity other = world.create(Position{}, Material{1});
    world.add(entity, Material{1});
    EXPECT_EQ(&world.get<Material>(entity), &world.get<Material>(other)) << "they live together now";
    world.add(entity, Material{2});
    EXPECT_EQ(world.get<Material>(entity).number, 2u);
    EXPECT_EQ(world.get<Material>(other).number, 1u);
    EXPECT_EQ(world.get<Position>(entity), (Position{1, 2, 3}));
    const std::size_t archetypes = world.archetype_count();
    world.add(entity, Frozen{});
    EXPECT_EQ(world.get<Material>(entity).number, 2u) << "kept when another component comes";
    world.remove<Material>(entity);
    EXPECT_FALSE(world.has<Material>(entity));
    EXPECT_TRUE(world.has<Frozen>(entity));
    EXPECT_EQ(world.try_get<Material>(entity), nullptr);
    EXPECT_THROW(world.remove<Material>(entity), Misuse);
    EXPECT_THROW((void)world.get<Material>(entity), Misuse);
    world.add(entity, Material{1});
    world.remove<Frozen>(entity);
    EXPECT_EQ(&world.get<Material>(entity), &world.get<Material>(other));
    EXPECT_EQ(world.archetype_count(), archetypes + 3) << "frozen with 2, frozen, frozen with 1";
}

TEST(SharedValue, IsFoundByEveryFilter) {
    World world;
    const Entity plain = world.create(Position{});
    const Entity red = world.create(Position{}, Material{1});
    const Entity tinted = world.create(Tint{1, 0.5}, Material{1});
    const auto found = [&](auto query) {
        std::vector<Entity> entities;
        query.each(world, [&](Entity entity) { entities.push_back(entity); });
        return entities;
    };
    EXPECT_EQ(found(Query<Entity, With<Material>>{}), (std::vector{red, tinted}));
    EXPECT_EQ(found(Query<Entity, Without<Material>>{}), (std::vector{plain}));
    EXPECT_EQ(found(Query<Entity, AnyOf<Tint, Frozen>>{}), (std::vector{tinted}));
    EXPECT_EQ((Query<Shared<Material>, Shared<Tint>>{}.count(world)), 1u);
}

TEST(SharedValue, IsTheSameIfEqualOrOfTheSameBytes) {
    BlockPool pool;
    SharedValues values{pool};
    const auto intern = [&](const Tint& tint) {
        return &values.intern(0, component_info<Tint>(), &tint);
    };
    alignas(Tint) std::byte other_padding[sizeof(Tint)];
    std::memset(other_padding, 0xff, sizeof(Tint));
    Tint* tint = new (other_padding) Tint{3, 0.0};
    std::memset(other_padding + 1, 0xff, offsetof(Tint, strength) - 1);
    const SharedValue* zero = intern({3, 0.0});
    EXPECT_EQ(intern(*tint), zero) << "padding does not count";
    EXPECT_EQ(intern({3, -0.0}), zero) << "−0 equals 0";
    EXPECT_NE(intern({3, 1.0}), zero) << "though the hash is the same";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Tint undefined;  // in the same bytes each time, padding included
    std::memset(static_cast<void*>(&undefined), 0, sizeof(undefined));
    undefined.strength = nan;
    const SharedValue* first = intern(undefined);
    EXPECT_EQ(intern(undefined), first) << "equal to nothing, but of the same bytes";
    EXPECT_EQ(values.all().size(), 3u);
    EXPECT_NE(&values.intern(1, component_info<Material>(), &undefined), zero) << "another component";
}

TEST(SharedValue, GoesThroughCommands) {
    World world;
    const Entity red = world.create(Position{1, 0, 0}, Material{1});
    const Entity plain = world.create(Position{2, 0, 0});
    Commands commands;
    commands.add(plain, Material{1});
    commands.add(plain, Velocity{3, 0, 0});
    commands.add(red, Material{2});
    commands.add(red, Material{3});
    const Entity placeholder = commands.create(Material{2}, Position{4, 0, 0});
    commands.apply(world);
    EXPECT_EQ(world.get<Material>(plain).number, 1u);
    EXPECT_EQ(world.get<Velocity>(plain).x, 3.0f);
    EXPECT_EQ(world.get<Material>(red).number, 3u) << "the last one";
    EXPECT_EQ(world.get<Position>(red).x, 1.0f);
    EXPECT_EQ(world.get<Material>(commands.created(placeholder)).number, 2u);
    commands.remove<Material>(red);
    commands.remove<Material>(red);
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 1u);
    EXPECT_EQ(playback.dropped, 1u);
    EXPECT_FALSE(world.has<Material>(red));
}

TEST(SharedValue, ChangingBetweenKnownValuesDoesNotAllocate) {
    World world;
    const Entity entity = world.create(Position{}, Material{0});
    for (std::uint32_t i = 0; i < 10; ++i)
        world.add(entity, Material{i % 4});
    const std::size_t before = rambla::test::allocation_count();
    for (std::uint32_t i = 0; i < 100; ++i)
        world.add(entity, Material{i % 4});
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::ecs
