#include "bench/harness/machine.h"

#include <fmt/format.h>
#include <oneapi/tbb/version.h>

#include <fstream>
#include <thread>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace rambla::bench {
namespace {

std::string processor() {
    std::ifstream file{"/proc/cpuinfo"};
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    }
    return "unknown";
}

std::string compiler() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string c_library() {
#ifdef __GLIBC__
    return fmt::format("glibc {}", gnu_get_libc_version());
#else
    return "unknown";
#endif
}

}  // namespace

Machine this_machine(int threads) {
    return {
        {"processor", processor()},           {"cores", std::to_string(std::thread::hardware_concurrency())},
        {"threads", std::to_string(threads)}, {"compiler", compiler()},
        {"flags", RAMBLA_BENCH_FLAGS},        {"C library", c_library()},
        {"oneTBB", TBB_runtime_version()},    {"Google Benchmark", RAMBLA_BENCH_LIBRARY_VERSION}};
}

std::string to_text(const Machine& machine) {
    std::string text;
    for (const auto& [name, value] : machine)
        text += fmt::format("{:<17} {}\n", name, value);
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace rambla::bench
