#include "render/post/bloom_kernel.h"

#include <algorithm>
#include <cmath>

#include "assets/assert.h"

namespace rambla::render {
namespace {

constexpr std::size_t k_radius_texels = 2 * shared::k_bloom_tap_pairs;
constexpr std::size_t k_most_gaussians = 32;

/// One side of a filter, from the middle on.
using Weights = std::array<double, k_radius_texels + 1>;

Weights gaussian_weights(double parameter) {
    Weights weights{};
    double total = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto x = static_cast<double>(i);
        weights[i] = std::exp(-0.5 * x * x / parameter);
        total += i == 0 ? weights[i] : 2.0 * weights[i];
    }
    for (double& weight : weights)
        weight /= total;
    return weights;
}

double variance_of(const Weights& weights) {
    double variance = 0.0;
    for (std::size_t i = 1; i < weights.size(); ++i)
        variance += 2.0 * static_cast<double>(i * i) * weights[i];
    return variance;
}

/// Integral of the product of two Gaussians of one dimension, up to a factor.
double overlap(double variance_a, double variance_b) {
    return 1.0 / std::sqrt(variance_a + variance_b);
}

}  // namespace

BlurKernel gaussian_kernel(double variance_texels2) {
    // Texels are samples, and the ends are cut off: look for the parameter that gives the variance.
    double low = 0.01, high = 64.0;
    constexpr int k_halvings = 60;
    for (int i = 0; i < k_halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (variance_of(gaussian_weights(middle)) < variance_texels2 ? low : high) = middle;
    }
    const Weights weights = gaussian_weights(low);
    BlurKernel kernel{.middle = weights[0]};
    for (std::size_t pair = 0; pair < kernel.pairs.size(); ++pair) {
        const double nearer = weights[2 * pair + 1], farther = weights[2 * pair + 2];
        const double weight = nearer + farther;
        const double between = weight > 0.0 ? farther / weight : 0.0;
        kernel.pairs[pair] = {static_cast<double>(2 * pair + 1) + between, weight};
    }
    return kernel;
}

BlurKernel thirteen_tap_kernel() {
    BlurKernel kernel{.middle = 0.1964825501511404};
    kernel.pairs[0] = {1.411764705882353, 0.2969069646728344};
    kernel.pairs[1] = {3.2941176470588234, 0.09447039785044732};
    kernel.pairs[2] = {5.176470588235294, 0.010381362401148057};
    const double total = sum(kernel);
    kernel.middle /= total;
    for (BlurKernel::Pair& pair : kernel.pairs)
        pair.weight /= total;
    return kernel;
}

double sum(const BlurKernel& kernel) {
    double total = kernel.middle;
    for (const BlurKernel::Pair& pair : kernel.pairs)
        total += 2.0 * pair.weight;
    return total;
}

double variance_of(const BlurKernel& kernel) {
    double variance = 0.0;
    for (const BlurKernel::Pair& pair : kernel.pairs) {
        const double nearer = std::floor(pair.offset_texels), share = pair.offset_texels - nearer;
        const double farther = nearer + 1.0;
        variance += 2.0 * pair.weight * ((1.0 - share) * nearer * nearer + share * farther * farther);
    }
    return variance;
}

void fit_bloom(std::span<const double> variances_px2, std::span<double> shares) {
    RAMBLA_ASSERT(
        variances_px2.size() == shares.size() && !shares.empty() && shares.size() <= k_most_gaussians,
        "a share for each Gaussian");
    const std::size_t count = shares.size();
    std::fill(shares.begin(), shares.end(), 1.0 / static_cast<double>(count));
    std::array<double, k_most_gaussians> slope{};  // half the squared error's derivative by each share
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j)
            slope[i] += shares[j] * overlap(variances_px2[i], variances_px2[j]);
        for (const double sigma_px : k_bloom_sigmas_px)
            slope[i] -= overlap(variances_px2[i], sigma_px * sigma_px) /
                        static_cast<double>(k_bloom_sigmas_px.size());
    }
    // Moves share from one Gaussian to another, as much as is best and there is, pair by pair, until nothing
    // is won.
    constexpr int k_sweeps = 2000;
    for (int sweep = 0; sweep < k_sweeps; ++sweep) {
        double moved = 0.0;
        for (std::size_t a = 0; a < count; ++a) {
            for (std::size_t b = a + 1; b < count; ++b) {
                const double curvature = overlap(variances_px2[a], variances_px2[a]) +
                                         overlap(variances_px2[b], variances_px2[b]) -
                                         2.0 * overlap(variances_px2[a], variances_px2[b]);
                if (curvature <= 0.0) continue;
                const double step = std::clamp((slope[b] - slope[a]) / curvature, -shares[a], shares[b]);
                shares[a] += step;
                shares[b] -= step;
                for (std::size_t i = 0; i < count; ++i)
                    slope[i] += step * (overlap(variances_px2[i], variances_px2[a]) -
                                        overlap(variances_px2[i], variances_px2[b]));
                moved = std::max(moved, std::fabs(step));
            }
        }
        constexpr double k_settled = 1e-7;
        if (moved < k_settled) return;
    }
}

}  // namespace rambla::render
