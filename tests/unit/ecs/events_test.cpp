#include "ecs/events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ecs/schedule.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {
namespace {

using testing::ElementsAre;

struct Hit {
    int number = 0;
};

/// Resource: how often the schedule ran.
struct Step {
    int count = 0;
};

void count_steps(ResMut<Step> step) {
    ++step->count;
}
void write_two(Res<Step> step, EventWriter<Hit>& hits) {
    hits.emit({10 * step->count});
    hits.emit({10 * step->count + 1});
}

std::vector<int> numbers(const EventReader<Hit>& hits) {
    std::vector<int> numbers;
    hits.each([&](const Hit& hit) { numbers.push_back(hit.number); });
    return numbers;
}

TEST(Events, AReaderAfterTheWriterReadsThemInTheSameStep) {
    World world;
    world.set_resource(Step{});
    std::vector<int> read;
    Schedule schedule;
    schedule.add("step", count_steps);
    schedule.add("write", write_two);
    schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(10, 11));
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(20, 21)) << "each event once";
}

TEST(Events, AReaderBeforeTheWriterReadsThemInTheNextStep) {
    World world;
    world.set_resource(Step{});
    std::vector<int> read;
    Schedule schedule;
    schedule.add("step", count_steps);
    schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
    schedule.add("write", write_two);
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre());
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(10, 11));
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(20, 21));
}

TEST(Events, AReaderBetweenTwoWritersReadsTheOldOneFirst) {
    World world;
    world.set_resource(Step{});
    std::vector<int> read;
    Schedule schedule;
    schedule.add("step", count_steps);
    schedule.add("first", [](Res<Step> step, EventWriter<Hit>& hits) { hits.emit({step->count}); });
    schedule.add("read", [&](EventReader<Hit> hits) {
        read = numbers(hits);
        EXPECT_EQ(hits.of_last_step().size() + hits.of_this_step().size(), hits.size());
    });
    schedule.add("last", [](Res<Step> step, EventWriter<Hit>& hits) { hits.emit({-step->count}); });
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(1));
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(-1, 2));
}

TEST(Events, AreForgottenAfterTheStepThatFollows) {
    Events<Hit> events;
    events.emit({1});
    EXPECT_EQ(events.of_this_step().size(), 1u);
    events.begin_step();
    EXPECT_EQ(events.of_last_step().size(), 1u);
    EXPECT_EQ(events.of_this_step().size(), 0u);
    EXPECT_EQ(events.first(), 0u);
    events.begin_step();
    EXPECT_EQ(events.of_last_step().size(), 0u);
    EXPECT_EQ(events.first(), 1u);
    EXPECT_EQ(events.end(), 1u);
}

TEST(Events, AScheduleThatOnlyReadsDoesNotForget) {
    World world;
    world.set_resource(Events<Hit>{}).emit({5});
    std::vector<int> read;
    Schedule schedule;
    schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(5));
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre());
    EXPECT_EQ(world.resource<Events<Hit>>().of_this_step().size(), 1u);
}

TEST(Events, AReaderTakenToAnotherWorldBeginsWithTheOldestThatIsThere) {
    World first;
    World second;
    first.set_resource(Events<Hit>{}).emit({1});
    first.resource<Events<Hit>>().emit({2});
    second.set_resource(Events<Hit>{}).emit({3});
    std::vector<int> read;
    Schedule schedule;
    schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
    schedule.run(first);
    EXPECT_THAT(read, ElementsAre(1, 2));
    schedule.run(second);
    EXPECT_THAT(read, ElementsAre(3)) << "two events of the first world do not hide the second's";
    second.resource<Events<Hit>>().emit({4});
    schedule.run(second);
    EXPECT_THAT(read, ElementsAre(4)) << "each event once";
    schedule.run(first);
    EXPECT_THAT(read, ElementsAre(1, 2)) << "the way back is a way to another world, too";
}

TEST(Events, OfJobsStandInTheOrderOfTheJobsAfterTheSystemsOwn) {
    constexpr int k_count = 40 * 1024 + 7;
    for (const std::size_t threads : {1u, 2u, 5u}) {
        World world;
        for (int i = 0; i < k_count; ++i)
            world.create(Health{i});
        std::vector<int> read;
        Schedule schedule{{.threads = threads}};
        schedule.add("write", [](View<const Health> living, EventWriter<Hit>& hits) {
            living.for_each_chunk([&](const auto& chunk, Job job) {
                for (const Health& health : chunk.template get<0>()) {
                    if (health.points % 100 == 0) hits.emit(job, {health.points});
                }
            });
            hits.emit({-1});
        });
        schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
        for (int run = 0; run < 3; ++run) {
            schedule.run(world);
            ASSERT_EQ(read.size(), 1u + (k_count + 99) / 100);
            EXPECT_EQ(read.front(), -1);
            for (std::size_t i = 1; i < read.size(); ++i)
                ASSERT_EQ(read[i], 100 * static_cast<int>(i - 1)) << "with " << threads << " threads";
        }
    }
}

TEST(Events, OfASystemThatThrowsAreDropped) {
    World world;
    bool fail = true;
    std::vector<int> read;
    Schedule schedule;
    schedule.add("write", [&](EventWriter<Hit>& hits) {
        hits.emit({fail ? 1 : 2});
        if (fail) throw std::runtime_error{"no"};
    });
    schedule.add("read", [&](EventReader<Hit> hits) { read = numbers(hits); });
    EXPECT_THROW(schedule.run(world), SystemFailed);
    EXPECT_THAT(read, ElementsAre());
    fail = false;
    schedule.run(world);
    EXPECT_THAT(read, ElementsAre(2));
}

TEST(Events, DoNotAllocateInASteadyState) {
    World world;
    for (int i = 0; i < 3000; ++i)
        world.create(Health{i});
    Schedule schedule{{.threads = 1}};
    schedule.add("write", [](View<const Health> living, EventWriter<Hit>& hits) {
        living.for_each_chunk([&](const auto& chunk, Job job) {
            for (const Health& health : chunk.template get<0>())
                hits.emit(job, {health.points});
        });
    });
    std::size_t read = 0;
    schedule.add("read", [&](EventReader<Hit> hits) { read += hits.size(); });
    for (int i = 0; i < 3; ++i)
        schedule.run(world);
    const std::size_t before = rambla::test::allocation_count();
    schedule.run(world);
    EXPECT_EQ(rambla::test::allocation_count(), before);
    EXPECT_EQ(read, 4u * 3000u);
}

}  // namespace
}  // namespace rambla::ecs::test
