#pragma once

#include <cstdint>

namespace rambla::systems {

/// Counter-based random numbers: a pure function of who asks for which draw, so that neither order nor
/// threads matter.

/// Spreads every bit of the input over all 64 bits of the output; a bijection.
/// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators": the finaliser of SplitMix64.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30u)) * 0xbf58476d1ce4e5b9ull;
    bits = (bits ^ (bits >> 27u)) * 0x94d049bb133111ebull;
    return bits ^ (bits >> 31u);
}

/// @param who    such as an entity's index
/// @param count  which of its draws
[[nodiscard]] constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t who,
                                                  std::uint64_t count) {
    constexpr std::uint64_t k_golden = 0x9e3779b97f4a7c15ull;  // 2⁶⁴ / φ: keeps small inputs apart
    return mixed(mixed(mixed(seed + k_golden) + who + k_golden) + count + k_golden);
}

/// The upper 24 bits as a number in [0, 1), each exact in a float.
[[nodiscard]] constexpr float unit_interval(std::uint64_t bits) {
    return static_cast<float>(bits >> 40u) * (1.0f / 16777216.0f);
}

/// A whole number in [0, count), from the lower 32 bits.
[[nodiscard]] constexpr std::uint32_t below(std::uint64_t bits, std::uint32_t count) {
    return static_cast<std::uint32_t>(((bits & 0xffffffffu) * count) >> 32u);
}

}  // namespace rambla::systems
