#pragma once

#include <cstdint>

namespace rambla::assets::generate {

/// Bijective scrambling of 64 bits: the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t scramble(std::uint64_t x) {
    x = (x ^ (x >> 30u)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27u)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31u);
}

/// A key for something that belongs to `key` and is told apart by `part`.
[[nodiscard]] constexpr std::uint64_t key_of(std::uint64_t key, std::uint64_t part) {
    return scramble(key + 0x9e3779b97f4a7c15ull * (part + 1));
}

/// Counter-based random numbers: the n-th draw depends on key and n alone, on every platform alike.
class Draws {
public:
    constexpr explicit Draws(std::uint64_t key) : key_{key} {}
    constexpr Draws(std::uint64_t key, std::uint64_t part) : key_{key_of(key, part)} {}

    [[nodiscard]] constexpr std::uint64_t bits() { return key_of(key_, counter_++); }
    /// Uniform in [0, 1), a multiple of 2⁻²⁴: every value is exact in a float.
    [[nodiscard]] constexpr float unit() { return static_cast<float>(bits() >> 40u) * 0x1p-24f; }
    [[nodiscard]] constexpr float between(float low, float high) { return low + (high - low) * unit(); }
    /// Uniform in [0, count); count > 0.
    [[nodiscard]] constexpr std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(((bits() >> 32u) * count) >> 32u);
    }
    [[nodiscard]] constexpr bool chance(float probability) { return unit() < probability; }

private:
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

}  // namespace rambla::assets::generate
