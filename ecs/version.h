#pragma once

#include <cstdint>

namespace rambla::ecs {

/// What a reader saw last: World::version() at that time. Asks a query with Changed terms for what was
/// written after it.
///
/// Since{} is version 0, from which a new world counts on: all that was ever written came after it, for the
/// world's first 2³¹ versions. For good, and for worlds with another first_version:
///     query.chunks(world, Since{world.version() - k_before_all_versions})
struct Since {
    std::uint32_t version = 0;  ///< writes of this version are not after it
};

/// That many versions ago lies before all that a world knows: every 2²⁹ versions it raises those that are
/// more than 2³⁰ old.
inline constexpr std::uint32_t k_before_all_versions = (3u << 29u) + 1;

/// Whether `a` came after `b`. Versions wrap around after 2³²; holds for distances below 2³¹.
constexpr bool is_after(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::int32_t>(a - b) > 0;
}

/// Whether `version` is `since` or later.
constexpr bool is_since(std::uint32_t version, std::uint32_t since) {
    return !is_after(since, version);
}

/// The one that came after the other.
constexpr std::uint32_t later(std::uint32_t a, std::uint32_t b) {
    return is_after(a, b) ? a : b;
}

}  // namespace rambla::ecs
