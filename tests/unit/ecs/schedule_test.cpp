#include "ecs/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <span>
#include <stdexcept>
#include <thread>

#include "support/allocation_counter.h"
#include "unit/ecs/complaint.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Schedule, RunsFunctionsLambdasAndObjects) {
    struct Mover {
        float speed = 2.0f;
        void operator()(View<Position> moving) const {
            moving.each([this](Position& p) { p.x += speed; });
        }
    };
    World world;
    const Entity entity = world.create(Position{}, Velocity{1.0f});
    Schedule schedule;
    schedule.add("object", Mover{});
    schedule.add("lambda", [](View<Position, const Velocity> moving) {
        for (auto [positions, velocities] : moving.chunks())
            positions[0].x *= 10.0f + velocities[0].x;
    });
    void (*const function)(View<Position>) = [](View<Position> moving) {
        moving.each([](Position& p) { p.x += 1.0f; });
    };
    schedule.add("function", function);
    schedule.run(world);
    EXPECT_EQ(world.get<Position>(entity).x, 23.0f);
}

TEST(Schedule, ChangesAreMadeAtTheEndOfTheStage) {
    World world;
    std::vector<std::size_t> seen;
    const auto look = [&](View<const Health> living) {
        seen.push_back(living.count());
    };
    Schedule schedule;
    schedule.add("spawn", [](Commands& commands) { commands.create(Health{1}); });
    schedule.add("same stage", look);
    schedule.sync();
    schedule.add("next stage", look).after("same stage");
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(0, 1));
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST(Schedule, ASystemsOwnChangesComeBeforeThoseOfItsJobsAndOfLaterSystems) {
    World world;
    const Entity target = world.create(Position{});
    std::vector<float> seen;
    const auto look = [&] {
        seen.push_back(world.get<Velocity>(target).x);
    };
    Schedule schedule;
    schedule.add("a", [&](View<const Position> all, Commands& own, JobCommands& of_jobs) {
        all.for_each_chunk([&](const auto&, Job job) { of_jobs.of(job).add(target, Velocity{2.0f}); });
        own.add(target, Velocity{1.0f});
    });
    schedule.run(world);
    look();
    schedule.add("b", [&](Commands& own) { own.add(target, Velocity{3.0f}); });
    schedule.run(world);
    look();
    schedule.add("c", [&](Commands& own) { own.add(target, Velocity{4.0f}); }).before("a");
    schedule.run(world);
    look();
    EXPECT_THAT(seen, ElementsAre(2.0f, 3.0f, 3.0f));
}

TEST(Schedule, TheWorldForItselfAllowsStructuralChanges) {
    World world;
    Schedule schedule{{.threads = 2}};
    schedule.add("read", [](View<const Health>) {});
    schedule.add("all", [](World& all) { all.create(Health{}); });
    schedule.run(world);
    EXPECT_EQ(world.entity_count(), 1u);
}

TEST(Schedule, AfterAnExceptionTheStageEndsAndLaterStagesDoNotRun) {
    for (const std::size_t threads : {1u, 4u}) {
        World world;
        world.set_resource(Health{});
        std::vector<std::string> ran;
        bool fail = true;
        Schedule schedule{{.threads = threads}};
        schedule.add("good", [&](ResMut<Health>, Commands& commands) {
            ran.push_back("good");
            commands.create(Position{});
        });
        schedule.add("bad", [&](ResMut<Health>) {
            ran.push_back("bad");
            if (fail) throw std::runtime_error{"out of ideas"};
        });
        schedule.add("worse", [&](ResMut<Health>) {
            ran.push_back("worse");
            if (fail) throw 3;
        });
        schedule.sync();
        schedule.add("later", [&](ResMut<Health>) { ran.push_back("later"); });
        EXPECT_THAT(complaint([&] { schedule.run(world); }),
                    AllOf(HasSubstr("\"bad\""), HasSubstr("out of ideas")));
        EXPECT_THAT(ran, ElementsAre("good", "bad", "worse"));
        EXPECT_EQ(world.entity_count(), 0u) << "recorded changes of the stage are dropped";
        EXPECT_THROW(schedule.run(world), SystemFailed) << "the schedule can run again";
        EXPECT_EQ(world.entity_count(), 0u);
        fail = false;
        schedule.run(world);
        EXPECT_EQ(world.entity_count(), 1u) << "of this run alone";
    }
}

TEST(Schedule, KeepsWhatASystemThrewNested) {
    World world;
    Schedule schedule;
    schedule.add("bad", [](View<const Position>) { throw std::out_of_range{"far"}; });
    try {
        schedule.run(world);
        FAIL();
    } catch (const SystemFailed& failed) {
        EXPECT_THROW(std::rethrow_if_nested(failed), std::out_of_range);
    }
}

