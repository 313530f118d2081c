#include <gtest/gtest.h>

#include <string>

#include "property/ecs/sequence.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

constexpr std::size_t k_operations = 70'000;
constexpr std::size_t k_between_full_checks = 7000;

struct Outcome {
    std::string failure;  ///< empty when world and model agreed all the way
    std::size_t played = 0;
    std::uint64_t digest = 0;
    std::size_t alive = 0;
};

/// How a sequence is played.
struct Setting {
    WorldOptions options{};
    bool shares = false;
};

Outcome play(const Sequence& sequence, const Setting& setting, std::string* trace = nullptr) {
    Outcome outcome;
    try {
        Twins twins{setting.options, setting.shares};
        if (trace != nullptr) twins.trace_into(*trace);
        for (const Operation& operation : sequence) {
            twins.play(operation);
            if (++outcome.played % k_between_full_checks == 0) twins.check_all();
        }
        twins.check_all();
        outcome.digest = twins.digest();
        outcome.alive = twins.model().alive().size();
    } catch (const std::exception& error) {
        outcome.failure = error.what();
        return outcome;
    }
    if (Anchored::alive != 0) outcome.failure = "components outlive their world";
    return outcome;
}

/// The failing sequence, shortened, in words.
std::string explain(Sequence sequence, const Outcome& outcome, const Setting& setting) {
    sequence.resize(outcome.played + 1);
    const auto fails = [&](const Sequence& candidate) {
        Anchored::alive = 0;
        return !play(candidate, setting).failure.empty();
    };
    const Sequence shortest = shrink(std::move(sequence), fails, 2000);
    std::string trace;
    Anchored::alive = 0;
    const Outcome last = play(shortest, setting, &trace);
    return std::to_string(shortest.size()) + " operations show it (" + last.failure + "):\n" + trace;
}

/// The seed is the test's name: what ends the program names it too.
class RandomWorlds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomWorlds, AgreeWithANaiveModel) {
    Anchored::alive = 0;
    const Sequence sequence = random_sequence(GetParam(), k_operations, Twins::weights());
    const Outcome reserved = play(sequence, {});
    ASSERT_EQ(reserved.failure, "") << "after " << reserved.played << " operations of seed " << GetParam()
                                    << "; " << explain(sequence, reserved, {});
    EXPECT_GT(reserved.alive, 1500u) << "too few to leave the pool of small blocks";

    // Its versions wrap around on the way.
    const Setting in_blocks{{.first_version = 0xffffff00u, .reserve_address_space = false}};
    const Outcome moved = play(sequence, in_blocks);
    ASSERT_EQ(moved.failure, "") << "after " << moved.played << " operations of seed " << GetParam()
                                 << " without reserved address space; "
                                 << explain(sequence, moved, in_blocks);
    EXPECT_EQ(moved.digest, reserved.digest) << "the order of rows depends on how memory grows";

    const Setting sharing{{}, true};
    const Outcome shared = play(sequence, sharing);
    ASSERT_EQ(shared.failure, "") << "after " << shared.played << " operations of seed " << GetParam()
                                  << " with shared parts; " << explain(sequence, shared, sharing);
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomWorlds, testing::Range<std::uint64_t>(1, 7));

}  // namespace
}  // namespace rambla::ecs::property
