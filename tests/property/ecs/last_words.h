#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rambla::ecs::property {

/// While it lives, a crash or a failed assert says which operation of which run it came from. Not under the
/// address sanitizer, whose own report a handler of signals would hide.
class LastWords {
public:
    /// @param setting  text that outlives it
    LastWords(std::uint64_t seed, std::string_view setting);
    ~LastWords();
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;

    /// @param operation  text that lives as long as the program
    static void now_playing(std::size_t number, std::string_view operation);
};

}  // namespace rambla::ecs::property
