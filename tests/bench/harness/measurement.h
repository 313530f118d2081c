#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::bench {

/// What a benchmark's name says: `<operation>/<variant>/<size>`.
struct BenchmarkName {
    std::string operation;   ///< "create", "iterate_7_churned"
    std::string variant;     ///< "bare" or "rambla", perhaps with a suffix: "rambla_2threads"
    std::uint64_t size = 0;  ///< entities; 0 when the name has none

    bool operator==(const BenchmarkName&) const = default;
};

/// Reads "create/rambla/10000", also with what Google Benchmark appends ("/real_time", "/iterations:3").
/// Nothing when no part of the name is a variant.
[[nodiscard]] std::optional<BenchmarkName> parse_name(std::string_view name);

/// One benchmark's results, all its repetitions.
struct Measurement {
    BenchmarkName name;
    std::vector<double> ns_per_item;         ///< by repetition
    std::map<std::string, double> counters;  ///< medians over the repetitions
};

/// The middle value, or the mean of the two in the middle. 0 for no values.
[[nodiscard]] double median(std::span<const double> values);

/// Median over the repetitions of time of `subject` / time of `baseline`. Repetitions with the same number
/// ran close to each other, so that what slows the machine for a while slows both.
[[nodiscard]] double median_ratio(const Measurement& subject, const Measurement& baseline);

}  // namespace rambla::bench