TEST(Schedule, AllChunksGetTheirTurnAndTheFirstOnesExceptionIsThrown) {
    for (const std::size_t threads : {1u, 4u}) {
        World world;
        for (int i = 0; i < 16 * 1024; ++i)
            world.create(Health{i});
        std::atomic<int> turns{0};
        Schedule schedule{{.threads = threads}};
        schedule.add("loop", [&](View<const Health> all) {
            all.for_each_chunk([&](const auto& chunk) {
                ++turns;
                const int number = chunk.template get<0>()[0].points / 1024;
                if (number >= 5) throw std::runtime_error{"chunk " + std::to_string(number)};
            });
        });
        EXPECT_THAT(complaint([&] { schedule.run(world); }), HasSubstr("chunk 5"));
        EXPECT_EQ(turns, 16);
    }
}

TEST(Schedule, AMissingResourceNamesSystemAndResource) {
    World world;
    Schedule schedule;
    schedule.add("needy", [](Res<Health>) {});
    EXPECT_THAT(complaint([&] { schedule.run(world); }), AllOf(HasSubstr("\"needy\""), HasSubstr("Health")));
}

TEST(Schedule, EachRunBeginsANewVersion) {
    World world;
    Schedule schedule;
    schedule.add("nothing", [](View<const Position>) {});
    const std::uint32_t before = world.version();
    schedule.run(world);
    schedule.run(world);
    EXPECT_EQ(world.version(), before + 2);
}

TEST(Schedule, TimesAreToldInTheOrderOfThePlan) {
    World world;
    Schedule schedule;
    schedule.add("late", [](View<const Position>) {}).after("early");
    schedule.add("early",
                 [](View<const Position>) { std::this_thread::sleep_for(std::chrono::milliseconds{2}); });
    schedule.run(world);
    ASSERT_EQ(schedule.times().size(), 2u);
    EXPECT_EQ(schedule.times()[0].name, "early");
    EXPECT_GE(schedule.times()[0].ns, 2'000'000u);
}

TEST(Schedule, TellsWhenAndOnWhichThreadEachSystemRan) {
    World world;
    Schedule schedule{{.threads = 2}};
    std::array<std::thread::id, 3> ran{};
    const auto begin = std::chrono::steady_clock::now();
    // The first two run at the same time: neither ends before both have begun.
    std::atomic<int> arrived{0};
    const auto meet = [&] {
        ++arrived;
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{10};
        while (arrived < 2 && std::chrono::steady_clock::now() < deadline)
            std::this_thread::yield();
    };
    schedule.add("a", [&](View<const Position>) {
        ran[0] = std::this_thread::get_id();
        meet();
    });
    schedule.add("b", [&](View<const Position>) {
        ran[1] = std::this_thread::get_id();
        meet();
    });
    schedule.add("c", [&](View<const Position>) { ran[2] = std::this_thread::get_id(); })
        .after("a")
        .after("b");
    schedule.run(world);
    const auto end = std::chrono::steady_clock::now();
    const std::span<const SystemTime> times = schedule.times();
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(times[i].thread, ran[i]) << times[i].name;
        EXPECT_GE(times[i].begin, begin) << times[i].name;
        EXPECT_LE(times[i].begin + std::chrono::nanoseconds{times[i].ns}, end) << times[i].name;
    }
    EXPECT_NE(times[0].thread, times[1].thread);
    EXPECT_LE(times[0].begin, times[1].begin + std::chrono::nanoseconds{times[1].ns});
    EXPECT_LE(times[1].begin, times[0].begin + std::chrono::nanoseconds{times[0].ns});
    EXPECT_GE(times[2].begin, times[0].begin + std::chrono::nanoseconds{times[0].ns});
    EXPECT_GE(times[2].begin, times[1].begin + std::chrono::nanoseconds{times[1].ns});
}

TEST(Schedule, SteadyRunsDoNotAllocate) {
    World world;
    for (int i = 0; i < 20'000; ++i)
        world.create(Position{}, Velocity{1.0f});
    Schedule schedule{{.threads = 2}};
    schedule.add("move", [](View<Position, const Velocity> moving) {
        moving.for_each_chunk(
            [](const auto& chunk) { chunk.each([](Position& p, const Velocity& v) { p.x += v.x; }); });
    });
    schedule.add("look", [](View<const Position> all) { static_cast<void>(all.count()); });
    for (int i = 0; i < 20; ++i)
        schedule.run(world);
    const std::size_t before = rambla::test::allocation_count();
    for (int i = 0; i < 100; ++i)
        schedule.run(world);
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::ecs::test
