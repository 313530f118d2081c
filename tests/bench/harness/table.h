#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/harness/machine.h"
#include "bench/harness/measurement.h"
#include "bench/harness/target.h"

namespace rambla::bench {

/// One line of the report: a measured pair, or a target that nothing was measured for.
struct Row {
    std::string operation;   ///< with the variant's suffix, where it has one
    std::uint64_t size = 0;  ///< 0: any
    std::optional<double> bare_ns;
    std::optional<double> rambla_ns;
    std::optional<double> value;  ///< in the unit that `measure` says; what is judged
    std::string unit;             ///< "x", "ns", "x faster", "share", or a counter's name
    std::vector<std::pair<std::string, double>> rates;  ///< counters of ours named "…/s", for the reader
    const Target* target = nullptr;
    Verdict verdict = Verdict::no_target;
};

/// Lines in the order of the targets, then what was measured without a target, in the order of measuring.
/// A target without a result gives a line that says so.
[[nodiscard]] std::vector<Row> make_rows(std::span<const Measurement> measurements,
                                         std::span<const Target> targets);

/// The report as text, for people.
[[nodiscard]] std::string to_text(std::span<const Row> rows, const Machine& machine);
/// The same for programs, with every repetition's time.
[[nodiscard]] std::string to_json(std::span<const Row> rows, std::span<const Measurement> measurements,
                                  const Machine& machine);

}  // namespace rambla::bench
