#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include "ecs/hierarchy.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"
#include "unit/ecs/paths.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Trees of which the hierarchy has seen one part, and the rest only when something ends.
struct Forest {
    World world;
    Hierarchy hierarchy{world};
    Entity root = world.create(Health{});
    std::vector<Entity> middle, leaves, freed;
    Entity other = world.create(Health{});
    Entity below_other = world.create(Parent{other});
    Entity last = world.create(Health{});
    Entity below_last = world.create(Parent{last});
    Entity kept;  ///< a leaf that was hung below it

    Forest() {
        hierarchy.follow_ends();
        for (int i = 0; i < 20; ++i)
            middle.push_back(world.create(Health{i}, Parent{root}));
        for (int i = 0; i < 20; ++i)
            freed.push_back(world.create(Parent{middle[at(i)], OnParentEnd::freed}));
        grow<Position>(1100);
        hierarchy.update();
        grow<Velocity>(1500);
        world.get_mut<Parent>(leaves[3]).entity = below_last;
        kept = leaves[3];
    }
    [[nodiscard]] std::size_t at(int i) const { return static_cast<std::size_t>(i) % middle.size(); }
    template <class C>
    void grow(int count) {
        for (int i = 0; i < count; ++i)
            leaves.push_back(world.create(C{}, Parent{middle[at(i)]}));
    }

    /// Who must live once the root and what hangs from it have ended, and then `other`.
    void expect_ended(bool other_too) {
        const auto is_child = [&](Entity entity, Entity parent) {
            return world.alive(entity) && world.get<Parent>(entity).entity == parent;
        };
        EXPECT_FALSE(world.alive(root));
        EXPECT_EQ(world.alive(other), !other_too);
        EXPECT_EQ(world.alive(below_other), !other_too);
        EXPECT_TRUE(is_child(below_last, last));
        EXPECT_TRUE(is_child(kept, below_last));
        for (Entity entity : freed)
            EXPECT_TRUE(world.alive(entity) && !world.has<Parent>(entity));
        // freed, last, below_last and kept; other and below_other
        EXPECT_EQ(world.entity_count(), freed.size() + (other_too ? 3 : 5));
        hierarchy.update();
        std::size_t children = 0;
        for (const Entity entity : hierarchy.children(below_last)) {
            EXPECT_EQ(entity, kept);
            ++children;
        }
        EXPECT_EQ(children, 1u);
        EXPECT_TRUE(hierarchy.children(root).empty());
    }
};

/// Whether `change` ran into the allocation that was refused. `happened`: whether it came so far.
bool is_refused(std::size_t number, bool& happened, const std::function<void()>& change) {
    const rambla::test::FailingAllocation failing{number};
    bool refused = false;
    try {
        change();
    } catch (const std::bad_alloc&) {
        refused = true;
    } catch (const CapacityExceeded&) {
        refused = true;
    }
    happened = failing.happened();
    return refused;
}

/// Makes every allocation of the root's end fail in turn, then ends what is left by `go_on`.
void fail_everywhere(bool other_too, const std::function<void(Forest&)>& go_on) {
    bool happened = true;
    std::size_t refusals = 0;
    for (std::size_t number = 0; happened; ++number) {
        SCOPED_TRACE("allocation " + std::to_string(number));
        Forest forest;
        const std::size_t before = forest.world.entity_count();
        if (is_refused(number, happened, [&] { forest.world.destroy(forest.root); })) {
            ++refusals;
            EXPECT_FALSE(forest.world.alive(forest.root)) << "its own end needs no memory";
            // It may have been after the orphans' end, when whoever follows that was told.
            const std::size_t left = forest.world.alive(forest.middle[0]) ? before - 1 : 25;
            EXPECT_EQ(forest.world.entity_count(), left) << "not by halves";
        }
        go_on(forest);
        forest.expect_ended(other_too);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(refusals, 20u);
}

TEST(HierarchyOutOfMemory, OrphansEndWithTheNextEndOfAnotherEntity) {
    fail_everywhere(true, [](Forest& forest) { forest.world.destroy(forest.other); });
}

TEST(HierarchyOutOfMemory, OrphansEndWhenAskedTo) {
    fail_everywhere(false, [](Forest& forest) { forest.hierarchy.end_orphans(); });
}

TEST(HierarchyOutOfMemory, OrphansEndAfterTheNextEndFailedAsWell) {
    fail_everywhere(true, [](Forest& forest) {
        bool happened = false;
        is_refused(2, happened, [&] { forest.world.destroy(forest.other); });
        forest.hierarchy.end_orphans();
    });
}

TEST(HierarchyOutOfMemory, ResultsAreThoseOfAnUndisturbedPropagation) {
    bool happened = true;
    for (std::size_t number = 0; happened; ++number) {
        SCOPED_TRACE("allocation " + std::to_string(number));
        World world;
        Propagation<const Step, Path> propagation;
        const Entity top = world.create(Step{1}, Path{});
        const Entity second = world.create(Step{2}, Path{}, Parent{top});
        const Entity house = world.create(Path{7});
        const Entity door = world.create(Step{4}, Path{}, Parent{house});
        propagation(world, of_root, of_child);
        std::vector<Entity> chain{second};
        for (int i = 0; i < 1200; ++i)
            chain.push_back(world.create(Step{5}, Path{}, Parent{chain.back()}));
        world.get_mut<Parent>(second).entity = door;
        is_refused(number, happened, [&] { propagation(world, of_root, of_child); });
        propagation(world, of_root, of_child);
        Path expected = of_child(of_child(Path{7}, {4}), {2});
        EXPECT_EQ(world.get<Path>(second).value, expected.value);
        for (std::size_t i = 1; i < chain.size(); ++i) {
            expected = of_child(expected, {5});
            ASSERT_EQ(world.get<Path>(chain[i]).value, expected.value) << i;
        }
        if (testing::Test::HasFailure()) return;
    }
}

TEST(HierarchyMemory, CountsTheRecordingsThatItAndObserversKeep) {
    constexpr std::size_t k_children = 5000;
    World world;
    Hierarchy hierarchy{world};
    hierarchy.follow_ends();
    const auto make_tree = [&] {
        const Entity root = world.create();
        for (std::size_t i = 0; i < k_children; ++i)
            world.create(Parent{root});
        hierarchy.update();
        return root;
    };
    const Entity first = make_tree();
    const std::size_t observers = world.observers().memory_bytes(), all = world.memory_bytes();
    world.destroy(first);
    EXPECT_GE(world.observers().memory_bytes(), observers + k_children * sizeof(Entity));
    EXPECT_GE(world.memory_bytes(), all + k_children * sizeof(Entity));

    const Entity second = make_tree();
    const std::size_t held = hierarchy.memory_bytes();  // its lists have their size from the first tree
    EXPECT_EQ(hierarchy.destroy(second), k_children + 1);
    EXPECT_GE(hierarchy.memory_bytes(), held + k_children * sizeof(Entity));
}

}  // namespace
}  // namespace rambla::ecs
