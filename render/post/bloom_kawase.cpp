#include <span>

#include "render/post/bloom_spread.h"

namespace rambla::render {
namespace {

/// Distance of a pass's corners from the texel, on each axis: each lies between four texels.
double corner_texels(int pass) {
    return static_cast<double>(pass) + 0.5;
}

/// Fits the shares of the passes' lights. A corner is the mean of the two texels beside it on each axis.
void fit(int passes, BloomShares& shares) {
    constexpr double k_texel_px = k_bloom_texel_px;
    std::array<double, std::tuple_size_v<decltype(shares.of)>> variances{};
    double variance = 2.0 * interpolation_variance(k_bloom_texel_px);
    for (int pass = 0; pass < passes; ++pass) {
        variance += corner_texels(pass) * corner_texels(pass) + 0.25;
        variances[static_cast<std::size_t>(pass)] = k_texel_px * k_texel_px * variance;
    }
    shares.count = static_cast<std::size_t>(passes);
    fit_bloom(std::span{variances}.first(shares.count), std::span{shares.of}.first(shares.count));
}

}  // namespace

BloomLight spread_by_kawase(BloomSteps& steps, BloomLight bright, int passes, BloomShares& shares) {
    if (shares.count != static_cast<std::size_t>(passes)) fit(passes, shares);
    BloomLight light = bright;
    BloomLight sum{};
    for (int pass = 0; pass < passes; ++pass) {
        shared::BloomStep corners{};
        corners.axis = glm::vec4{static_cast<float>(corner_texels(pass))};
        light = steps.step("bloom corners", BloomProgram::kawase, bright.size, light, corners);
        const auto share = static_cast<float>(shares.of[static_cast<std::size_t>(pass)]);
        if (share <= 0.0f) continue;
        shared::BloomStep parts{};
        parts.share = {share, 1.0f, 0.0f, 0.0f};
        sum = steps.step("bloom sum", sum.texture.valid() ? BloomProgram::share_onto : BloomProgram::share,
                         bright.size, light, parts, sum);
    }
    return sum;
}

}  // namespace rambla::render
