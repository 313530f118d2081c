#include "ecs/propagation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "ecs/query.h"
#include "ecs/schedule.h"
#include "ecs/view.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

struct Step {
    std::uint64_t value = 0;
};
/// Depends on all steps from the root down and on their order.
struct Path {
    std::uint64_t value = 0;
    bool operator==(const Path&) const = default;
};

Path of_root(const Step& step) {
    return {step.value + 1};
}
Path of_child(const Path& parent, const Step& step) {
    return {parent.value * 6364136223846793005u + step.value + 1};
}

struct Paths : ::testing::Test {
    World world;
    Propagation<const Step, Path> propagation;
    std::atomic<int> calls{0};

    /// Returns how many members were visited.
    int propagate() {
        calls = 0;
        propagation(
            world,
            [&](const Step& step) {
                ++calls;
                return of_root(step);
            },
            [&](const Path& parent, const Step& step) {
                ++calls;
                return of_child(parent, step);
            });
        return calls;
    }
    Entity root(std::uint64_t step) { return world.create(Step{step}, Path{}); }
    Entity child(Entity parent, std::uint64_t step) {
        return world.create(Step{step}, Path{}, Parent{parent});
    }
    [[nodiscard]] std::uint64_t path(Entity entity) const { return world.get<Path>(entity).value; }
};

using PropagationTo = Paths;
using PropagationSkips = Paths;

/// Tries of 85: each node but the leaves has 4 children.
std::vector<Entity> tree(World& world, std::mt19937& engine) {
    std::vector<Entity> nodes{world.create(Step{engine() % 100}, Path{})};
    for (std::size_t i = 1; i < 85; ++i)
        nodes.push_back(world.create(Step{engine() % 100}, Path{}, Parent{nodes[(i - 1) / 4]}));
    return nodes;
}

TEST_F(PropagationTo, ChildrenComesAfterParentsInAnyOrderOfCreation) {
    const Entity grandchild = child({}, 3), middle = child({}, 2), top = root(1);
    world.get_mut<Parent>(grandchild).entity = middle;
    world.get_mut<Parent>(middle).entity = top;
    propagate();
    EXPECT_EQ(path(grandchild), of_child(of_child(of_root({1}), {2}), {3}).value);
}

TEST_F(PropagationTo, NullParentsMakeRoots) {
    const Entity entity = child({}, 4);
    propagate();
    EXPECT_EQ(path(entity), of_root({4}).value);
}

TEST_F(PropagationTo, ChainsOf100000) {
    std::vector<Entity> chain{root(0)};
    for (std::uint64_t i = 1; i <= 100'000; ++i)
        chain.push_back(child(chain.back(), i));
    propagate();
    Path expected = of_root({0});
    for (std::uint64_t i = 1; i <= 100'000; ++i)
        expected = of_child(expected, {i});
    EXPECT_EQ(path(chain.back()), expected.value);
    world.get_mut<Step>(chain[99'999]).value = 0;
    EXPECT_LE(propagate(), static_cast<int>(k_chunk_rows) + 2);
}

TEST_F(PropagationTo, AMillionChildrenOfOneRootOneByOne) {
    const Entity top = root(1);
    for (std::uint64_t i = 0; i < 1'000'000; ++i)
        child(top, i);
    EXPECT_EQ(propagate(), 1'000'001);
    for (std::uint64_t i = 0; i < 2000; ++i) {  // each costs a segment of the order, not the whole
        const Entity late = child(top, i);
        ASSERT_LE(propagate(), static_cast<int>(k_chunk_rows));
        ASSERT_EQ(path(late), of_child(of_root({1}), {i}).value);
    }
}

TEST_F(PropagationTo, ParentsThatAreNoMembersCountAsTheyAre) {
    const Entity house = world.create(Path{7});
    const Entity door = child(house, 1), handle = child(door, 2);
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({7}, {1}), {2}).value);
    world.get_mut<Path>(house).value = 8;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {2}).value);
    EXPECT_EQ(path(house), 8u);
    world.remove<Path>(house);
    world.get_mut<Step>(handle).value = 5;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {2}).value)
        << "rests while its parent has no result";
    world.add(house, Path{8});
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({8}, {1}), {5}).value) << "and catches up";
    world.add(house, Step{9});  // now a member, a root
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child(of_root({9}), {1}), {5}).value);
    world.remove<Step>(house);
    world.get_mut<Path>(house).value = 1;
    propagate();
    EXPECT_EQ(path(handle), of_child(of_child({1}, {1}), {5}).value);
}

