#include "property/ecs/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace rambla::ecs::property {
namespace {

constexpr std::array<std::uint32_t, 3> k_weights{1, 0, 9};

TEST(RandomSequences, AreTheSameForTheSameSeedAndFollowTheirWeights) {
    const Sequence sequence = random_sequence(7, 10'000, k_weights);
    const Sequence again = random_sequence(7, 10'000, k_weights);
    const Sequence other = random_sequence(8, 10'000, k_weights);
    const auto same = [](const Operation& x, const Operation& y) {
        return x.kind == y.kind && x.a == y.a && x.b == y.b && x.c == y.c;
    };
    EXPECT_TRUE(std::ranges::equal(sequence, again, same));
    EXPECT_FALSE(std::ranges::equal(sequence, other, same));
    const auto count = [&](std::uint32_t kind) {
        return std::ranges::count(sequence, kind, &Operation::kind);
    };
    EXPECT_NEAR(static_cast<double>(count(0)), 1000.0, 100.0) << "more than three standard deviations off";
    EXPECT_EQ(count(1), 0);
    EXPECT_EQ(count(0) + count(2), 10'000);
}

TEST(Shrinking, FindsTheTwoOperationsThatFailTogether) {
    Sequence sequence = random_sequence(1, 5000, k_weights);
    sequence[1234].kind = 77;
    sequence[4321].kind = 78;
    const auto fails = [](const Sequence& candidate) {
        const auto first = std::ranges::find(candidate, 77u, &Operation::kind);
        return std::find_if(first, candidate.end(), [](const Operation& o) { return o.kind == 78u; }) !=
               candidate.end();
    };
    const Sequence shortest = shrink(sequence, fails, 1000);
    ASSERT_EQ(shortest.size(), 2u);
    EXPECT_EQ(shortest[0].a, sequence[1234].a);
    EXPECT_EQ(shortest[1].a, sequence[4321].a);
}

TEST(Shrinking, StopsAfterItsTries) {
    std::size_t calls = 0;
    const auto fails = [&](const Sequence& candidate) {
        ++calls;
        return candidate.size() > 900;
    };
    (void)shrink(random_sequence(1, 1000, k_weights), fails, 3);
    EXPECT_EQ(calls, 3u);
}

}  // namespace
}  // namespace rambla::ecs::property
