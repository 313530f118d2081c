#pragma once

#include <cmath>

namespace rambla::systems {

/// Sine and cosine for the simulation: additions and multiplications of doubles only, so that every compiler
/// and C library gives the same bits, which those of libm do not promise.

inline constexpr double k_pi = 3.14159265358979323846;

namespace detail {

/// Taylor series on [−π/4, π/4]; the first term left out is below 2e-14.
[[nodiscard]] constexpr double sine_near_zero(double x) {
    const double s = x * x;
    return x * (1.0 + s * (-1.0 / 6.0 +
                           s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s * (1.0 / 362880.0 - s / 39916800.0)))));
}
[[nodiscard]] constexpr double cosine_near_zero(double x) {
    const double s = x * x;
    return 1.0 + s * (-1.0 / 2.0 +
                      s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s * (1.0 / 40320.0 +
                                                                 s * (-1.0 / 3628800.0 + s / 479001600.0)))));
}

/// sin(x + quarter · π/2).
[[nodiscard]] inline double shifted_sine(double x, long quarter) {
    const double turns = std::floor(x * (2.0 / k_pi) + 0.5);
    const double rest = x - turns * (0.5 * k_pi);
    switch ((static_cast<long>(turns) + quarter) & 3) {
        case 0:
            return sine_near_zero(rest);
        case 1:
            return cosine_near_zero(rest);
        case 2:
            return -sine_near_zero(rest);
        default:
            return -cosine_near_zero(rest);
    }
}

}  // namespace detail

/// @param angle_rad  |angle| < 1e6; the error is below 1e-9 there
[[nodiscard]] inline double sine(double angle_rad) {
    return detail::shifted_sine(angle_rad, 0);
}
[[nodiscard]] inline double cosine(double angle_rad) {
    return detail::shifted_sine(angle_rad, 1);
}

}  // namespace rambla::systems