TEST_F(PropagationTo, OrphansRest) {
    const Entity top = root(1), middle = child(top, 2), leaf = child(middle, 3);
    propagate();
    const std::uint64_t before = path(leaf);
    world.destroy(top);
    world.get_mut<Step>(leaf).value = 9;
    propagate();
    EXPECT_EQ(path(leaf), before);
    const Entity other = root(5);
    world.get_mut<Parent>(middle).entity = other;
    propagate();
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({5}), {2}), {9}).value);
}

TEST_F(PropagationTo, AParentWhoseNumberIsUsedAgainIsDead) {
    const Entity first = root(1), orphan = child(first, 2);
    propagate();
    const std::uint64_t before = path(orphan);
    world.destroy(first);
    const Entity second = root(50);
    ASSERT_EQ(second.index, first.index);
    propagate();
    EXPECT_EQ(path(orphan), before);
    world.get_mut<Parent>(orphan).entity = second;
    propagate();
    EXPECT_EQ(path(orphan), of_child(of_root({50}), {2}).value);
}

TEST_F(PropagationTo, RingsRestWithWhatHangsFromThem) {
    const Entity a = child({}, 1), b = child(a, 2), below = child(b, 3), self = child({}, 4);
    world.get_mut<Parent>(a).entity = b;
    world.get_mut<Parent>(self).entity = self;
    const Entity apart = root(5);
    propagate();
    EXPECT_EQ(path(below), 0u);
    EXPECT_EQ(path(self), 0u);
    EXPECT_EQ(path(apart), of_root({5}).value);
    world.get_mut<Parent>(a).entity = {};
    propagate();
    EXPECT_EQ(path(below), of_child(of_child(of_root({1}), {2}), {3}).value);
}

TEST_F(PropagationTo, HandlesOfAnotherWorldMeanWhateverHasTheirNumberHere) {
    World other;
    const Entity stranger = other.create();
    const Entity nobody_here = child(stranger, 1);  // is number 0 itself: its own parent
    propagate();
    EXPECT_EQ(path(nobody_here), 0u);
    const Entity beyond = child({12'345'678, 3}, 1);
    propagate();
    EXPECT_EQ(path(beyond), 0u);
}

TEST_F(PropagationTo, SeveralWorldsInTurn) {
    const Entity here = child(root(1), 2);
    propagate();
    World there;
    const Entity other = there.create(Step{8}, Path{});
    propagation(there, of_root, of_child);
    EXPECT_EQ(there.get<Path>(other).value, of_root({8}).value);
    world.get_mut<Step>(here).value = 3;
    propagate();
    EXPECT_EQ(path(here), of_child(of_root({1}), {3}).value);
}

TEST_F(PropagationTo, ResultsThatAreNotNumbersHarmOnlyWhatHangsFromThem) {
    World numbers;
    Propagation<const Position, Velocity> positions;
    const float bad = std::numeric_limits<float>::quiet_NaN();
    const Entity root = numbers.create(Position{bad, 0, 1}, Velocity{});
    const Entity child = numbers.create(Position{1, 0, 1}, Velocity{}, Parent{root});
    const Entity apart = numbers.create(Position{1, 2, 3}, Velocity{});
    const auto place = [&] {
        positions(
            numbers,
            [](const Position& p) {
                return Velocity{p.x, p.y, p.z};
            },
            [](const Velocity& v, const Position& p) {
                return Velocity{v.x * p.x, v.y * p.y, v.z * p.z};
            });
    };
    place();
    place();
    EXPECT_TRUE(std::isnan(numbers.get<Velocity>(child).x));
    EXPECT_EQ(numbers.get<Velocity>(child).y, 0.0f);
    EXPECT_EQ(numbers.get<Velocity>(apart), (Velocity{1, 2, 3}));
}

