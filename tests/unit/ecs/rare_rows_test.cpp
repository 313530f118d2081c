#include "ecs/rare_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <utility>
#include <vector>

#include "ecs/query.h"
#include "ecs/schedule.h"
#include "ecs/view.h"
#include "ecs/world_access.h"
#include "support/allocation_counter.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs {
namespace {

using namespace test;

constexpr std::size_t k_per_holder = detail::RareRows::k_rows_per_holder;

/// Rows in three archetypes, shuffled, of which some burn.
struct Fire {
    World world;
    std::vector<Entity> entities;
    std::vector<Entity> burning;

    Fire(std::size_t rows, std::size_t holders, std::uint32_t seed = 1) {
        std::mt19937 engine{seed};
        for (std::size_t i = 0; i < rows; ++i) {
            const auto points = Health{static_cast<int>(i)};
            entities.push_back(i % 3 == 0   ? world.create(points)
                               : i % 3 == 1 ? world.create(points, Position{})
                                            : world.create(points, Frozen{}));
        }
        std::vector<Entity> shuffled = entities;
        std::shuffle(shuffled.begin(), shuffled.end(), engine);
        for (std::size_t i = 0; i < holders; ++i) {
            burning.push_back(shuffled[i]);
            world.add(shuffled[i], Burning{static_cast<int>(shuffled[i].index)});
        }
    }

