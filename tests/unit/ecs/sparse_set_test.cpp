#include "ecs/sparse_set.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

TEST(SparseSet, AgreesWithAMapAndKeepsValuesWhereTheyAre) {
    {
        BlockPool pool;
        SparseSet set{pool, component_info<SparseAnchored>()};
        std::map<std::uint32_t, int> expected;
        std::mt19937 random{1};
        for (int step = 0; step < 20'000; ++step) {
            const Entity entity{static_cast<std::uint32_t>(random() % 5000), 1};
            if (const auto found = expected.find(entity.index); found == expected.end()) {
                ASSERT_EQ(set.find(entity), SparseSet::k_none);
                std::construct_at(reinterpret_cast<SparseAnchored*>(set.value(set.insert(entity, 1))), step);
                expected[entity.index] = step;
            } else {
                const auto* value = reinterpret_cast<const Anchored*>(set.value(set.find(entity)));
                ASSERT_TRUE(value->intact());
                ASSERT_EQ(value->number(), found->second);
                ASSERT_EQ(set.find({entity.index, 2}), SparseSet::k_none) << "another generation";
                set.erase(set.find(entity), 2);
                expected.erase(found);
            }
        }
        ASSERT_EQ(set.size(), expected.size());
        ASSERT_EQ(Anchored::alive, static_cast<int>(expected.size()));
        set.compact();
        for (const auto& [index, number] : expected)
            ASSERT_EQ(reinterpret_cast<const Anchored*>(set.value(set.find({index, 1})))->number(), number);
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(SparseSet, OrderDependsOnlyOnTheCalls) {
    BlockPool pool;
    SparseSet set{pool, component_info<Selected>()};
    for (std::uint32_t index : {7u, 3u, 100'000u, 5u})
        set.insert({index, 1}, 1);
    set.erase(set.find({7, 1}), 1);
    const std::vector<Entity> order{set.entities().begin(), set.entities().end()};
    EXPECT_EQ(order, (std::vector<Entity>{{5, 1}, {3, 1}, {100'000, 1}})) << "the last one closes the gap";
}

TEST(SparseComponent, ComesAndGoesWithoutMovingTheEntity) {
    World world;
    const Entity entity = world.create(Position{1, 2, 3});
    const Entity other = world.create(Position{}, Burning{3}, Selected{});
    const Position* position = &world.get<Position>(entity);
    const std::size_t archetypes = world.archetype_count();
    world.add(entity, Burning{7});
    world.add<Selected>(entity);
    EXPECT_EQ(world.archetype_count(), archetypes) << "both are in the archetype of Position";
    EXPECT_EQ(&world.get<Position>(entity), position);
    EXPECT_EQ(world.get<Burning>(entity).heat, 7);
    EXPECT_EQ(world.get<Burning>(other).heat, 3);
    EXPECT_TRUE(world.has<Selected>(entity) && world.has<Burning>(entity));
    world.add(entity, Burning{8});
    world.get_mut<Burning>(entity).heat += 1;
    EXPECT_EQ(world.get<Burning>(entity).heat, 9);
    world.remove<Burning>(entity);
    world.remove<Selected>(entity);
    EXPECT_FALSE(world.has<Burning>(entity));
    EXPECT_EQ(world.try_get<Burning>(entity), nullptr);
    EXPECT_TRUE(world.has<Selected>(other));
    EXPECT_THROW(world.remove<Burning>(entity), Misuse);
    EXPECT_THROW((void)world.get<Burning>(entity), Misuse);
    EXPECT_EQ(&world.get<Position>(entity), position);
}

TEST(SparseComponent, EndsWithItsEntityAndWithTheWorld) {
    {
        World world;
        const Entity first = world.create(SparseAnchored{1});
        const Entity second = world.create(SparseAnchored{2}, Position{});
        world.add(second, SparseAnchored{3});
        EXPECT_EQ(Anchored::alive, 2) << "the replaced one ended";
        world.destroy(first);
        EXPECT_EQ(Anchored::alive, 1);
        const Entity reused = world.create();
        EXPECT_EQ(reused.index, first.index);
        EXPECT_FALSE(world.has<SparseAnchored>(reused));
        EXPECT_TRUE(world.get<SparseAnchored>(second).intact());
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(SparseComponent, GoesThroughCommands) {
    World world;
    const Entity entity = world.create(Position{});
    Commands commands;
    commands.add(entity, Burning{1});
    commands.add(entity, Selected{});
    const Entity placeholder = commands.create(Burning{2}, Position{5, 0, 0}, SparseAnchored{4});
    commands.apply(world);
    const Entity made = commands.created(placeholder);
    EXPECT_EQ(world.get<Burning>(entity).heat, 1);
    EXPECT_TRUE(world.has<Selected>(entity));
    EXPECT_EQ(world.get<Burning>(made).heat, 2);
    EXPECT_EQ(world.get<Position>(made).x, 5.0f);
    EXPECT_EQ(world.get<SparseAnchored>(made).number(), 4);
    commands.remove<Burning>(entity);
    commands.remove<SparseAnchored>(entity);
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 1u);
    EXPECT_EQ(playback.dropped, 1u) << "what is not there cannot be removed";
    EXPECT_FALSE(world.has<Burning>(entity));
    EXPECT_EQ(Anchored::alive, 1);
}

}  // namespace
}  // namespace rambla::ecs
