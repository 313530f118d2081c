#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// What an entity should have, kept the naive way.
struct Expected {
    std::optional<int> health{};
    std::optional<Position> position{};
    std::optional<int> anchored{};
    std::optional<int> owner{};
    bool frozen = false;
};

/// A world and its naive twin, changed by the same random operations.
class Twins {
public:
    Twins(std::uint32_t seed, const WorldOptions& options) : world_{options}, random_{seed} {}

    void step() {
        switch (below(12)) {
            case 0:
                create();
                break;
            case 1:
                target() ? destroy(*target_) : create();
                break;
            case 2:
            case 3:
            case 4:
                if (target()) toggle(*target_);
                break;
            case 5:
                if (target()) write(*target_);
                break;
            case 6:
            case 7:
            case 8:
                if (target()) check(*target_);
                break;
            case 9:
                command();
                break;
            case 10:
                if (below(40) == 0) apply();
                break;
            default:
                check_dead();
                break;
        }
    }

    void check_all() {
        apply();
        ASSERT_EQ(world_.entity_count(), expected_.size());
        std::size_t rows = 0;
        everything_.each(world_, [&](Entity entity, const Health* health, const Position* position,
                                     const Anchored* anchored, const Owner* owner) {
            ++rows;
            const auto found = expected_.find(key(entity));
            ASSERT_NE(found, expected_.end()) << to_string(entity);
            const Expected& expected = found->second;
            ASSERT_EQ(health != nullptr, expected.health.has_value());
            ASSERT_EQ(position != nullptr, expected.position.has_value());
            ASSERT_EQ(anchored != nullptr, expected.anchored.has_value());
            ASSERT_EQ(owner != nullptr, expected.owner.has_value());
            if (health != nullptr) {
                ASSERT_EQ(health->points, *expected.health);
            }
            if (position != nullptr) {
                ASSERT_EQ(*position, *expected.position);
            }
            if (anchored != nullptr) {
                ASSERT_TRUE(anchored->intact());
            }
            if (anchored != nullptr) {
                ASSERT_EQ(anchored->number(), *expected.anchored);
            }
            if (owner != nullptr) {
                ASSERT_EQ(*owner->value, *expected.owner);
            }
        });
        ASSERT_EQ(rows, expected_.size());
        int anchored = 0;
        std::size_t frozen = 0;
        for (const auto& [entity, expected] : expected_) {
            anchored += expected.anchored.has_value() ? 1 : 0;
            frozen += expected.frozen && !expected.health ? 1 : 0;
        }
        ASSERT_EQ(Anchored::alive, anchored);
        ASSERT_EQ(frozen_without_health_.count(world_), frozen);
    }

    [[nodiscard]] std::size_t alive() const { return expected_.size(); }

private:
    static std::uint64_t key(Entity entity) {
        return (std::uint64_t{entity.index} << 32u) | entity.generation;
    }
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    int number() { return static_cast<int>(below(1'000'000)); }
    Position place() { return {static_cast<float>(number()), 1, 2}; }

    bool target() {
        if (alive_.empty()) return false;
        target_ = alive_[below(static_cast<std::uint32_t>(alive_.size()))];
        if (world_.alive(*target_)) return true;
        ADD_FAILURE() << to_string(*target_) << " should be alive";
        return false;
    }

    void born(Entity entity, Expected expected) {
        ASSERT_TRUE(expected_.emplace(key(entity), std::move(expected)).second) << "handle used twice";
        alive_.push_back(entity);
    }

    void died(Entity entity) {
        expected_.erase(key(entity));
        for (Entity& other : alive_) {
            if (other != entity) continue;
            other = alive_.back();
            alive_.pop_back();
            break;
        }
        dead_.push_back(entity);
    }

    void create() {
        // A third of the entities go to one archetype, so that it grows out of the pool.
        const int n = number();
        switch (below(6)) {
            case 0:
                born(world_.create(), {});
                break;
            case 1:
                born(world_.create(Anchored{n}, Frozen{}), {.anchored = n, .frozen = true});
                break;
            case 2:
            case 3:
                born(world_.create(Health{n}, Anchored{n}), {.health = n, .anchored = n});
                break;
            case 4:
                born(world_.create(Position{1, 2, 3}), {.position = Position{1, 2, 3}});
                break;
            default:
                born(world_.create(Owner{std::make_unique<int>(n)}, Position{}, Health{n}),
                     {.health = n, .position = Position{}, .owner = n});
        }
    }

    void destroy(Entity entity) {
        if (below(3) != 0 && expected_.size() < 3000) return;  // let it grow
        apply();
        if (!world_.alive(entity)) return;  // a pending command ended it
        world_.destroy(entity);
        died(entity);
    }

