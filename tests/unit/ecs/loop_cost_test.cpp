#include <gtest/gtest.h>

#include "ecs/job.h"

namespace rambla::ecs::detail {
namespace {

constexpr std::size_t k_rows = 1024;

TEST(LoopCost, GuessesFiveNanosecondsPerRowUntilItIsMeasured) {
    EXPECT_EQ(LoopCost{}.grain(2, 1999, 2), 2u);  // less than 10 us: all on one thread
    EXPECT_EQ(LoopCost{}.grain(2, 2000, 2), 1u);  // two jobs of 5 us
}

TEST(LoopCost, NothingIsSharedByOneThreadOrInOneChunk) {
    LoopCost cost;
    cost.measured(k_rows, 1'000'000'000);
    EXPECT_EQ(cost.grain(64, 64 * k_rows, 1), 64u);
    EXPECT_EQ(cost.grain(1, k_rows, 8), 1u);
    EXPECT_EQ(cost.grain(0, 0, 8), 0u);
}

TEST(LoopCost, ACheapLoopStaysTogetherAndADearOneIsDivided) {
    LoopCost cheap;
    cheap.measured(64 * k_rows, 9'000);
    EXPECT_EQ(cheap.grain(64, 64 * k_rows, 2), 64u);
    LoopCost dear;
    dear.measured(64 * k_rows, 64'000'000);
    EXPECT_EQ(dear.grain(64, 64 * k_rows, 2), 4u);  // eight jobs for each thread
    EXPECT_EQ(dear.grain(64, 64 * k_rows, 8), 1u);
    EXPECT_EQ(dear.grain(8, 8 * k_rows, 8), 1u);  // no job is less than a chunk
}

TEST(LoopCost, JobsTakeAtLeastFiveMicroseconds) {
    LoopCost cost;
    cost.measured(64 * k_rows, 20'000);
    EXPECT_EQ(cost.grain(64, 64 * k_rows, 8), 16u);  // four jobs of 5 us, not 64
}

TEST(LoopCost, OneDisturbedRunIsForgotten) {
    LoopCost cost;
    cost.measured(1000, 1'000);
    cost.measured(1000, 20'000);
    EXPECT_EQ(cost.grain(2, 1000, 2), 1u);  // (1 + 20) / 2 = 10.5 us: shared
    cost.measured(1000, 1'000);
    EXPECT_EQ(cost.grain(2, 1000, 2), 2u);  // 5.75 us
}

TEST(LoopCost, RunsWithoutRowsTeachNothing) {
    LoopCost cost;
    cost.measured(0, 1'000'000'000);
    EXPECT_EQ(cost.grain(2, 1999, 2), 2u);
    EXPECT_EQ(cost.grain(2, 2000, 2), 1u);
    cost.measured(1000, 20'000);
    EXPECT_EQ(cost.grain(2, 1000, 2), 1u);  // this is the first that counts, not half of it
}

}  // namespace
}  // namespace rambla::ecs::detail
