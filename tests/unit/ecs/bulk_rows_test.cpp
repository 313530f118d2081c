#include "ecs/bulk_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "ecs/commands.h"
#include "ecs/query.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

/// Leaves by one command or by two kinds of them: rows go one way, or several ways, and gaps close.
void expect_all_in_place(bool two_ways) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 3000; ++i)
        entities.push_back(world.create(Health{i}, Anchored{i}, Position{static_cast<float>(i), 0, 0}));
    std::vector<std::size_t> order(entities.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::mt19937 random{1};
    std::ranges::shuffle(order, random);
    Commands commands;
    for (std::size_t i = 0; i < 1000; ++i) {
        if (two_ways && i % 2 == 0) {
            commands.remove<Position>(entities[order[i]]);
        } else {
            commands.add(entities[order[i]], Velocity{static_cast<float>(order[i]), 0, 0});
        }
    }
    EXPECT_EQ(commands.apply(world).applied, 1000u);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Entity entity = entities[order[i]];
        const bool moved = i < 1000 && !(two_ways && i % 2 == 0);
        ASSERT_EQ(world.get<Health>(entity).points, static_cast<int>(order[i]));
        ASSERT_TRUE(world.get<Anchored>(entity).intact());
        ASSERT_EQ(world.get<Anchored>(entity).number(), static_cast<int>(order[i]));
        ASSERT_EQ(world.has<Velocity>(entity), moved);
        if (moved) {
            ASSERT_EQ(world.get<Velocity>(entity).x, static_cast<float>(order[i]));
        }
    }
    Query<Entity, const Health> query;
    query.each(world, [&](Entity entity, const Health& health) {
        ASSERT_EQ(entity, entities[static_cast<std::size_t>(health.points)]);
        ASSERT_EQ(&health, &world.get<Health>(entity)) << "not where the row was before";
    });
}

TEST(BulkRows, RowsThatMoveAndRowsThatFillGapsKeepTheirHandles) {
    expect_all_in_place(false);
    expect_all_in_place(true);
    EXPECT_EQ(Anchored::alive, 0);
}

TEST(BulkRows, GapsAreFilledFromTheLowestOnWithWhatLiesBehindTheEnd) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 8; ++i)
        entities.push_back(world.create(Health{i}));
    Commands commands;
    for (std::size_t i : {6u, 3u, 1u})
        commands.add(entities[i], Frozen{});
    commands.apply(world);
    std::vector<int> rows;
    Query<const Health, Without<Frozen>> stayed;
    stayed.each(world, [&](const Health& health) { rows.push_back(health.points); });
    EXPECT_EQ(rows, (std::vector{0, 5, 2, 7, 4}));
    rows.clear();
    Query<const Health, With<Frozen>> moved;
    moved.each(world, [&](const Health& health) { rows.push_back(health.points); });
    EXPECT_EQ(rows, (std::vector{1, 3, 6}));
}

}  // namespace
}  // namespace rambla::ecs
