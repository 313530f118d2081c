#include "assets/process/coverage.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rambla::assets {

namespace {

/// Where samples of one axis lie between texels.
struct Tap {
    std::uint32_t texel = 0;
    std::uint32_t next = 0;
    float share = 0.0f;  ///< of the next one
};

std::vector<Tap> taps(std::uint32_t size, std::uint32_t per_texel) {
    std::vector<Tap> all(std::size_t{size} * per_texel);
    for (std::size_t i = 0; i < all.size(); ++i) {
        // Texel centres lie at halves; the first half texel mixes with the last one.
        const double place = (static_cast<double>(i) + 0.5) / per_texel - 0.5 + size;
        const auto below = static_cast<std::uint32_t>(place);
        all[i] = {below % size, (below + 1) % size, static_cast<float>(place - below)};
    }
    return all;
}

/// Alpha as it is stored: eight bits, saturated.
float stored(float alpha) {
    return std::round(std::clamp(alpha, 0.0f, 1.0f) * 255.0f) / 255.0f;
}

double scaled_coverage(const Raster& picture, float cutoff, float scale) {
    constexpr double k_fewest_samples = 65'536.0;
    const double texels = static_cast<double>(picture.texels.size());
    const auto per_texel =
        static_cast<std::uint32_t>(std::max(2.0, std::ceil(std::sqrt(k_fewest_samples / texels))));
    const std::vector<Tap> columns = taps(picture.width, per_texel);
    const std::vector<Tap> rows = taps(picture.height, per_texel);
    const auto passing = [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t count) {
        const auto alpha = [&](std::uint32_t y, std::uint32_t x) {
            return stored(scale * picture.texels[std::size_t{y} * picture.width + x].w);
        };
        std::vector<float> line(picture.width);
        for (std::size_t y = range.begin(); y < range.end(); ++y) {
            for (std::uint32_t x = 0; x < picture.width; ++x)
                line[x] = std::lerp(alpha(rows[y].texel, x), alpha(rows[y].next, x), rows[y].share);
            for (const Tap& tap : columns)
                count += std::lerp(line[tap.texel], line[tap.next], tap.share) >= cutoff ? 1 : 0;
        }
        return count;
    };
    const std::uint64_t count = tbb::parallel_reduce(tbb::blocked_range<std::size_t>{0, rows.size()},
                                                     std::uint64_t{0}, passing, std::plus<>{});
    return static_cast<double>(count) /
           (static_cast<double>(rows.size()) * static_cast<double>(columns.size()));
}

}  // namespace

double alpha_coverage(const Raster& picture, float cutoff) {
    return scaled_coverage(picture, cutoff, 1.0f);
}

void keep_coverage(Raster& picture, double coverage, float cutoff) {
    if (alpha_coverage(picture, cutoff) >= coverage) return;
    // Coverage does not fall as the scale grows: halve the range of its exponents. At 2⁸ every step is
    // opaque.
    float low = 0.0f;
    float high = 8.0f;
    const double wanted = std::min(coverage, scaled_coverage(picture, cutoff, std::exp2(high)));
    constexpr int k_halvings = 16;
    for (int i = 0; i < k_halvings; ++i) {
        const float exponent = 0.5f * (low + high);
        (scaled_coverage(picture, cutoff, std::exp2(exponent)) < wanted ? low : high) = exponent;
    }
    const float scale = std::exp2(high);
    for (glm::vec4& texel : picture.texels)
        texel.w = std::min(1.0f, scale * texel.w);
}

}  // namespace rambla::assets