TEST_F(PropagationTo, TermsFilterAndReachTheFunctions) {
    Propagation<Step, Path, With<Frozen>, Optional<Health>, const Byte> with_terms;
    const Entity top = world.create(Step{1}, Path{}, Frozen{}, Byte{10});
    const Entity below = world.create(Step{2}, Path{}, Frozen{}, Byte{20}, Health{5}, Parent{top});
    const Entity left_out = root(3);
    with_terms(
        world,
        [](Step& step, Health* health, const Byte& byte) {
            EXPECT_EQ(health, nullptr);
            ++step.value;
            return Path{byte.value};
        },
        [](const Path& parent, Step& step, Health* health, const Byte& byte) {
            ++step.value;
            return Path{parent.value + byte.value + static_cast<std::uint64_t>(health->points++)};
        });
    EXPECT_EQ(path(below), 35u);
    EXPECT_EQ(world.get<Health>(below).points, 6);
    EXPECT_EQ(world.get<Step>(top).value, 2u);
    EXPECT_EQ(path(left_out), 0u);
}

TEST_F(PropagationSkips, EverythingWhenNothingChanged) {
    std::mt19937 engine{1};
    for (int i = 0; i < 50; ++i)
        tree(world, engine);
    EXPECT_EQ(propagate(), 50 * 85);
    EXPECT_EQ(propagate(), 0);
    world.create(Health{});  // rows elsewhere do not matter
    EXPECT_EQ(propagate(), 0);
}

TEST_F(PropagationSkips, TreesWhoseRootsDidNotMove) {
    std::mt19937 engine{1};
    std::vector<std::vector<Entity>> trees;
    for (int i = 0; i < 100; ++i)
        trees.push_back(tree(world, engine));
    propagate();
    world.get_mut<Step>(trees[40][0]).value += 1;
    // All roots share a chunk, so that all are looked at; only one has another result.
    EXPECT_EQ(propagate(), 100 + 84);
    world.get_mut<Step>(trees[40][0]).value += 0;
    EXPECT_EQ(propagate(), 100);
}

TEST_F(PropagationSkips, NoSubtreeThatGotAnotherParent) {
    const Entity a = root(1), b = root(2), middle = child(a, 3), leaf = child(middle, 4);
    propagate();
    world.get_mut<Parent>(middle).entity = b;
    propagate();
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({2}), {3}), {4}).value);
}

TEST_F(PropagationSkips, NoChangeThatMovedToAnotherRow) {
    const Entity a = root(1), b = root(2);
    propagate();
    world.get_mut<Step>(b).value = 9;
    world.destroy(a);  // b takes over its row
    propagate();
    EXPECT_EQ(path(b), of_root({9}).value);
    world.remove<Step>(b);
    world.add(b, Step{11});  // the same row again
    propagate();
    EXPECT_EQ(path(b), of_root({11}).value);
}

TEST_F(PropagationSkips, ChunksWithoutNewResultsWhenStamping) {
    const Entity quiet = child(root(1), 2);
    for (int i = 0; i < 2000; ++i)
        child(quiet, 3);
    propagate();
    const std::uint32_t before = world.version() - 1;
    world.get_mut<Step>(child(quiet, 3)).value = 4;
    propagate();
    Query<const Path, const Parent> query;
    std::vector<bool> changed;
    for (const auto& chunk : query.chunks(world))
        changed.push_back(chunk.changed_since<Path>(before));
    EXPECT_THAT(changed, ::testing::ElementsAre(false, true));
}

