#include "ecs/hierarchy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "ecs/observers.h"
#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct HierarchyOf : ::testing::Test {
    World world;
    Hierarchy hierarchy{world};

    std::vector<Entity> children(Entity entity) {
        hierarchy.update();
        const auto range = hierarchy.children(entity);
        return {range.begin(), range.end()};
    }
    std::vector<Entity> ancestors(Entity entity) const {
        std::vector<Entity> found;
        for (const Entity ancestor : hierarchy.ancestors(entity))
            found.push_back(ancestor);
        return found;
    }
    Entity child_of(Entity parent, OnParentEnd on_end = OnParentEnd::destroyed) {
        return world.create(Parent{parent, on_end});
    }
};

using HierarchyLinks = HierarchyOf;
using HierarchyEnds = HierarchyOf;

TEST_F(HierarchyLinks, TellsChildrenAncestorsAndDepth) {
    const Entity root = world.create();
    const Entity a = child_of(root);
    const Entity b = child_of(root);
    const Entity grandchild = child_of(a);
    EXPECT_THAT(children(root), ElementsAre(a, b));
    EXPECT_THAT(children(a), ElementsAre(grandchild));
    EXPECT_THAT(children(grandchild), IsEmpty());
    EXPECT_THAT(ancestors(grandchild), ElementsAre(a, root));
    EXPECT_EQ(hierarchy.depth(grandchild), 2u);
    EXPECT_EQ(hierarchy.depth(root), 0u);
}

TEST_F(HierarchyLinks, ParentsDoNotTellArchetypesApart) {
    const Entity root = world.create();
    child_of(root);
    const std::size_t before = world.archetype_count();
    for (int i = 0; i < 100; ++i)
        child_of(child_of(world.create()));
    EXPECT_EQ(world.archetype_count(), before);
}

TEST_F(HierarchyLinks, FollowWhatIsWrittenPastThem) {
    const Entity a = world.create(), b = world.create();
    const Entity child = child_of(a);
    EXPECT_THAT(children(a), ElementsAre(child));
    world.get_mut<Parent>(child).entity = b;
    EXPECT_THAT(children(a), IsEmpty());
    EXPECT_THAT(children(b), ElementsAre(child));
    world.remove<Parent>(child);
    EXPECT_THAT(children(b), IsEmpty());
    world.add(child, Parent{a});
    EXPECT_THAT(children(a), ElementsAre(child));
    world.destroy(child);
    EXPECT_THAT(children(a), IsEmpty());
}

TEST_F(HierarchyLinks, SeeWritesInTheVersionOfTheirUpdate) {
    const Entity a = world.create(), b = world.create();
    const Entity child = child_of(a);
    hierarchy.update();
    world.get_mut<Parent>(child).entity = b;  // nobody ended the version in between
    EXPECT_THAT(children(b), ElementsAre(child));
}

TEST_F(HierarchyLinks, SurviveRowsThatMove) {
    const Entity root = world.create();
    std::vector<Entity> all;
    for (int i = 0; i < 3000; ++i)
        all.push_back(child_of(root));
    EXPECT_EQ(children(root), all);
    for (int i = 0; i < 2999; ++i)
        world.destroy(all[static_cast<std::size_t>(i)]);  // each time the last row fills the gap
    EXPECT_THAT(children(root), ElementsAre(all.back()));
    world.add(all.back(), Health{});
    EXPECT_THAT(children(root), ElementsAre(all.back()));
}

TEST_F(HierarchyLinks, AParentWhoseNumberIsUsedAgainHasNoOldChildren) {
    const Entity first = world.create();
    const Entity child = child_of(first);
    hierarchy.update();
    world.destroy(first);
    const Entity second = world.create();
    ASSERT_EQ(second.index, first.index);
    EXPECT_THAT(children(second), IsEmpty());
    EXPECT_THAT(ancestors(child), IsEmpty());
}

