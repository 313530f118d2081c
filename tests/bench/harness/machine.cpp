#include "bench/harness/machine.h"

#include <fmt/format.h>
#include <oneapi/tbb/version.h>

#include <thread>

#include "game/machine.h"

namespace rambla::bench {
Machine this_machine(int threads) {
    return {
        {"processor", game::processor_name()}, {"cores", std::to_string(std::thread::hardware_concurrency())},
        {"threads", std::to_string(threads)},  {"compiler", game::compiler_name()},
        {"flags", RAMBLA_BENCH_FLAGS},         {"C library", game::c_library_name()},
        {"oneTBB", TBB_runtime_version()},     {"Google Benchmark", RAMBLA_BENCH_LIBRARY_VERSION}};
}

std::string to_text(const Machine& machine) {
    std::string text;
    for (const auto& [name, value] : machine)
        text += fmt::format("{:<17} {}\n", name, value);
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace rambla::bench
