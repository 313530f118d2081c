#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "ecs/commands.h"
#include "ecs/observers.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Values of one component by entity, kept by observers alone.
template <class C>
class Mirror {
public:
    Mirror(World& world, int C::*member) : member_{member} {
        world.observers().on_add<C>([this](Entity entity, const C& value) {
            EXPECT_TRUE(values_.emplace(entity.index, value.*member_).second) << "it was there";
        });
        world.observers().on_set<C>([this](Entity entity, const C& value) {
            ASSERT_TRUE(values_.contains(entity.index)) << "it was not there";
            values_[entity.index] = value.*member_;
        });
        world.observers().on_remove<C>([this](Entity entity, const C& value) {
            ASSERT_TRUE(values_.contains(entity.index)) << "it was not there";
            EXPECT_EQ(values_[entity.index], value.*member_) << "another value was there";
            values_.erase(entity.index);
        });
    }
    void expect_same(const World& world, const std::vector<Entity>& alive) const {
        std::map<std::uint32_t, int> found;
        for (Entity entity : alive) {
            if (const C* value = world.try_get<C>(entity)) found[entity.index] = value->*member_;
        }
        EXPECT_EQ(values_, found);
    }

private:
    int C::*member_;
    std::map<std::uint32_t, int> values_;
};

TEST(Observers, KeepAMirrorOfTheWorldThroughRandomPlaybacks) {
    World world;
    const Mirror<Health> healths{world, &Health::points};
    const Mirror<Score> scores{world, &Score::points};
    const Mirror<Burning> burning{world, &Burning::heat};
    std::vector<Entity> alive;
    std::mt19937 random{7};
    Commands commands;
    for (int round = 0; round < 400 && !testing::Test::HasFailure(); ++round) {
        std::vector<Entity> made;
        for (std::uint32_t step = random() % 40; step > 0; --step) {
            const auto n = static_cast<int>(random() % 1000);
            const std::size_t all = alive.size() + made.size();
            const std::size_t place = all == 0 ? 0 : random() % all;
            const auto target = [&] {
                return place < alive.size() ? alive[place] : made[place - alive.size()];
            };
            switch (all == 0 ? 0 : random() % 14) {
                case 0:
                    made.push_back(commands.create(Health{n}, Burning{n}));
                    break;
                case 1:
                    made.push_back(commands.create(Score{n}, Material{1}));
                    break;
                case 2:
                    made.push_back(commands.create(Burning{n}));
                    break;
                case 3:
                    commands.destroy(target());
                    break;
                case 4:
                    commands.add(target(), Health{n});
                    break;
                case 5:
                    commands.remove<Health>(target());
                    break;
                case 6:
                    commands.add(target(), Burning{n});
                    break;
                case 7:
                    commands.remove<Burning>(target());
                    break;
                case 8:
                    commands.add(target(), Score{n});
                    break;
                case 9:
                    commands.remove<Score>(target());
                    break;
                case 10:
                    commands.add(target(), Material{static_cast<std::uint32_t>(n % 3)});
                    break;
                case 11:
                    commands.add(target(), Frozen{});
                    break;
                case 12:
                    if (n % 4 == 0) commands.add_to_all<Health, With<Frozen>>({n});
                    if (n % 4 == 1) commands.remove_from_all<Score, With<Health>>();
                    break;
                default:
                    if (n % 20 == 0) commands.destroy_all<With<Frozen>, With<Health>>();
            }
        }
        commands.apply(world);
        for (Entity placeholder : made)
            alive.push_back(commands.created(placeholder));
        std::erase_if(alive, [&](Entity entity) { return !world.alive(entity); });
        healths.expect_same(world, alive);
        scores.expect_same(world, alive);
        burning.expect_same(world, alive);
    }
    EXPECT_GT(alive.size(), 20u);
}

}  // namespace
}  // namespace rambla::ecs
