#include "ecs/command_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

#include "ecs/query.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

std::vector<int> healths(World& world) {
    std::vector<int> points;
    Query<const Health> query;
    query.each(world, [&](const Health& health) { points.push_back(health.points); });
    return points;
}

TEST(CommandQueue, PlaysRecordingsInTheOrderOfTheirKeys) {
    World world;
    CommandQueue queue;
    queue.recording({2, 0}).create(Health{5});
    queue.recording({1, 8}).create(Health{4});
    Commands& first = queue.recording({1, 3});
    first.create(Health{2});
    queue.recording({0, 9}).create(Health{1});
    first.create(Health{3});
    const Playback playback = queue.apply(world);
    EXPECT_EQ(playback.applied, 5u);
    EXPECT_EQ(healths(world), (std::vector{1, 2, 3, 4, 5}));
    EXPECT_TRUE(queue.empty());
}

TEST(CommandQueue, PlaceholdersBelongToTheirRecording) {
    World world;
    CommandQueue queue;
    Commands& a = queue.recording({0, 0});
    Commands& b = queue.recording({0, 1});
    const Entity in_b = b.create(Health{1});
    const Entity in_a = a.create(Health{2});
    b.add(in_b, Parent{in_b});
    a.add(in_a, Parent{in_a});
    queue.apply(world);
    Query<Entity, const Health, const Parent> query;
    query.each(world,
               [](Entity entity, const Health&, const Parent& parent) { EXPECT_EQ(parent.entity, entity); });
    EXPECT_EQ(query.count(world), 2u);
    EXPECT_EQ(world.get<Health>(a.created(in_a)).points, 2);
    EXPECT_EQ(world.get<Health>(b.created(in_b)).points, 1);
}

TEST(CommandQueue, RefusesTwoRecordingsOfOneKey) {
    World world;
    CommandQueue queue;
    queue.recording({0, 1}).create(Health{1});
    (void)queue.recording({0, 1});
    EXPECT_EQ(queue.apply(world).applied, 1u) << "one of them is empty: their order does not matter";
    queue.recording({0, 1}).create(Health{2});
    queue.recording({0, 1}).create(Health{3});
    EXPECT_THROW(queue.apply(world), Misuse);
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_FALSE(queue.empty());
    queue.clear();
    EXPECT_EQ(queue.apply(world).applied, 0u);
}

/// 40 ranges of work, recorded by `threads` threads that take them in turns.
std::vector<Entity> rows_after(std::size_t threads) {
    constexpr std::uint32_t k_ranges = 40;
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 4000; ++i)
        entities.push_back(world.create(Health{i}));
    CommandQueue queue;
    std::vector<std::thread> workers;
    for (std::size_t worker = 0; worker < threads; ++worker) {
        workers.emplace_back([&, worker] {
            for (std::size_t range = worker; range < k_ranges; range += threads) {
                Commands& commands = queue.recording({0, static_cast<std::uint32_t>(range)});
                for (std::size_t i = range * 100; i < range * 100 + 100; ++i) {
                    if (i % 3 == 0) commands.add(entities[i], Frozen{});
                    if (i % 5 == 0) commands.destroy(entities[i]);
                    if (i % 7 == 0) commands.create(Health{-static_cast<int>(i)});
                }
            }
        });
    }
    for (std::thread& worker : workers)
        worker.join();
    queue.apply(world);
    std::vector<Entity> rows;
    Query<Entity> query;
    query.each(world, [&](Entity entity) { rows.push_back(entity); });
    return rows;
}

TEST(CommandQueue, GivesTheSameRowsForAnyNumberOfThreads) {
    const std::vector<Entity> rows = rows_after(1);
    EXPECT_EQ(rows.size(), 4000u - 800u + 572u);
    for (std::size_t threads : {2u, 3u, 8u})
        EXPECT_EQ(rows_after(threads), rows) << threads;
}

TEST(CommandQueue, ASteadyUseDoesNotAllocate) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 2000; ++i)
        entities.push_back(world.create(Position{}));
    CommandQueue queue;
    const auto frame = [&] {
        for (std::uint32_t job = 0; job < 20; ++job) {
            Commands& commands = queue.recording({0, job});
            for (std::size_t i = 0; i < 100; ++i)
                commands.add(entities[job * 100 + i], Velocity{1, 2, 3});
        }
        queue.apply(world);
        for (Entity entity : entities)
            world.remove<Velocity>(entity);
    };
    frame();
    frame();
    const std::size_t before = rambla::test::allocation_count();
    frame();
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::ecs
