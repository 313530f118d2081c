#include <span>

#include "render/post/bloom_spread.h"

namespace rambla::render {
namespace {

/// Down to 1/256: the widest that the finer ones reach falls short of the widest Gaussian.
constexpr std::size_t k_levels = 6;

/// On the way down light moves by a texel of the finer level, half the taps on each axis, each taken between
/// two texels: 1/2 + 1/4.
constexpr double k_down_texels2 = 0.75;
/// On the way up, in texels of the coarser level: on each axis two of twelve parts a texel off and eight half
/// of one, all interpolated at a quarter of the way between two texels.
constexpr double k_up_texels2 = (2.0 * 1.0 + 8.0 * 0.25) / 12.0 + 0.25 * 0.75;

void fit(BloomShares& shares) {
    std::array<double, k_levels> variances{};
    double texel_px = k_bloom_texel_px;
    double variance = 2.0 * texel_px * texel_px * interpolation_variance(texel_px);
    for (std::size_t level = 0; level < k_levels; ++level) {
        variances[level] = variance;
        variance += texel_px * texel_px * (k_down_texels2 + 4.0 * k_up_texels2);
        texel_px *= 2.0;
    }
    shares.count = k_levels;
    fit_bloom(variances, std::span{shares.of}.first(k_levels));
}

}  // namespace

BloomLight spread_by_dual_filter(BloomSteps& steps, BloomLight bright, BloomShares& shares) {
    if (shares.count != k_levels) fit(shares);
    std::array<BloomLight, k_levels> levels{bright};
    for (std::size_t level = 1; level < k_levels; ++level)
        levels[level] = steps.step("bloom down", BloomProgram::dual_down, half_of(levels[level - 1].size),
                                   levels[level - 1]);
    BloomLight sum = levels.back();
    for (std::size_t level = k_levels - 1; level-- > 0;) {
        shared::BloomStep parts{};
        const bool coarsest = level + 2 == k_levels;
        parts.share = {coarsest ? static_cast<float>(shares.of[level + 1]) : 1.0f,
                       static_cast<float>(shares.of[level]), 0.0f, 0.0f};
        sum = steps.step("bloom up", BloomProgram::dual_up, levels[level].size, sum, parts, levels[level]);
    }
    return sum;
}

}  // namespace rambla::render
