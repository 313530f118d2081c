#pragma once

#include <array>
#include <cstdint>

namespace rambla::render::gl {

/// Why a GL function is called.
enum class CallKind : std::uint8_t {
    draw,      ///< draws, dispatches, clears, blits
    bind,      ///< programs, textures, buffers, framebuffers: what a draw reads and writes
    state,     ///< switches and functions of the fixed pipeline
    transfer,  ///< contents of textures and buffers
    object,    ///< making, describing and ending objects
    query,     ///< queries, fences, barriers, flushes, labels
    wait,      ///< blocks until the GPU has a result
    poll,      ///< asks whether a fence has passed: as often as there is time
    pace       ///< waits for a fence: for room to record another frame
};
inline constexpr std::size_t k_call_kinds = 9;

/// How often GL was called.
struct CallCounts {
    std::array<std::uint64_t, k_call_kinds> of_kind{};

    [[nodiscard]] std::uint64_t operator[](CallKind kind) const {
        return of_kind[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t count : of_kind)
            sum += count;
        return sum;
    }
    CallCounts operator-(const CallCounts& before) const {
        CallCounts difference;
        for (std::size_t i = 0; i < k_call_kinds; ++i)
            difference.of_kind[i] = of_kind[i] - before.of_kind[i];
        return difference;
    }
};

/// While it lives, calls are not counted: of what waits by its nature, such as a picture for a file that
/// waits for its textures.
class UncountedCalls {
public:
    UncountedCalls();
    ~UncountedCalls();
    UncountedCalls(const UncountedCalls&) = delete;
    UncountedCalls& operator=(const UncountedCalls&) = delete;
};

/// Starts to count every GL call of this process; further calls do nothing. Called in a thread with a current
/// context before it draws.
void count_calls();
/// All calls so far. Contexts of one process are used by one thread at a time.
[[nodiscard]] CallCounts calls();

}  // namespace rambla::render::gl
