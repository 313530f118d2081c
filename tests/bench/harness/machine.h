#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rambla::bench {

/// What a result depends on besides the code, as pairs of name and value.
using Machine = std::vector<std::pair<std::string, std::string>>;

/// @param threads  that the benchmarks may use at most
[[nodiscard]] Machine this_machine(int threads);

/// One line per pair.
[[nodiscard]] std::string to_text(const Machine& machine);

}  // namespace rambla::bench
