#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "render/shaders/shared/bloom.h"

namespace rambla::render {

/// How bright light is spread, whatever the method: the mean of four Gaussians with these standard deviations
/// in pixels, 3 texels at 1/8, 1/16, 1/32 and 1/64 of the picture's size.
inline constexpr std::array<double, 4> k_bloom_sigmas_px{24.0, 48.0, 96.0, 192.0};
/// Pixels along the edge of a texel of the finest bright light that most methods spread.
inline constexpr std::uint32_t k_bloom_texel_px = 8;
/// The same of `iterated`.
inline constexpr std::uint32_t k_bloom_half_texel_px = 2;

/// Weights of a symmetric filter along one axis, merged so that one bilinear fetch takes two texels.
struct BlurKernel {
    struct Pair {
        double offset_texels = 0.0;  ///< from the middle, on either side
        double weight = 0.0;         ///< of each side
    };
    double middle = 0.0;
    std::array<Pair, shared::k_bloom_tap_pairs> pairs{};
};

/// The Gaussian of 21 texels whose weights sum to 1 and whose variance is the one asked for.
/// @param variance_texels2  0.1 to 16: up to four standard deviations are not cut off
[[nodiscard]] BlurKernel gaussian_kernel(double variance_texels2);

/// 13 texels in 7 fetches: the binomial coefficients of 16 without the outer two on each side, of variance
/// 3.98. The published weights, made to sum to 1.
[[nodiscard]] BlurKernel thirteen_tap_kernel();

[[nodiscard]] double sum(const BlurKernel& kernel);
/// Mean square distance from the middle, in texels².
[[nodiscard]] double variance_of(const BlurKernel& kernel);

/// What linear interpolation adds to the variance of light, on average over the places between two texels:
/// f(1 − f) at a share f of the way, in texels².
/// @param steps  equally far places between two texels that are used, each in the middle of its step
[[nodiscard]] constexpr double interpolation_variance(double steps) {
    return 1.0 / 6.0 + 1.0 / (12.0 * steps * steps);
}

/// Finds the mixture of given Gaussians that comes nearest to the mean of the four of k_bloom_sigmas_px.
/// Nearest as lines of light are spread, by the squared error: points would let the narrowest decide, flat
/// areas do not tell methods apart.
/// @param variances_px2  of the Gaussians, > 0; at most 32
/// @param shares         of each: not negative, of sum 1
void fit_bloom(std::span<const double> variances_px2, std::span<double> shares);

}  // namespace rambla::render