    void toggle(Entity entity) {
        Expected& expected = expected_.at(key(entity));
        const int n = number();
        switch (below(5)) {
            case 0:
                change<Health>(entity, expected.health, n, Health{n});
                break;
            case 1:
                change<Position>(entity, expected.position, Position{1, 1, static_cast<float>(n)},
                                 Position{1, 1, static_cast<float>(n)});
                break;
            case 2:
                change<Anchored>(entity, expected.anchored, n, Anchored{n});
                break;
            case 3:
                change<Owner>(entity, expected.owner, n, Owner{std::make_unique<int>(n)});
                break;
            default:
                if (expected.frozen) world_.remove<Frozen>(entity);
                if (!expected.frozen) world_.add(entity, Frozen{});
                expected.frozen = !expected.frozen;
        }
    }

    /// Adds, replaces or removes.
    template <class C, class T>
    void change(Entity entity, std::optional<T>& expected, T value, C component) {
        if (expected && below(2) == 0) {
            world_.remove<C>(entity);
            expected.reset();
        } else {
            world_.add(entity, std::move(component));
            expected = value;
        }
    }

    void write(Entity entity) {
        Expected& expected = expected_.at(key(entity));
        Position* position = world_.try_get_mut<Position>(entity);
        ASSERT_EQ(position != nullptr, expected.position.has_value());
        if (position == nullptr) {
            EXPECT_THROW((void)world_.get_mut<Position>(entity), Misuse);
        } else {
            *position = place();
            expected.position = *position;
        }
    }

    void check(Entity entity) {
        const Expected& expected = expected_.at(key(entity));
        ASSERT_EQ(world_.has<Frozen>(entity), expected.frozen);
        const Anchored* anchored = world_.try_get<Anchored>(entity);
        ASSERT_EQ(anchored != nullptr, expected.anchored.has_value());
        if (anchored != nullptr) {
            ASSERT_TRUE(anchored->intact() && anchored->number() == *expected.anchored);
        }
        if (expected.health) {
            ASSERT_EQ(world_.get<Health>(entity).points, *expected.health);
        }
        if (expected.owner) {
            ASSERT_EQ(*world_.get<Owner>(entity).value, *expected.owner);
        }
    }

    void check_dead() {
        if (dead_.empty()) return;
        const Entity entity = dead_[below(static_cast<std::uint32_t>(dead_.size()))];
        ASSERT_FALSE(world_.alive(entity));
        if (below(50) == 0) {
            ASSERT_THROW(world_.destroy(entity), Misuse);
        }
    }

    /// Records a command, and what it should do to the twin at apply().
    void command() {
        const int n = number();
        if (below(4) == 0 || !target()) {
            const Entity placeholder = commands_.create(Anchored{n}, Health{n});
            pending_.push_back([this, placeholder, n] {
                born(commands_.created(placeholder), {.health = n, .anchored = n});
            });
            return;
        }
        const Entity entity = *target_;
        const auto if_alive = [this, entity](auto change) {
            return [this, entity, change] {
                if (const auto found = expected_.find(key(entity)); found != expected_.end())
                    change(found->second);
            };
        };
        switch (below(4)) {
            case 0:
                commands_.add(entity, Anchored{n});
                pending_.push_back(if_alive([n](Expected& expected) { expected.anchored = n; }));
                break;
            case 1:
                commands_.remove<Health>(entity);
                pending_.push_back(if_alive([](Expected& expected) { expected.health.reset(); }));
                break;
            case 2:
                commands_.add(entity, Frozen{});
                pending_.push_back(if_alive([](Expected& expected) { expected.frozen = true; }));
                break;
            default:
                if (below(4) != 0) break;
                commands_.destroy(entity);
                pending_.push_back(if_alive([this, entity](Expected&) { died(entity); }));
        }
    }

    void apply() {
        commands_.apply(world_);
        for (const auto& change : pending_)
            change();
        pending_.clear();
    }

    World world_;
    Commands commands_;
    std::mt19937 random_;
    std::map<std::uint64_t, Expected> expected_;
    std::vector<Entity> alive_;
    std::vector<Entity> dead_;
    std::vector<std::function<void()>> pending_;
    std::optional<Entity> target_;
    Query<Entity, Optional<const Health>, Optional<const Position>, Optional<const Anchored>,
          Optional<const Owner>>
        everything_;
    Query<With<Frozen>, Without<Health>, Entity> frozen_without_health_;
};

void run(std::uint32_t seed, const WorldOptions& options, std::size_t operations) {
    {
        Twins twins{seed, options};
        for (std::size_t i = 0; i < operations; ++i) {
            twins.step();
            if (i % 5000 == 0) twins.check_all();
            if (testing::Test::HasFatalFailure() || testing::Test::HasNonfatalFailure()) {
                FAIL() << "seed " << seed << ", operation " << i;
            }
        }
        twins.check_all();
        EXPECT_GT(twins.alive(), 2000u) << "too few for reserved columns";
    }
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(WorldModel, AgreesWithANaiveWorldOverRandomOperations) {
    for (std::uint32_t seed : {1u, 2u})
        run(seed, {}, 150'000);
}

TEST(WorldModel, AgreesWithANaiveWorldWithoutReservedAddressSpace) {
    run(3, {.reserve_address_space = false}, 150'000);
}

}  // namespace
}  // namespace rambla::ecs
