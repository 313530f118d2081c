#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The filters of ꟻLIP, all of them separable, so that each is a row of weights applied along x and along y.
namespace rambla::game::study::flip {

/// An odd number of weights, the middle one for the pixel itself.
using Kernel = std::vector<float>;

[[nodiscard]] inline int radius_of(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

/// A Gaussian of the eye's blur of one opponent channel; a channel's blur is the sum of its terms.
struct BlurTerm {
    int channel;    ///< 0 luminance, 1 red-green, 2 blue-yellow
    Kernel kernel;  ///< applied along both axes
};

struct Kernels {
    /// Spatial contrast sensitivity of the eye; a channel's weights sum to 1 over the plane.
    std::array<BlurTerm, 4> blur;
    Kernel gaussian;  ///< across a feature's direction; sums to 1
    Kernel edge;      ///< first derivative of the Gaussian: its halves sum to −1 and 1
    Kernel point;     ///< second derivative: negative weights sum to −1, positive ones to 1
};

/// @param pixels_per_degree  1 to 10 000
[[nodiscard]] Kernels kernels_for(double pixels_per_degree);

/// Adds the weighted rows of a kernel to a row of sums.
/// @param row_at  (int offset) → const float*, a row of as many values, from −radius to radius
template <class RowAt>
void add_weighted(const Kernel& kernel, RowAt row_at, std::span<float> sums) {
    const int radius = radius_of(kernel);
    for (int offset = -radius; offset <= radius; ++offset) {
        const float weight = kernel[static_cast<std::size_t>(offset + radius)];
        const float* const row = row_at(offset);
        for (std::size_t x = 0; x < sums.size(); ++x)
            sums[x] += weight * row[x];
    }
}

/// The same with a kernel whose weights sum to 0, of differences to the middle row: gives exactly 0 on a flat
/// area, where the square root in the feature term would make 1e-4 of a rounding error of 1e-8.
template <class RowAt>
void add_weighted_differences(const Kernel& kernel, RowAt row_at, std::span<float> sums) {
    const int radius = radius_of(kernel);
    const float* const middle = row_at(0);
    for (int offset = -radius; offset <= radius; ++offset) {
        const float weight = kernel[static_cast<std::size_t>(offset + radius)];
        const float* const row = row_at(offset);
        for (std::size_t x = 0; x < sums.size(); ++x)
            sums[x] += weight * (row[x] - middle[x]);
    }
}

}  // namespace rambla::game::study::flip