TEST_F(HierarchyLinks, SetParentRefusesRingsAndNamesThem) {
    const Entity a = world.create();
    const Entity b = child_of(a);
    const Entity c = child_of(b);
    try {
        hierarchy.set_parent(a, c);
        FAIL() << "made a ring";
    } catch (const Misuse& misuse) {
        EXPECT_THAT(misuse.what(), HasSubstr("ring"));
        EXPECT_THAT(misuse.what(), HasSubstr(to_string(a) + " hangs from " + to_string(c) + ", that from " +
                                             to_string(b) + ", that from " + to_string(a)));
    }
    EXPECT_FALSE(world.has<Parent>(a));
    EXPECT_THROW(hierarchy.set_parent(a, a), Misuse);
}

TEST_F(HierarchyLinks, SetParentMovesAndFreesSubtrees) {
    const Entity a = world.create(), b = world.create();
    const Entity child = world.create(), grandchild = world.create();
    hierarchy.set_parent(child, a);
    hierarchy.set_parent(grandchild, child);
    hierarchy.set_parent(child, b, OnParentEnd::freed);
    EXPECT_THAT(ancestors(grandchild), ElementsAre(child, b));
    EXPECT_EQ(world.get<Parent>(child).on_end, OnParentEnd::freed);
    hierarchy.set_parent(child, {});
    EXPECT_FALSE(world.has<Parent>(child));
    world.destroy(b);
    EXPECT_THROW(hierarchy.set_parent(child, b), Misuse);
    EXPECT_THROW(hierarchy.set_parent(b, child), Misuse);
}

