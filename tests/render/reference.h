#pragma once

#include <cmath>

namespace rambla::tests {

inline constexpr double k_pi = 3.14159265358979323846;

/// Albedo as the G-buffer's 8-bit sRGB texel holds it. The shader's decoding is off by at most 0.06 of a
/// byte's step.
[[nodiscard]] inline double stored_albedo(double albedo) {
    const double encoded = albedo <= 0.0031308 ? 12.92 * albedo : 1.055 * std::pow(albedo, 1.0 / 2.4) - 0.055;
    const double byte = std::round(encoded * 255.0) / 255.0;
    return byte <= 0.04045 ? byte / 12.92 : std::pow((byte + 0.055) / 1.055, 2.4);
}

/// glTF's dielectric of roughness 1 (α = 1): Lambert under a Fresnel layer; GGX is then 1/π for all half
/// vectors.
/// @param n_dot_l, n_dot_v, v_dot_h  cosines
[[nodiscard]] inline double rough_dielectric(double albedo, double n_dot_l, double n_dot_v, double v_dot_h) {
    const double fresnel = 0.04 + 0.96 * std::pow(1.0 - v_dot_h, 5.0);
    const double visibility = 0.5 / (n_dot_l + n_dot_v);  // Smith with α = 1
    return ((1.0 - fresnel) * albedo / k_pi + fresnel / k_pi * visibility) * n_dot_l;
}

}  // namespace rambla::tests