TEST_F(PropagationSkips, NothingAfterAFunctionThrew) {
    const Entity a = root(1), b = child(a, 2), leaf = child(b, 3);
    propagate();
    world.get_mut<Step>(a).value = 5;
    const auto refuse = [](const Path& parent, const Step& step) -> Path {
        if (step.value == 2) throw std::runtime_error{"refused"};
        return of_child(parent, step);
    };
    EXPECT_THROW(propagation(world, of_root, refuse), std::runtime_error);
    propagate();  // though a's result is not another one than the call that failed left
    EXPECT_EQ(path(leaf), of_child(of_child(of_root({5}), {2}), {3}).value);
}

TEST_F(PropagationSkips, AllAllocationWhileTheStructureStays) {
    std::mt19937 engine{1};
    std::vector<std::vector<Entity>> trees;
    for (int i = 0; i < 200; ++i)
        trees.push_back(tree(world, engine));
    const Entity house = world.create(Path{1});
    child(house, 1);
    propagate();
    for (const bool everything : {false, true}) {
        world.get_mut<Step>(trees[3][0]).value += 1;
        world.get_mut<Path>(house).value += 1;
        Query<Step> steps;
        if (everything) steps.each(world, [](Step& step) { step.value += 1; });
        const std::size_t before = rambla::test::allocation_count();
        propagate();
        EXPECT_EQ(rambla::test::allocation_count(), before);
    }
}

TEST_F(PropagationSkips, NoLocalThatItsFunctionStillChanges) {
    Propagation<Step, Path> halving;
    const Entity entity = root(5), steady = root(0);
    int visits = 0;
    const auto halve = [&](Step& step) {
        ++visits;
        return Path{step.value /= 2};
    };
    for (int i = 0; i < 10; ++i)
        halving(world, halve, of_child);
    EXPECT_EQ(path(entity), 0u);
    EXPECT_EQ(path(steady), 0u);
    EXPECT_EQ(visits, 2 * 4) << "5, 2, 1, 0, and once more to see that it stays";
}

TEST_F(PropagationSkips, NothingThatOthersWroteInASharedRunOfASchedule) {
    const Entity top = root(1), below = child(top, 1);
    Schedule schedule;
    schedule.add("early", [](View<Step, Without<Parent>> steps) {
        for (const auto& chunk : steps.chunks())
            chunk.each([](Step& step) { ++step.value; });
    });
    schedule
        .add("propagate",
             [this](World& shared) {
                 EXPECT_EQ(&shared, &world);
                 propagate();
             })
        .after("early")
        .reads<Step, Parent>()
        .writes<Path>();
    schedule
        .add("late",
             [](View<Step, With<Parent>> steps) {
                 for (const auto& chunk : steps.chunks())
                     chunk.each([](Step& step) { ++step.value; });
             })
        .after("propagate");
    for (std::uint64_t run = 0; run < 5; ++run) {
        schedule.run(world);
        EXPECT_EQ(path(below), of_child(of_root({2 + run}), {1 + run}).value);
    }
}

/// Random changes of all kinds; the model recurses from each entity to its root.
class PropagationUnderChange : public ::testing::TestWithParam<std::uint32_t> {
protected:
    void make_members(int count) {
        for (int i = 0; i < count; ++i) {
            if (known.empty() || engine() % 40 == 0) {
                known.push_back(world.create(Step{engine() % 100}, Path{}));
            } else if (engine() % 3 == 0) {
                known.push_back(world.create(Step{engine() % 100}, Path{}, Parent{any()}, Health{}));
            } else {
                known.push_back(world.create(Step{engine() % 100}, Path{}, Parent{any()}));
            }
        }
    }
    Entity any() { return known[engine() % known.size()]; }

