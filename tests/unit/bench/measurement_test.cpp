#include "bench/harness/measurement.h"

#include <gtest/gtest.h>

namespace rambla::bench {
namespace {

TEST(BenchmarkNameParsing, ReadsOperationVariantAndSize) {
    EXPECT_EQ(parse_name("create/bare/10000"), (BenchmarkName{"create", "bare", 10'000}));
    EXPECT_EQ(parse_name("sync/rambla_2threads/64"), (BenchmarkName{"sync", "rambla_2threads", 64}));
    EXPECT_EQ(parse_name("query_one/rambla"), (BenchmarkName{"query_one", "rambla", 0}));
}

TEST(BenchmarkNameParsing, SkipsWhatGoogleBenchmarkAppends) {
    EXPECT_EQ(parse_name("create/bare/10000/iterations:3/real_time"),
              (BenchmarkName{"create", "bare", 10'000}));
    EXPECT_EQ(parse_name("create/bare/N:500/manual_time"), (BenchmarkName{"create", "bare", 500}));
}

TEST(BenchmarkNameParsing, RefusesNamesWithoutAnOperationOrAVariant) {
    EXPECT_FALSE(parse_name(""));
    EXPECT_FALSE(parse_name("bare/10000"));
    EXPECT_FALSE(parse_name("create/10000"));
    EXPECT_FALSE(parse_name("create/barely/10000"));
}

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
    EXPECT_EQ(median(std::vector<double>{}), 0.0);
    EXPECT_EQ(median(std::vector<double>{9.0, 1.0, 5.0}), 5.0);
    EXPECT_EQ(median(std::vector<double>{9.0, 1.0, 5.0, 7.0}), 6.0);
}

TEST(MedianRatio, ComparesRepetitionsThatRanTogether) {
    // The machine was ten times slower during the second repetition: a ratio of medians would not notice
    // that ours took double the time whenever both met the same machine.
    const Measurement ours{{"create", "rambla", 1}, {20.0, 200.0, 22.0}, {}};
    const Measurement bare{{"create", "bare", 1}, {10.0, 100.0, 11.0}, {}};
    EXPECT_DOUBLE_EQ(median_ratio(ours, bare), 2.0);
    const Measurement mixed{{"create", "rambla", 1}, {5.0, 300.0, 22.0}, {}};
    EXPECT_DOUBLE_EQ(median_ratio(mixed, bare), 2.0);
}

TEST(MedianRatio, IgnoresRepetitionsWithoutACounterpart) {
    const Measurement ours{{"create", "rambla", 1}, {20.0, 20.0, 20.0}, {}};
    const Measurement bare{{"create", "bare", 1}, {10.0}, {}};
    EXPECT_DOUBLE_EQ(median_ratio(ours, bare), 2.0);
}

}  // namespace
}  // namespace rambla::bench
