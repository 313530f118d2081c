#include "ecs/alike_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/commands.h"
#include "ecs/observers.h"
#include "ecs/query.h"
#include "ecs/world.h"

namespace rambla::ecs {
namespace {

struct Number {
    std::uint32_t value = 0;
};
struct Mark {
    std::uint32_t value = 0;
};
struct Owner {
    std::shared_ptr<int> owned;
};
/// Owns memory and moves by its bytes.
struct Box {
    std::unique_ptr<int> owned;
};

}  // namespace

template <>
struct is_relocatable<Box> : std::true_type {};

namespace {

constexpr std::uint32_t k_entities = 3000;
constexpr std::uint32_t k_chosen = 300;
static_assert(k_chosen >= detail::AlikeMoves::k_fewest);

/// Numbered entities, and some of them in an order of chance.
struct Crowd {
    explicit Crowd(const WorldOptions& options = {}) : world{options} {
        for (std::uint32_t i = 0; i < k_entities; ++i)
            all.push_back(world.create(Number{i}, Owner{count}));
        std::vector<Entity> shuffled = all;
        std::mt19937 random{7};
        std::ranges::shuffle(shuffled, random);
        chosen.assign(shuffled.begin(), shuffled.begin() + k_chosen);
    }

    [[nodiscard]] std::vector<Entity> marked() {
        std::vector<Entity> entities;
        Query<Entity, With<Mark>> query;
        query.each(world, [&](Entity entity) { entities.push_back(entity); });
        return entities;
    }
    void expect_all_have_their_numbers() {
        for (std::uint32_t i = 0; i < k_entities; ++i)
            ASSERT_EQ(world.get<Number>(all[i]).value, i);
    }