    void change_one() {
        const Entity entity = any();
        switch (engine() % 10) {
            case 0:
            case 1:
            case 2:
                world.get_mut<Step>(entity).value = engine() % 100;
                break;
            case 3:
                if (const Entity parent = any(); !hangs_from(parent, entity))
                    world.add(entity, Parent{parent});
                break;
            case 4:
                world.add(entity, Parent{any()});
                break;  // perhaps a ring
            case 5:
                if (world.has<Parent>(entity)) world.remove<Parent>(entity);
                break;
            case 6:
                make_members(1);
                break;
            case 7:
                if (known.size() < 10) break;
                std::erase(known, entity);
                world.destroy(entity);
                break;
            case 8:
                if (world.has<Health>(entity)) {
                    world.remove<Health>(entity);
                } else {
                    world.add(entity, Health{});
                }
                break;
            default:  // leaves or joins the members, as a parent keeps its result or not
                if (engine() % 4 == 0) world.add(entity, Parent{});
                break;
        }
    }

    bool hangs_from(Entity entity, Entity above) const {
        for (std::size_t steps = 0; steps <= known.size(); ++steps) {
            if (entity == above) return true;
            const Parent* parent = world.try_get<Parent>(entity);
            if (parent == nullptr || !world.alive(parent->entity)) return false;
            entity = parent->entity;
        }
        return true;
    }

    /// Nothing: it rests.
    std::optional<Path> expected(Entity entity) const {
        std::vector<Step> steps;
        while (steps.size() <= known.size()) {
            steps.push_back(world.get<Step>(entity));
            const Parent* parent = world.try_get<Parent>(entity);
            if (parent == nullptr || parent->entity == Entity{}) {
                Path path = of_root(steps.back());
                for (std::size_t i = steps.size() - 1; i-- > 0;)
                    path = of_child(path, steps[i]);
                return path;
            }
            if (!world.alive(parent->entity)) return {};
            entity = parent->entity;
        }
        return {};
    }

    std::mt19937 engine{GetParam()};
    World world;
    std::vector<Entity> known;
};

TEST_P(PropagationUnderChange, EqualsNaiveRecursion) {
    make_members(GetParam() % 4 == 0 ? 6000 : 300);
    Propagation<const Step, Path> propagation;
    for (int round = 0; round < 25; ++round) {
        std::vector<std::pair<Entity, Path>> before;
        for (const Entity entity : known)
            before.emplace_back(entity, world.get<Path>(entity));
        propagation(world, of_root, of_child);
        for (const auto& [entity, rested] : before)
            ASSERT_EQ(world.get<Path>(entity), expected(entity).value_or(rested)) << "round " << round;
        for (std::uint32_t i = engine() % 20; i > 0; --i)
            change_one();
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, PropagationUnderChange, ::testing::Range(0u, 40u));

TEST(Propagation, DoesNotDependOnTheNumberOfThreads) {
    const auto results_with = [](std::size_t threads) {
        oneapi::tbb::global_control limit{oneapi::tbb::global_control::max_allowed_parallelism, threads};
        std::mt19937 engine{7};
        World world;
        std::vector<Entity> all;
        for (int i = 0; i < 300; ++i) {
            const std::vector<Entity> nodes = tree(world, engine);
            all.insert(all.end(), nodes.begin(), nodes.end());
        }
        Propagation<const Step, Path> propagation;
        std::vector<std::uint64_t> results;
        for (int round = 0; round < 10; ++round) {
            for (int i = 0; i < 50; ++i) {
                world.get_mut<Step>(all[engine() % all.size()]).value = engine();
                const Entity a = all[engine() % all.size()], b = all[engine() % all.size()];
                world.add(a, Parent{b});
            }
            propagation(world, of_root, of_child);
            for (const Entity entity : all)
                results.push_back(world.get<Path>(entity).value);
        }
        return results;
    };
    const std::vector<std::uint64_t> alone = results_with(1);
    for (const std::size_t threads : {2u, 3u, 8u})
        EXPECT_EQ(results_with(threads), alone) << threads << " threads";
}

}  // namespace
}  // namespace rambla::ecs
