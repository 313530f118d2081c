#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// A world that is full to its last row: whatever comes next needs memory.
struct Crowded {
    World world;
    std::vector<Entity> entities;

    Crowded() {
        for (int i = 0; i < 256; ++i) {
            entities.push_back(world.create(Health{i}, Anchored{i}));
            if (i % 4 == 0) world.add(entities.back(), Burning{i});
        }
    }

    /// Everything that can be asked, in words.
    [[nodiscard]] std::string state() {
        std::string text = std::to_string(world.entity_count()) + " entities";
        Query<Entity, Optional<const Health>, Optional<const Anchored>, Optional<const Position>,
              Optional<const Burning>>
            all;
        all.each(world, [&](Entity entity, const Health* health, const Anchored* anchored,
                            const Position* position, const Burning* burning) {
            text += "; " + to_string(entity);
            if (health != nullptr) text += " health " + std::to_string(health->points);
            if (anchored != nullptr)
                text += anchored->intact() ? " anchored " + std::to_string(anchored->number()) : " damaged";
            if (position != nullptr) text += " position " + std::to_string(position->x);
            if (burning != nullptr) text += " burning " + std::to_string(burning->heat);
            if (world.has<Frozen>(entity)) text += " frozen";
            if (world.has<Selected>(entity)) text += " selected";
        });
        return text;
    }
};

/// Makes every allocation of `change` fail in turn, until it needs no more: each time nothing has changed,
/// and the change can be made afterwards. Returns how many could fail.
std::size_t fail_everywhere(const std::function<void(Crowded&)>& change) {
    for (std::size_t number = 0;; ++number) {
        Crowded crowded;
        const std::string before = crowded.state();
        bool refused = false;
        {
            const rambla::test::FailingAllocation failing{number};
            try {
                change(crowded);
            } catch (const std::bad_alloc&) {
                refused = true;
            } catch (const CapacityExceeded&) {
                refused = true;
            }
            if (!failing.happened()) return number;
        }
        if (!refused) continue;  // it could do without
        EXPECT_EQ(crowded.state(), before) << "allocation " << number;
        change(crowded);
        EXPECT_NE(crowded.state(), before) << "allocation " << number;
        if (testing::Test::HasFailure()) return number;
    }
}

class OutOfMemory : public testing::Test {
protected:
    ~OutOfMemory() override { EXPECT_EQ(Anchored::alive, alive_before_); }
    const int alive_before_ = Anchored::alive;
};

TEST_F(OutOfMemory, CreatingChangesNothing) {
    EXPECT_GT(fail_everywhere([](Crowded& crowded) { crowded.world.create(Health{1}, Anchored{1}); }), 0u);
    EXPECT_GT(fail_everywhere([](Crowded& crowded) { crowded.world.create(Position{}, Anchored{1}); }), 0u);
    EXPECT_GT(
        fail_everywhere([](Crowded& crowded) { crowded.world.create(Anchored{1}, Selected{}, Burning{2}); }),
        0u);
}

TEST_F(OutOfMemory, AddingAndRemovingChangesNothing) {
    EXPECT_GT(fail_everywhere([](Crowded& crowded) {
                  crowded.world.add(crowded.entities[7], Position{1, 2, 3});
              }),
              0u);
    EXPECT_GT(fail_everywhere([](Crowded& crowded) { crowded.world.add(crowded.entities[7], Frozen{}); }),
              0u);
    EXPECT_GT(fail_everywhere([](Crowded& crowded) { crowded.world.remove<Anchored>(crowded.entities[7]); }),
              0u);
    EXPECT_GT(fail_everywhere([](Crowded& crowded) { crowded.world.add(crowded.entities[7], Selected{}); }),
              0u);
}

TEST_F(OutOfMemory, EndingAnEntityNeedsNone) {
    EXPECT_EQ(fail_everywhere([](Crowded& crowded) { crowded.world.destroy(crowded.entities[7]); }), 0u);
    EXPECT_EQ(fail_everywhere([](Crowded& crowded) { crowded.world.remove<Burning>(crowded.entities[8]); }),
              0u);
}

TEST_F(OutOfMemory, RecordingAndPlayingCommandsChangesNothing) {
    const auto change = [](Crowded& crowded) {
        Commands commands;
        const Entity made = commands.create(Health{1}, Anchored{1});
        commands.create(Position{}, Anchored{2});
        commands.add(crowded.entities[3], Anchored{3});
        commands.add(crowded.entities[4], Position{4, 4, 4});
        commands.remove<Anchored>(crowded.entities[5]);
        commands.destroy(crowded.entities[6]);
        commands.add(made, Frozen{});
        commands.apply(crowded.world);
    };
    EXPECT_GT(fail_everywhere(change), 5u);
}

TEST_F(OutOfMemory, AQueryFindsEverythingTheNextTime) {
    Crowded crowded;
    crowded.world.create(Position{1, 0, 0});
    for (std::size_t number = 0;; ++number) {
        Query<const Position> fresh;
        {
            const rambla::test::FailingAllocation failing{number};
            try {
                (void)fresh.count(crowded.world);
            } catch (const std::bad_alloc&) {
            }
            if (!failing.happened()) break;
        }
        EXPECT_EQ(fresh.count(crowded.world), 1u) << "allocation " << number;
    }
}

TEST_F(OutOfMemory, AResourceIsSetWhollyOrNotAtAll) {
    for (std::size_t number = 0;; ++number) {
        World world;
        const rambla::test::FailingAllocation failing{number};
        try {
            world.set_resource(Health{5});
        } catch (const std::bad_alloc&) {
            EXPECT_FALSE(world.has_resource<Health>()) << "allocation " << number;
        }
        if (!failing.happened()) break;
    }
}

}  // namespace
}  // namespace rambla::ecs
