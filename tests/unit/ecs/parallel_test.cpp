#include "ecs/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace rambla::ecs::test {
namespace {

TEST(Team, RangesCoverEachIndexOnce) {
    Team team;
    for (const std::size_t threads : {1u, 2u, 8u}) {
        team.resize(threads);
        std::vector<int> hits(1000);
        team.enter([&] {
            team.for_ranges(hits.size(), 7, [&](std::size_t begin, std::size_t end) {
                EXPECT_LE(end - begin, 7u);
                for (std::size_t i = begin; i < end; ++i)
                    ++hits[i];
            });
        });
        EXPECT_EQ(hits, std::vector<int>(1000, 1));
    }
}

TEST(Team, EveryThreadOfTheTeamWorksForItFromTheStart) {
    Team team;
    team.resize(8);
    EXPECT_EQ(team.threads(), 8u);
    EXPECT_EQ(team.worker_threads(), 8u) << "whatever the number of cores";
    team.resize(2);
    EXPECT_EQ(team.threads(), 2u);
}

TEST(Team, WaitsForAllThatWasSpawned) {
    Team team;
    team.resize(2);
    std::atomic<int> done{0};
    team.enter([&] {
        for (int i = 0; i < 100; ++i)
            team.spawn([](void* sum) { ++*static_cast<std::atomic<int>*>(sum); }, &done);
        team.wait();
        EXPECT_EQ(done, 100);
    });
}

TEST(Team, OfOneRunsAllOnTheCaller) {
    Team team;
    const auto caller = std::this_thread::get_id();
    team.enter([&] {
        team.for_ranges(10, 1,
                        [&](std::size_t, std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
    });
    EXPECT_EQ(team.worker_threads(), 1u);
}

}  // namespace
}  // namespace rambla::ecs::test