    std::shared_ptr<int> count = std::make_shared<int>(0);
    World world;
    std::vector<Entity> all;
    std::vector<Entity> chosen;
    Commands commands;
};

TEST(AlikeMoves, ArriveInTheOrderOfTheCommandsWithTheirValues) {
    Crowd crowd;
    for (std::uint32_t i = 0; i < k_chosen; ++i)
        crowd.commands.add(crowd.chosen[i], Mark{i});
    EXPECT_EQ(crowd.commands.apply(crowd.world).applied, k_chosen);
    EXPECT_EQ(crowd.marked(), crowd.chosen);
    for (std::uint32_t i = 0; i < k_chosen; ++i)
        EXPECT_EQ(crowd.world.get<Mark>(crowd.chosen[i]).value, i);
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, LeaveNoGapAndNoDouble) {
    Crowd crowd;
    for (Entity entity : crowd.chosen)
        crowd.commands.add<Mark>(entity);
    crowd.commands.apply(crowd.world);
    std::vector<int> seen(k_entities);
    Query<Entity, const Number> query;
    query.each(crowd.world, [&](Entity entity, const Number& number) {
        ++seen[number.value];
        EXPECT_EQ(entity, crowd.all[number.value]);
    });
    EXPECT_EQ(seen, std::vector<int>(k_entities, 1));
    EXPECT_EQ(crowd.count.use_count(), k_entities + 1);
}

TEST(AlikeMoves, WhatIsThereIsReplacedInItsPlaceAndEndsOnceEach) {
    Crowd crowd;
    const auto other = std::make_shared<int>(1);
    const std::uint32_t seen = crowd.world.advance_version();
    for (Entity entity : crowd.chosen)
        crowd.commands.add(entity, Owner{other});
    const auto last = std::make_shared<int>(2);
    crowd.commands.add(crowd.chosen[5], Owner{last});  // the one that comes last counts
    EXPECT_EQ(crowd.commands.apply(crowd.world).applied, k_chosen + 1);
    EXPECT_EQ(crowd.count.use_count(), k_entities - k_chosen + 1);
    EXPECT_EQ(other.use_count(), k_chosen);
    EXPECT_EQ(crowd.world.get<Owner>(crowd.chosen[5]).owned, last);
    EXPECT_EQ(last.use_count(), 2);
    std::vector<Entity> order;
    Query<Entity, const Owner> query;
    for (const auto& chunk : query.chunks(crowd.world)) {
        EXPECT_TRUE(chunk.changed_since<Owner>(seen));
        for (Entity entity : chunk.get<0>())
            order.push_back(entity);
    }
    EXPECT_EQ(order, crowd.all) << "no row has moved";
}

TEST(AlikeMoves, WhereOneLacksWhatOthersHaveNothingIsReplacedTwice) {
    Crowd crowd;
    const Entity bare = crowd.world.create(Number{1});
    const auto other = std::make_shared<int>(1);
    for (Entity entity : crowd.chosen)
        crowd.commands.add(entity, Owner{other});
    crowd.commands.add(bare, Owner{other});
    EXPECT_EQ(crowd.commands.apply(crowd.world).applied, k_chosen + 1);
    EXPECT_EQ(crowd.count.use_count(), k_entities - k_chosen + 1);
    EXPECT_EQ(other.use_count(), k_chosen + 2);
    EXPECT_EQ(crowd.world.get<Owner>(bare).owned, other);
}

TEST(AlikeMoves, TakeAwayAndEndWhatIsTaken) {
    Crowd crowd;
    for (Entity entity : crowd.chosen)
        crowd.commands.remove<Owner>(entity);
    crowd.commands.apply(crowd.world);
    EXPECT_EQ(crowd.count.use_count(), k_entities - k_chosen + 1);
    for (Entity entity : crowd.chosen)
        EXPECT_FALSE(crowd.world.has<Owner>(entity));
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, AnEntityNamedTwiceMovesOnceAndKeepsTheLastValue) {
    Crowd crowd;
    for (std::uint32_t i = 0; i < k_chosen; ++i)
        crowd.commands.add(crowd.chosen[i], Mark{i});
    crowd.commands.add(crowd.chosen[5], Mark{77});
    crowd.commands.apply(crowd.world);
    EXPECT_EQ(crowd.marked().size(), k_chosen);
    EXPECT_EQ(crowd.world.get<Mark>(crowd.chosen[5]).value, 77u);
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, OwningValuesThatMoveByTheirBytesArriveOnceEach) {
    for (const bool twice : {false, true}) {
        Crowd crowd;
        for (std::uint32_t i = 0; i < k_chosen; ++i)
            crowd.commands.add(crowd.chosen[i], Box{std::make_unique<int>(static_cast<int>(i))});
        if (twice) crowd.commands.add(crowd.chosen[5], Box{std::make_unique<int>(77)});
        crowd.commands.apply(crowd.world);
        for (std::uint32_t i = 0; i < k_chosen; ++i) {
            const int expected = twice && i == 5 ? 77 : static_cast<int>(i);
            ASSERT_EQ(*crowd.world.get<Box>(crowd.chosen[i]).owned, expected);
        }
        crowd.expect_all_have_their_numbers();
    }
}

TEST(AlikeMoves, TwoRecordingsEachOfAnotherTypeAreBothPlayed) {
    Crowd crowd;
    CommandQueue queue;
    Commands& gives = queue.recording({0, 0});
    Commands& takes = queue.recording({1, 0});
    constexpr std::uint32_t k_half = k_chosen / 2;
    for (std::uint32_t i = 0; i < k_half; ++i) {
        gives.add(crowd.chosen[i], Mark{i});
        takes.remove<Owner>(crowd.chosen[k_half + i]);
    }
    EXPECT_EQ(queue.apply(crowd.world).applied, k_chosen);
    for (std::uint32_t i = 0; i < k_half; ++i) {
        ASSERT_TRUE(crowd.world.has<Mark>(crowd.chosen[i]));
        EXPECT_EQ(crowd.world.get<Mark>(crowd.chosen[i]).value, i);
        EXPECT_FALSE(crowd.world.has<Mark>(crowd.chosen[k_half + i]));
        EXPECT_FALSE(crowd.world.has<Owner>(crowd.chosen[k_half + i]));
    }
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, ARecordingThatBeginsAlikeIsPlayedToItsEnd) {
    Crowd crowd;
    for (Entity entity : crowd.chosen)
        crowd.commands.add<Mark>(entity);
    crowd.commands.destroy(crowd.all[0]);
    EXPECT_EQ(crowd.commands.apply(crowd.world).applied, k_chosen + 1);
    EXPECT_FALSE(crowd.world.alive(crowd.all[0]));
}

TEST(AlikeMoves, AnEntityThatEndedBeforeIsDroppedAndTheOthersMove) {
    Crowd crowd;
    const Entity ended = crowd.world.create(Number{0}, Owner{});
    crowd.world.destroy(ended);
    crowd.chosen[200] = ended;
    for (Entity entity : crowd.chosen)
        crowd.commands.add<Mark>(entity);
    const Playback playback = crowd.commands.apply(crowd.world);
    EXPECT_EQ(playback.applied, k_chosen - 1);
    EXPECT_EQ(playback.dropped, 1u);
    EXPECT_EQ(crowd.marked().size(), k_chosen - 1);
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, OneEntityOfAnotherKindStopsNothing) {
    Crowd crowd;
    const Entity other = crowd.world.create(Number{1});
    crowd.chosen[100] = other;
    for (Entity entity : crowd.chosen)
        crowd.commands.add<Mark>(entity);
    crowd.commands.apply(crowd.world);
    EXPECT_EQ(crowd.marked().size(), k_chosen);
    EXPECT_TRUE(crowd.world.has<Mark>(other));
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, WhereTheyDoNotFitNothingIsChanged) {
    WorldOptions options;
    options.max_rows_per_archetype = k_entities;
    Crowd crowd{options};
    for (std::uint32_t i = 0; i < k_entities - 100; ++i)
        crowd.world.create(Number{0}, Owner{}, Mark{});
    const std::vector<Entity> before = crowd.marked();
    for (Entity entity : crowd.chosen)
        crowd.commands.add<Mark>(entity);
    EXPECT_THROW(crowd.commands.apply(crowd.world), CapacityExceeded);
    EXPECT_EQ(crowd.marked(), before);
    crowd.expect_all_have_their_numbers();
}

TEST(AlikeMoves, AWorldWithoutObserversIsLikeOneThatNeverHadAny) {
    Crowd crowd;
    const ObserverId id = crowd.world.observers().on_add<Mark>([](Entity, const Mark&) {});
    crowd.world.observers().end(id);
    for (std::uint32_t i = 0; i < k_chosen; ++i)
        crowd.commands.add(crowd.chosen[i], Mark{i});
    crowd.commands.apply(crowd.world);
    EXPECT_EQ(crowd.marked(), crowd.chosen) << "in the order of the commands";
}

}  // namespace
}  // namespace rambla::ecs
