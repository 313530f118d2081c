#pragma once

#include <span>
#include <string_view>

#include "bench/harness/target.h"

namespace rambla::bench {

/// Main function of a benchmark program: runs all benchmarks linked into it, all variants of one operation
/// and size in turns, and prints one table. A missed target is a word in the table, not a failure.
///     --quick       fewer and shorter repetitions
///     --json FILE   writes the results there too
///     --threads N   threads that oneTBB may use; default: the machine's cores
///     further arguments go to Google Benchmark: --benchmark_filter=create
/// @param title  what is measured, and per what
/// @return       the process's exit code
int run(std::string_view title, std::span<const Target> targets, int argc, char** argv);

}  // namespace rambla::bench
