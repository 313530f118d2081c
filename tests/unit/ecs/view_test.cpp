#include "ecs/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ecs/schedule.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::ElementsAre;

TEST(View, ChangedFindsWhatLaterSystemsWroteInTheLastRun) {
    World world;
    const Entity entity = world.create(Position{}, Health{});
    bool write = true;
    std::vector<std::size_t> found;
    Schedule schedule;
    schedule.add("look", [&](View<const Position, Changed<Position>> changed) {
        found.push_back(changed.count());
        std::size_t rows = 0;
        changed.each([&](const Position&) { ++rows; });
        EXPECT_EQ(rows, found.back());
    });
    schedule.add("write", [&](World& shared, Query<Position>&) {
        if (write) shared.get_mut<Position>(entity).x += 1.0f;
    });
    schedule.run(world);
    schedule.run(world);
    write = false;
    schedule.run(world);
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(found, ElementsAre(1, 1, 1, 0, 0)) << "new, written twice, then left alone";
}

TEST(View, TheFirstLookAtAnyWorldSeesEverything) {
    std::size_t found = 0;
    Schedule schedule;
    schedule.add("look", [&](View<const Position, Changed<Position>> changed) { found = changed.count(); });
    for (const std::uint32_t first_version : {1u, 0x80000010u, 1u, 0xf0000000u}) {
        WorldOptions options;
        options.first_version = first_version;
        World world{options};
        for (int i = 0; i < 5; ++i)
            world.create(Position{});
        schedule.run(world);
        EXPECT_EQ(found, 5u) << first_version;
        for (int run = 0; run < 50; ++run)
            schedule.run(world);
        EXPECT_EQ(found, 0u) << first_version;
    }
}

TEST(View, ChangedConflictsWithWriters) {
    Schedule schedule;
    schedule.add("write", [](View<Position>) {});
    schedule.add("look", [](View<Entity, Changed<Position>>) {});
    EXPECT_EQ(schedule.plan().systems[1].waits.size(), 1u);
}

TEST(View, HandsOutTheSameChunksInALoopAndInJobs) {
    World world;
    for (int i = 0; i < 5000; ++i)
        world.create(Health{i});
    Schedule schedule{{.threads = 3}};
    schedule.add("both", [&](View<const Health> all) {
        std::vector<const Health*> in_loop;
        for (auto [healths] : all.chunks())
            in_loop.push_back(healths.data());
        std::vector<const Health*> in_jobs(in_loop.size());
        all.for_each_chunk(
            [&](const auto& chunk, Job job) { in_jobs[job.index] = chunk.template get<0>().data(); });
        EXPECT_EQ(in_loop, in_jobs);
        EXPECT_EQ(in_loop.size(), 5u);
    });
    schedule.run(world);
}

TEST(View, JobsOfASecondLoopCountOn) {
    World world;
    world.create(Health{});
    std::vector<std::uint32_t> numbers;
    Schedule schedule;
    schedule.add("twice", [&](View<const Health> all) {
        for (int i = 0; i < 2; ++i)
            all.for_each_chunk([&](const auto&, Job job) { numbers.push_back(job.index); });
    });
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(numbers, ElementsAre(0, 1, 0, 1));
}

TEST(Lookup, ReadsComponentsOfSingleEntities) {
    World world;
    const Entity with = world.create(Position{1.0f}, Health{3});
    const Entity without = world.create(Position{});
    Schedule schedule;
    schedule.add("look", [&](Lookup<const Position, const Health> of) {
        EXPECT_EQ(of.get<Health>(with).points, 3);
        EXPECT_EQ(of.try_get<Health>(without), nullptr);
        EXPECT_TRUE(of.alive(without));
        EXPECT_FALSE(of.alive(Entity{}));
    });
    schedule.run(world);
}

}  // namespace
}  // namespace rambla::ecs::test
