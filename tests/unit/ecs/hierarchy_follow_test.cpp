#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "ecs/hierarchy.h"
#include "ecs/query.h"
#include "ecs/schedule.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;
using ::testing::ElementsAre;

struct HierarchyFollows : ::testing::Test {
    World world;
    Hierarchy hierarchy{world};

    HierarchyFollows() { hierarchy.follow_ends(); }
    Entity child_of(Entity parent, OnParentEnd on_end = OnParentEnd::destroyed) {
        return world.create(Parent{parent, on_end});
    }
    bool is_root(Entity entity) { return world.alive(entity) && !world.has<Parent>(entity); }
};

/// Ends one entity by some way of ending entities.
using End = std::function<void(World&, Entity)>;
const std::vector<std::pair<const char*, End>> k_ways{
    {"World::destroy",
     [](World& world, Entity entity) {
         world.destroy(entity);
     }},
    {"Commands",
     [](World& world, Entity entity) {
         Commands commands;
         commands.destroy(entity);
         commands.apply(world);
     }},
    {"commands for all entities",
     [](World& world, Entity entity) {
         world.add(entity, Frozen{});
         Commands commands;
         commands.destroy_all<With<Frozen>>();
         commands.apply(world);
     }},
    {"the commands of a system",
     [](World& world, Entity entity) {
         Schedule schedule{{.threads = 1}};
         schedule.add("end", [entity](Commands& commands) { commands.destroy(entity); });
         schedule.sync();
         schedule.add("look", [entity](View<const Parent> children) {
             children.each([&](const Parent& parent) { EXPECT_NE(parent.entity, entity); });
         });
         schedule.run(world);
     }},
    {"a system that has the world for itself",
     [](World& world, Entity entity) {
         Schedule schedule;
         schedule.add("end", [entity](World& all) { all.destroy(entity); });
         schedule.run(world);
     }},
};

TEST(HierarchyFollowsEnds, WhateverWayAParentEndsWithPoliciesMixed) {
    for (const auto& [way, end] : k_ways) {
        World world;
        Hierarchy hierarchy{world};
        hierarchy.follow_ends();
        const auto child_of = [&](Entity parent, OnParentEnd on_end = OnParentEnd::destroyed) {
            return world.create(Parent{parent, on_end});
        };
        const Entity root = world.create(), other = world.create();
        const Entity ends = child_of(root), below = child_of(ends);
        const Entity freed = child_of(root, OnParentEnd::freed), kept = child_of(freed);
        const Entity freed_deep = child_of(below, OnParentEnd::freed), not_asked = child_of(other);
        end(world, root);
        EXPECT_FALSE(world.alive(root)) << way;
        EXPECT_FALSE(world.alive(ends)) << way;
        EXPECT_FALSE(world.alive(below)) << way;
        EXPECT_TRUE(world.alive(freed) && !world.has<Parent>(freed)) << way;
        EXPECT_TRUE(world.alive(freed_deep) && !world.has<Parent>(freed_deep)) << way;
        EXPECT_EQ(world.get<Parent>(kept).entity, freed) << way;
        EXPECT_EQ(world.get<Parent>(not_asked).entity, other) << way;
        EXPECT_EQ(world.entity_count(), 5u) << way;
    }
}