    /// Who burns, row by row, asked one by one.
    template <class... Terms>
    [[nodiscard]] std::vector<Entity> asked(Query<Entity, Terms...> all = {}) {
        std::vector<Entity> found;
        all.each(world, [&](Entity entity, const auto&...) {
            if (world.has<Burning>(entity)) found.push_back(entity);
        });
        return found;
    }
    template <class Q>
    [[nodiscard]] std::vector<Entity> found(Q query) {
        std::vector<Entity> handed_out;
        query.each(world, [&](Entity entity, const auto&...) { handed_out.push_back(entity); });
        EXPECT_EQ(query.count(world), handed_out.size());
        return handed_out;
    }
};

TEST(RareRows, ComeInTheOrderOfAllRowsOnBothSidesOfTheLimit) {
    constexpr std::size_t k_rows = 20'000;
    for (const std::size_t holders : {std::size_t{0}, std::size_t{1}, std::size_t{40}, k_rows / k_per_holder,
                                      k_rows / k_per_holder + 1, k_rows / 2, k_rows}) {
        Fire fire{k_rows, holders};
        EXPECT_EQ(fire.found(Query<Entity, const Burning>{}), fire.asked(Query<Entity>{})) << holders;
        EXPECT_EQ(fire.found(Query<Entity, With<Burning>>{}), fire.asked(Query<Entity>{})) << holders;
        EXPECT_EQ(fire.asked(Query<Entity>{}).size(), holders);
    }
}

TEST(RareRows, ArePartOfWhatTheOtherTermsLeave) {
    Fire fire{20'000, 90};
    for (std::size_t i = 0; i < fire.burning.size(); i += 4)
        fire.world.add(fire.burning[i], Selected{});
    const auto positions = fire.asked(Query<Entity, const Position>{});
    EXPECT_GT(positions.size(), 10u);
    EXPECT_EQ(fire.found(Query<Entity, const Burning, const Position>{}), positions);
    EXPECT_EQ(fire.found(Query<Entity, const Burning, Without<Frozen>>{}).size() +
                  fire.found(Query<Entity, const Burning, With<Frozen>>{}).size(),
              90u);
    EXPECT_EQ(fire.found(Query<Entity, const Burning, With<Selected>>{}).size(), 23u);
    EXPECT_EQ(fire.found(Query<Entity, const Burning, Without<Selected>>{}).size(), 67u);
    EXPECT_EQ((Query<const Burning, const Velocity>{}.count(fire.world)), 0u);
}

TEST(RareRows, OfArchetypesThatDoNotMatchAreLeftOutHoweverFarDownTheyAre) {
    World world;
    std::vector<Entity> others, members;
    for (int i = 0; i < 100'000; ++i)
        others.push_back(world.create(Health{}));
    for (int i = 0; i < 1'000; ++i)
        members.push_back(world.create(Position{}));
    world.add(others[90'000], Burning{});
    world.add(members[500], Burning{});
    Query<Entity, const Burning, const Position> query;
    std::vector<Entity> found;
    query.each(world, [&](Entity entity, const auto&...) { found.push_back(entity); });
    EXPECT_EQ(found, (std::vector{members[500]}));
}

TEST(RareRows, OfChunksThatDidNotChangeAreLeftOut) {
    Fire fire{20'000, 0};
    for (std::size_t i = 0; i < 9'000; i += 300)
        fire.world.add(fire.entities[i], Burning{});  // rows 0, 100, … 2900 of the first archetype
    const std::uint32_t seen = fire.world.advance_version();
    fire.world.get_mut<Health>(fire.entities[3 * 1'500]).points = 1;
    Query<const Burning, Changed<Health>> query;
    EXPECT_EQ(query.count(fire.world, {seen}), 10u) << "rows 1100 to 2000 of chunk 1";
    EXPECT_EQ(query.count(fire.world, {fire.world.version()}), 0u);
}

TEST(RareRows, AreThoseOfTheRarestComponent) {
    Fire fire{20'000, 20'000};
    fire.world.add(fire.entities[12'345], Selected{});
    const ArchetypeGraph& graph = detail::WorldAccess::graph(fire.world);
    const SparseSet* const selected = detail::sparse_set_of<Selected>(graph);
    ASSERT_NE(selected, nullptr);
    EXPECT_EQ((detail::Filters<const Burning, With<Selected>>::rarest(graph)), selected);
    EXPECT_EQ((detail::Filters<With<Selected>, const Burning>::rarest(graph)), selected);
    EXPECT_EQ((detail::Filters<const Burning, SparseAnchored>::rarest(graph)), nullptr) << "nobody has it";
    const std::vector<Entity> expected{fire.entities[12'345]};
    EXPECT_EQ(fire.found(Query<Entity, const Burning, With<Selected>>{}), expected);
    EXPECT_EQ((Query<const Burning, SparseAnchored>{}.count(fire.world)), 0u);
}

TEST(RareRows, AreWrittenAloneAndChunksOfTheOthersAreNotHandedOut) {
    Fire fire{20'000, 0};
    fire.world.add(fire.entities[0], Burning{1});  // row 0 of the first archetype
    const std::uint32_t seen = fire.world.advance_version();
    Query<Health, Burning> writer;
    std::size_t chunks = 0;
    for (const auto& chunk : writer.chunks(fire.world)) {
        ++chunks;
        EXPECT_EQ(chunk.rows().count(), 1u);
        chunk.each([](Health& health, Burning& burning) { health.points = burning.heat = 7; });
    }
    EXPECT_EQ(chunks, 1u);
    EXPECT_EQ((Query<Changed<Health>>{}.count(fire.world, {seen})), k_chunk_rows) << "the chunk handed out";
    EXPECT_EQ((Query<const Burning, Changed<Burning>>{}.count(fire.world, {seen})), 1u);
    EXPECT_EQ((Query<const Burning, Changed<Burning>>{}.count(fire.world, {fire.world.version()})), 0u);
}

TEST(RareRows, OfOneQueryMayBeWalkedOverInsideOfItsOwnWalk) {
    Fire fire{20'000, 50};
    Query<Entity, const Burning> query;
    std::vector<Entity> outer;
    std::size_t inner = 0;
    query.each(fire.world, [&](Entity entity, const Burning&) {
        outer.push_back(entity);
        query.each(fire.world, [&](Entity, const Burning&) { ++inner; });
    });
    EXPECT_EQ(outer, fire.asked(Query<Entity>{}));
    EXPECT_EQ(inner, 50u * 50u);
}

TEST(RareRows, AreReadByJobsOfASystemSideBySide) {
    Fire fire{20'000, 100};
    std::atomic<int> jobs{0}, wrong{0};
    std::vector<Entity> expected;
    Schedule schedule{{.threads = 8}};
    schedule.add("look", [&](View<const Health> all, View<Entity, const Burning> rare) {
        all.for_each_chunk([&](const auto&) {
            ++jobs;
            std::size_t inside = 0;
            for (int again = 0; again < 20; ++again) {
                std::size_t next = 0, strangers = 0;
                rare.each([&](Entity entity, const Burning&) {
                    if (next >= expected.size() || expected[next] != entity) ++strangers;
                    if (next++ == 10) inside += rare.count();
                });
                if (strangers != 0 || next != expected.size() || rare.count() != next) ++wrong;
            }
            if (inside != 20 * expected.size()) ++wrong;
        });
    });
    const auto run = [&] {
        expected = fire.asked(Query<Entity>{});
        schedule.run(fire.world);
    };
    for (int i = 0; i < 10; ++i)
        run();
    fire.world.create(Burning{});  // of an archetype that the view has not seen
    for (int i = 0; i < 3; ++i)
        run();
    EXPECT_EQ(expected.size(), 101u);
    EXPECT_GE(jobs, 13 * 20);
    EXPECT_EQ(wrong, 0);
}

TEST(RareRows, FollowRowsThatMoveAndWorldsInTurn) {
    Fire fire{20'000, 60}, other{15'000, 30, 2};
    Query<Entity, const Burning> query;
    for (int step = 0; step < 5; ++step) {
        for (std::size_t i = 0; i < 10; ++i)
            fire.world.destroy(fire.entities[static_cast<std::size_t>(step) * 2'000 + i]);
        const auto walk = [&](Fire& one) {
            std::vector<Entity> found;
            query.each(one.world, [&](Entity entity, const Burning&) { found.push_back(entity); });
            return found;
        };
        EXPECT_EQ(walk(fire), fire.asked(Query<Entity>{}));
        EXPECT_EQ(walk(other), other.asked(Query<Entity>{}));
    }
}

TEST(RareRows, AreFoundWithoutAllocationInASteadyState) {
    Fire fire{20'000, 100};
    Query<const Burning> query;
    EXPECT_EQ(query.count(fire.world), 100u);
    const std::size_t before = rambla::test::allocation_count();
    EXPECT_EQ(query.count(fire.world), 100u);
    fire.world.remove<Burning>(fire.burning[3]);
    EXPECT_EQ(query.count(fire.world), 99u);
    EXPECT_EQ(rambla::test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::ecs
