#pragma once

#include <cstdint>

namespace rambla::assets::generate {

/// Linear congruential generator modulo 2³² with the constants of Press et al., "Numerical recipes", ch. 7.1:
/// simple enough that other engines draw the same numbers. Scenes of our own use Draws.
class Lcg {
public:
    constexpr explicit Lcg(std::uint32_t seed) : state_{seed} {}

    /// Uniform in [0, 1), a multiple of 2⁻²⁴.
    [[nodiscard]] constexpr float next() {
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<float>(state_ >> 8u) * 0x1p-24f;
    }

private:
    std::uint32_t state_;
};

}  // namespace rambla::assets::generate