TEST_F(HierarchyFollows, ChainsOf100000End) {
    const Entity root = world.create();
    Entity last = root;
    for (int i = 0; i < 100'000; ++i)
        last = child_of(last, i == 60'000 ? OnParentEnd::freed : OnParentEnd::destroyed);
    world.destroy(root);
    EXPECT_EQ(world.entity_count(), 40'000u) << "the one that was freed, and what hangs from it";
}

TEST_F(HierarchyFollows, AChildWhoseOwnCommandEndsItInTheSamePlaybackEndsOnce) {
    const Entity root = world.create();
    const Entity ended = child_of(root), below = child_of(ended), sibling = child_of(root);
    const Entity saved = child_of(root), moved = child_of(root), home = world.create();
    Commands commands;
    commands.destroy(root);
    commands.destroy(ended);
    commands.remove<Parent>(saved);
    commands.add(moved, Parent{home});
    const Playback playback = commands.apply(world);
    EXPECT_EQ(playback.applied, 4u);
    EXPECT_EQ(playback.dropped, 0u);
    EXPECT_FALSE(world.alive(ended) || world.alive(below) || world.alive(sibling));
    EXPECT_TRUE(is_root(saved));
    EXPECT_EQ(world.get<Parent>(moved).entity, home) << "what counts is what the playback left";
    EXPECT_EQ(world.entity_count(), 3u);
}

TEST_F(HierarchyFollows, AChildMadeForAParentThatEndsInTheSamePlaybackEnds) {
    Commands commands;
    const Entity parent = commands.create();
    commands.create(Parent{parent});
    commands.create(Parent{parent, OnParentEnd::freed}, Health{7});
    commands.destroy(parent);
    commands.apply(world);
    EXPECT_EQ(world.entity_count(), 1u);
    Query<Entity, const Health> freed;
    freed.each(world, [&](Entity entity, const Health&) { EXPECT_TRUE(is_root(entity)); });
}

TEST_F(HierarchyFollows, AnEndedParentGivenLaterCountsWithTheNextEnd) {
    const Entity parent = world.create(), other = world.create();
    world.destroy(parent);
    const Entity late = child_of(parent);
    EXPECT_TRUE(world.alive(late));
    world.create(Health{});
    EXPECT_TRUE(world.alive(late)) << "nothing ended";
    world.destroy(other);
    EXPECT_FALSE(world.alive(late));
}

TEST_F(HierarchyFollows, AnEntityThatHangsFromItselfIsNoOrphan) {
    const Entity ring = world.create(Parent{}), other = world.create();
    world.get_mut<Parent>(ring).entity = ring;
    world.destroy(other);
    EXPECT_TRUE(world.alive(ring));
}

TEST_F(HierarchyFollows, ObserversAreToldOfChildrenAndMayEndThemThemselves) {
    std::vector<int> told;
    const Entity root = world.create(Health{1});
    const Entity first = world.create(Health{2}, Parent{root});
    world.create(Health{3}, Parent{first});
    world.create(Health{4}, Parent{root, OnParentEnd::freed});
    world.observers().on_remove<Health>([&](Entity entity, const Health& health, Commands& later) {
        told.push_back(health.points);
        if (entity == root) later.destroy(first);
    });
    world.destroy(root);
    EXPECT_THAT(told, ElementsAre(1, 2, 3));
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST_F(HierarchyFollows, OrphansThatAnExceptionLeftEndWithTheNextChange) {
    const Entity root = world.create(Health{1}), other = world.create();
    const Entity child = child_of(root);
    const ObserverId thrower =
        world.observers().on_remove<Health>([](Entity, const Health&) { throw std::runtime_error{"no"}; });
    EXPECT_THROW(world.destroy(root), std::runtime_error);
    EXPECT_TRUE(world.alive(child));
    world.observers().end(thrower);
    world.destroy(other);
    EXPECT_FALSE(world.alive(child));
}

TEST_F(HierarchyFollows, ItsOwnDestroyEndsEachOnce) {
    const Entity root = world.create();
    child_of(child_of(root));
    child_of(root, OnParentEnd::freed);
    EXPECT_EQ(hierarchy.destroy(root), 3u);
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_EQ(hierarchy.end_orphans(), 0u);
}

TEST_F(HierarchyFollows, AMillionChildrenEndInOnePlayback) {
    const Entity root = world.create();
    for (int i = 0; i < 1'000'000; ++i)
        child_of(root);
    world.destroy(root);
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST_F(HierarchyFollows, EndsOfEntitiesWithoutChildrenAllocateNothingInASteadyState) {
    const auto make_and_end = [&] {
        for (int i = 0; i < 100; ++i)
            world.destroy(world.create(Health{}));
    };
    child_of(world.create());
    make_and_end();
    const std::size_t before = rambla::test::allocation_count();
    make_and_end();
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

TEST(HierarchyFollowsEnds, OnlyWhereItWasAskedToAndOnlyAsLongAsItLives) {
    World world;
    const auto orphan_lives = [&] {
        const Entity root = world.create();
        const Entity child = world.create(Parent{root});
        world.destroy(root);
        return world.alive(child);
    };
    {
        Hierarchy hierarchy{world};
        EXPECT_TRUE(orphan_lives());
        hierarchy.follow_ends();
        EXPECT_THROW(hierarchy.follow_ends(), Misuse);
        EXPECT_FALSE(orphan_lives());
        EXPECT_EQ(world.observers().size(), 0u) << "it is none of theirs";
    }
    EXPECT_TRUE(orphan_lives());
}

/// Against a model that knows only who hangs from whom: ends come in playbacks of several kinds of commands.
TEST(HierarchyFollowsEnds, EqualANaiveModelUnderRandomPlaybacks) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        World world;
        Hierarchy hierarchy{world};
        hierarchy.follow_ends();
        std::mt19937 engine{seed};
        struct Known {
            Entity entity, parent;
            OnParentEnd on_end;
        };
        std::vector<Known> known;
        for (int step = 0; step < 60; ++step) {
            Commands commands;
            for (int i = 0; i < 12; ++i) {
                const OnParentEnd on_end = engine() % 4 == 0 ? OnParentEnd::freed : OnParentEnd::destroyed;
                const Entity parent =
                    known.empty() || engine() % 3 == 0 ? Entity{} : known[engine() % known.size()].entity;
                known.push_back({parent == Entity{} ? world.create() : world.create(Parent{parent, on_end}),
                                 parent, on_end});
            }
            std::vector<Entity> ended;
            for (int i = 0; i < 3; ++i)
                ended.push_back(known[engine() % known.size()].entity);
            if (engine() % 2 == 0) {
                commands.destroy_many(ended);
            } else {
                for (const Entity entity : ended)
                    world.add(entity, Frozen{});
                commands.destroy_all<With<Frozen>>();
            }
            commands.apply(world);
            for (std::size_t i = 0; i < ended.size(); ++i) {
                for (Known& one : known) {
                    if (one.parent != ended[i] || one.parent == Entity{}) continue;
                    if (one.on_end == OnParentEnd::destroyed)
                        ended.push_back(one.entity);
                    else if (std::ranges::find(ended, one.entity) == ended.end())
                        one.parent = {};
                }
            }
            std::erase_if(
                known, [&](const Known& one) { return std::ranges::find(ended, one.entity) != ended.end(); });
            ASSERT_EQ(world.entity_count(), known.size()) << "seed " << seed << ", step " << step;
            for (const Known& one : known) {
                const Parent* parent = world.try_get<Parent>(one.entity);
                ASSERT_EQ(parent == nullptr ? Entity{} : parent->entity, one.parent);
            }
        }
    }
}

// Each end lets the next one lose its parent: the observer only writes a value, and what ends without end is
// recorded by the hierarchy.
TEST(HierarchyFollow, EndsWithoutEndAreRefusedByName) {
    World world;
    Hierarchy hierarchy{world};
    const Entity safe = world.create();
    std::vector<Entity> chain;
    for (int i = 0; i < 60; ++i)
        chain.push_back(world.create(Parent{safe, OnParentEnd::destroyed}, Health{i}));
    world.observers().on_remove<Health>([&](Entity dying, const Health& health) {
        const auto next = static_cast<std::size_t>(health.points) + 1;
        if (next < chain.size()) world.get_mut<Parent>(chain[next]).entity = dying;
    });
    hierarchy.follow_ends();
    EXPECT_THAT([&] { world.destroy(chain[0]); },
                ::testing::ThrowsMessage<Misuse>(::testing::HasSubstr("Hierarchy::follow_ends")));
    EXPECT_TRUE(world.alive(safe));
    EXPECT_FALSE(world.alive(chain[0]));
    EXPECT_TRUE(world.alive(chain.back()));
}

TEST(HierarchyFollow, MayBeAResourceOfItsWorld) {
    World world;
    world.set_resource(std::make_unique<Hierarchy>(world));
    world.resource<std::unique_ptr<Hierarchy>>()->follow_ends();
    const Entity parent = world.create();
    const Entity child = world.create(Parent{parent, OnParentEnd::destroyed});
    world.destroy(parent);
    EXPECT_FALSE(world.alive(child));
}

}  // namespace
}  // namespace rambla::ecs
