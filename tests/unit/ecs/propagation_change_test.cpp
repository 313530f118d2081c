#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "unit/ecs/parts.h"
#include "unit/ecs/paths.h"

namespace rambla::ecs {
namespace {

using namespace test;

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
