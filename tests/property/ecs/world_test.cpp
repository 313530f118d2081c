#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include "property/ecs/last_words.h"
#include "property/ecs/sequence.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

constexpr std::size_t k_operations = 45'000;
constexpr std::size_t k_between_full_checks = 5000;

/// For making a failing sequence shorter; what is found by then is shown.
constexpr std::chrono::seconds k_time_to_shrink{60};

struct Outcome {
    std::string failure;  ///< empty when world and model agreed all the way
    std::size_t played = 0;
    std::uint64_t digest = 0;
    std::size_t most_alive = 0;
};

/// How a sequence is played.
struct Setting {
    std::string_view name;
    WorldOptions options{};
    std::optional<Mirror::Watches> observed{};
    bool follows = false;
};

Outcome play(const Sequence& sequence, const Setting& setting, std::string* trace = nullptr) {
    Outcome outcome;
    try {
        Twins twins{setting.options, setting.observed, setting.follows};
        if (trace != nullptr) twins.trace_into(*trace);
        for (const Operation& operation : sequence) {
            LastWords::now_playing(outcome.played, Twins::name_of(operation));
            twins.play(operation);
            if (++outcome.played % k_between_full_checks == 0) twins.check_all();
            outcome.most_alive = std::max(outcome.most_alive, twins.model().alive().size());
        }
        twins.check_all();
        outcome.digest = twins.digest();
    } catch (const std::exception& error) {
        outcome.failure = error.what();
        return outcome;
    }
    if (Anchored::alive != 0) outcome.failure = "components outlive their world";
    return outcome;
}

/// What went wrong, and the failing sequence, shortened, in words.
std::string explain(Sequence sequence, const Outcome& outcome, const Setting& setting) {
    const std::string failing{outcome.played < sequence.size() ? Twins::name_of(sequence[outcome.played])
                                                               : "full check"};
    sequence.resize(std::min(outcome.played + 1, sequence.size()));
    const auto until = std::chrono::steady_clock::now() + k_time_to_shrink;
    const auto fails = [&](const Sequence& candidate) {
        Anchored::alive = 0;
        return std::chrono::steady_clock::now() < until && !play(candidate, setting).failure.empty();
    };
    const Sequence shortest = shrink(std::move(sequence), fails, 2000);
    std::string trace;
    Anchored::alive = 0;
    const Outcome last = play(shortest, setting, &trace);
    return "after " + std::to_string(outcome.played) + " operations, at " + failing + ", in a world " +
           std::string{setting.name} + "; " + std::to_string(shortest.size()) + " operations show it (" +
           last.failure + "):\n" + trace;
}

/// The seed is the test's name: what ends the program names it too.
class RandomWorlds : public testing::TestWithParam<std::uint64_t> {
protected:
    Outcome play_all(const Sequence& sequence, const Setting& setting) {
        const LastWords words{GetParam(), setting.name};
        Anchored::alive = 0;
        const Outcome outcome = play(sequence, setting);
        EXPECT_EQ(outcome.failure, "")
            << "seed " << GetParam() << ", " << explain(sequence, outcome, setting);
        return outcome;
    }
};

TEST_P(RandomWorlds, AgreeWithANaiveModel) {
    const Sequence sequence = random_sequence(GetParam(), k_operations, Twins::weights());
    const Outcome reserved = play_all(sequence, {"with reserved address space"});
    ASSERT_FALSE(HasFailure());
    EXPECT_GT(reserved.most_alive, 1500u) << "too few to leave the pool of small blocks";

    // Its versions wrap around on the way.
    const WorldOptions in_blocks{.first_version = 0xffffff00u, .reserve_address_space = false};
    const Outcome moved = play_all(sequence, {"in blocks", in_blocks});
    ASSERT_FALSE(HasFailure());
    EXPECT_EQ(moved.digest, reserved.digest) << "the order of rows depends on how memory grows";
}

TEST_P(RandomWorlds, AgreeWithAModelThatObserversKeep) {
    const Sequence sequence = random_sequence(100 + GetParam(), k_operations, Twins::weights());
    const auto watches = GetParam() % 2 == 0 ? Mirror::Watches::columns : Mirror::Watches::sparse_too;
    const bool follows = GetParam() % 4 < 2;
    const Outcome reserved = play_all(sequence, {"with observers", {}, watches, follows});
    ASSERT_FALSE(HasFailure());

    const WorldOptions in_blocks{.first_version = 0x7fffff00u, .reserve_address_space = false};
    const Outcome moved = play_all(sequence, {"with observers, in blocks", in_blocks, watches, follows});
    ASSERT_FALSE(HasFailure());
    EXPECT_EQ(moved.digest, reserved.digest) << "what observers are told depends on how memory grows";
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomWorlds, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace rambla::ecs::property