TEST_F(HierarchyLinks, RingsWrittenByHandAreReportedNotWalkedForEver) {
    const Entity a = world.create(Parent{});
    const Entity b = child_of(a), c = child_of(b), below = child_of(c);
    world.get_mut<Parent>(a).entity = c;
    EXPECT_THROW(ancestors(below), Misuse);
    EXPECT_THROW((void)hierarchy.depth(a), Misuse);
    EXPECT_THROW(hierarchy.set_parent(world.create(), below), Misuse);
    EXPECT_THAT(children(c), ::testing::UnorderedElementsAre(below, a));
    EXPECT_EQ(hierarchy.destroy(b), 4u);
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST_F(HierarchyLinks, ChainsOf100000AreNeitherRecursedNorWalkedEachTime) {
    std::vector<Entity> chain{world.create()};
    for (int i = 0; i < 100'000; ++i) {
        chain.push_back(world.create());
        hierarchy.set_parent(chain.back(), chain[chain.size() - 2]);
    }
    EXPECT_EQ(hierarchy.depth(chain.back()), 100'000u);
    EXPECT_THROW(hierarchy.set_parent(chain.front(), chain.back()), Misuse);
    EXPECT_EQ(hierarchy.destroy(chain[50'000]), 50'001u);
    EXPECT_EQ(world.entity_count(), 50'000u);
}

TEST_F(HierarchyLinks, AMillionChildrenOfOneRootAreJustMany) {
    const Entity root = world.create();
    for (int i = 0; i < 1'000'000; ++i)
        child_of(root);
    EXPECT_EQ(children(root).size(), 1'000'000u);
    child_of(root);
    EXPECT_EQ(children(root).size(), 1'000'001u);
    EXPECT_EQ(hierarchy.destroy(root), 1'000'002u);
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST_F(HierarchyLinks, AnUpdateWithoutChangesAllocatesNothing) {
    const Entity root = world.create();
    for (int i = 0; i < 5000; ++i)
        child_of(root);
    hierarchy.update();
    const std::size_t before = rambla::test::allocation_count();
    hierarchy.update();
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

TEST_F(HierarchyEnds, DestroyingAParentEndsOrFreesEachChildAsItSays) {
    const Entity root = world.create();
    const Entity ends = child_of(root), below = child_of(ends);
    const Entity freed = child_of(root, OnParentEnd::freed), kept = child_of(freed);
    const Entity freed_deep = child_of(below, OnParentEnd::freed);
    EXPECT_EQ(hierarchy.destroy(root), 3u);
    EXPECT_FALSE(world.alive(ends));
    EXPECT_FALSE(world.alive(below));
    EXPECT_FALSE(world.has<Parent>(freed));
    EXPECT_FALSE(world.has<Parent>(freed_deep));
    EXPECT_EQ(world.get<Parent>(kept).entity, freed);
    EXPECT_THROW(hierarchy.destroy(root), Misuse);
}

TEST_F(HierarchyEnds, OrphansOfPlainDestructionAndOfCommandsEndToo) {
    const Entity a = world.create(), b = world.create();
    const Entity of_a = child_of(a), below_a = child_of(of_a);
    const Entity of_b = child_of(b, OnParentEnd::freed);
    world.destroy(a);
    EXPECT_TRUE(world.alive(of_a)) << "the world alone does not know of trees";
    EXPECT_EQ(hierarchy.end_orphans(), 2u);
    EXPECT_FALSE(world.alive(below_a));
    Commands commands;
    commands.destroy(b);
    const Entity late_parent = commands.create();
    commands.create(Parent{late_parent}, Health{7});
    commands.destroy(late_parent);
    hierarchy.apply(commands);
    EXPECT_TRUE(world.alive(of_b));
    EXPECT_FALSE(world.has<Parent>(of_b));
    EXPECT_EQ(world.entity_count(), 1u) << "a child made for a parent that ended in the same playback ends";
    EXPECT_EQ(hierarchy.end_orphans(), 0u);
}

TEST_F(HierarchyEnds, OrphansFoundByAnEarlierUpdateAreRemembered) {
    const Entity a = world.create();
    const Entity child = child_of(a);
    world.destroy(a);
    hierarchy.update();
    hierarchy.update();
    EXPECT_EQ(hierarchy.end_orphans(), 1u);
    EXPECT_FALSE(world.alive(child));
}

TEST_F(HierarchyEnds, TheOrderDoesNotDependOnWhenUpdatesRan) {
    const auto after_destruction = [](bool update_in_between) {
        World made;
        Hierarchy trees{made};
        const Entity root = made.create();
        std::vector<Entity> children;
        for (int i = 0; i < 50; ++i)
            children.push_back(made.create());
        for (std::size_t i = children.size(); i-- > 0;) {
            made.add(children[i], Parent{root});
            if (update_in_between) trees.update();
        }
        trees.destroy(root);
        std::vector<Entity> next;
        for (int i = 0; i < 51; ++i)
            next.push_back(made.create());  // reuses slots in the order in which they were freed
        return next;
    };
    EXPECT_EQ(after_destruction(true), after_destruction(false));
}

TEST_F(HierarchyEnds, NothingEndsWhileTheWorldIsWalkedOver) {
    const Entity root = world.create(Health{});
    const Entity child = child_of(root);
    Query<const Health> query;
    for ([[maybe_unused]] const auto& chunk : query.chunks(world))
        EXPECT_THROW(hierarchy.destroy(root), Misuse);
    EXPECT_TRUE(world.alive(child));
    EXPECT_EQ(hierarchy.destroy(root), 2u);
}

/// Against a model that knows only who hangs from whom.
TEST_F(HierarchyEnds, EqualsANaiveModelUnderRandomChanges) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        World made;
        Hierarchy trees{made};
        std::mt19937 engine{seed};
        struct Known {
            Entity entity, parent;
            OnParentEnd on_end;
        };
        std::vector<Known> known;
        const auto index_of = [&](Entity entity) {
            return static_cast<std::size_t>(std::ranges::find(known, entity, &Known::entity) - known.begin());
        };
        const auto hangs_from = [&](Entity entity, Entity above) {
            while (entity != Entity{} && entity != above)
                entity = known[index_of(entity)].parent;
            return entity == above;
        };
        for (int step = 0; step < 300; ++step) {
            const std::uint32_t what = engine() % 10;
            const std::size_t a = known.empty() ? 0 : engine() % known.size();
            const std::size_t b = known.empty() ? 0 : engine() % known.size();
            const OnParentEnd on_end = engine() % 4 == 0 ? OnParentEnd::freed : OnParentEnd::destroyed;
            if (known.empty() || what < 4) {
                known.push_back({made.create(), {}, on_end});
            } else if (what < 8) {
                if (hangs_from(known[b].entity, known[a].entity)) {
                    EXPECT_THROW(trees.set_parent(known[a].entity, known[b].entity), Misuse);
                } else {
                    trees.set_parent(known[a].entity, known[b].entity, on_end);
                    known[a].parent = known[b].entity;
                    known[a].on_end = on_end;
                }
            } else if (what == 8) {
                trees.set_parent(known[a].entity, {});
                known[a].parent = {};
            } else {
                const Entity top = known[a].entity;
                if (engine() % 2 == 0) {
                    trees.destroy(top);
                } else {
                    made.destroy(top);
                    trees.end_orphans();
                }
                std::vector<Entity> ended{top};
                for (std::size_t i = 0; i < ended.size(); ++i) {
                    for (Known& one : known) {
                        if (one.parent != ended[i]) continue;
                        if (one.on_end == OnParentEnd::destroyed) ended.push_back(one.entity);
                        one.parent = {};
                    }
                }
                std::erase_if(known, [&](const Known& one) {
                    return std::ranges::find(ended, one.entity) != ended.end();
                });
            }
            trees.update();
            ASSERT_EQ(made.entity_count(), known.size()) << "seed " << seed << ", step " << step;
            for (const Known& one : known) {
                const Parent* parent = made.try_get<Parent>(one.entity);
                ASSERT_EQ(parent == nullptr ? Entity{} : parent->entity, one.parent);
                std::size_t children = 0;
                for (const Entity child : trees.children(one.entity)) {
                    ASSERT_EQ(known[index_of(child)].parent, one.entity);
                    ++children;
                }
                ASSERT_EQ(children,
                          static_cast<std::size_t>(std::ranges::count(known, one.entity, &Known::parent)));
            }
        }
    }
}

TEST(HierarchyAndObservers, WhatAnObserverEndedIsNotEndedTwice) {
    World world;
    const Entity root = world.create(Health{1});
    const Entity first = world.create(Parent{root});
    const Entity second = world.create(Parent{root});
    world.observers().on_remove<Health>(
        [&](Entity, const Health&, Commands& later) { later.destroy(first); });
    Hierarchy hierarchy{world};
    EXPECT_EQ(hierarchy.destroy(root), 3u);
    for (Entity entity : {root, first, second})
        EXPECT_FALSE(world.alive(entity));
}

TEST(HierarchyAndObservers, AnObserverCannotEndTreesOfItsOwnMeanwhile) {
    World world;
    Hierarchy hierarchy{world};
    const Entity root = world.create(Health{1}), other = world.create();
    for (int i = 0; i < 100; ++i)
        world.create(Health{2}, Parent{root, i % 2 == 0 ? OnParentEnd::destroyed : OnParentEnd::freed});
    for (int i = 0; i < 3000; ++i)
        world.create(Parent{other});
    std::vector<std::string> refusals;
    const auto refuse = [&](const auto& call) {
        try {
            call();
        } catch (const Misuse& misuse) {
            refusals.emplace_back(misuse.what());
        }
    };
    world.observers().on_remove<Health>([&](Entity entity, const Health&) {
        if (entity != root) return;
        refuse([&] { hierarchy.destroy(other); });
        refuse([&] { hierarchy.end_orphans(); });
    });
    EXPECT_EQ(hierarchy.destroy(root), 51u);
    ASSERT_EQ(refusals.size(), 2u);
    EXPECT_NE(refusals[0].find("Hierarchy::destroy"), std::string::npos) << refusals[0];
    EXPECT_NE(refusals[1].find("Hierarchy::end_orphans"), std::string::npos) << refusals[1];
    EXPECT_EQ(world.entity_count(), 3051u);
}

}  // namespace
}  // namespace rambla::ecs
