#include "property/ecs/last_words.h"

#include <array>
#include <csignal>
#include <cstdio>

namespace rambla::ecs::property {
namespace {

struct Now {
    std::uint64_t seed = 0;
    std::string_view setting;
    std::size_t number = 0;
    std::string_view operation;
};
Now now;

#if defined(__SANITIZE_ADDRESS__)
constexpr std::array<int, 0> k_ends{};
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr std::array<int, 0> k_ends{};
#else
constexpr std::array k_ends{SIGABRT, SIGSEGV, SIGFPE};
#endif
#else
constexpr std::array k_ends{SIGABRT, SIGSEGV, SIGFPE};
#endif

/// The program is lost: what is not safe in a handler can make nothing worse than it is.
void say_and_end(int signal) {
    std::fprintf(stderr, "signal %d at operation %zu (%.*s) of seed %llu, in a world %.*s\n", signal,
                 now.number, static_cast<int>(now.operation.size()), now.operation.data(),
                 static_cast<unsigned long long>(now.seed), static_cast<int>(now.setting.size()),
                 now.setting.data());
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

LastWords::LastWords(std::uint64_t seed, std::string_view setting) {
    now = {seed, setting, 0, {}};
    for (const int end : k_ends)
        std::signal(end, say_and_end);
}

LastWords::~LastWords() {
    for (const int end : k_ends)
        std::signal(end, SIG_DFL);
}

void LastWords::now_playing(std::size_t number, std::string_view operation) {
    now.number = number;
    now.operation = operation;
}

}  // namespace rambla::ecs::property
