#include <array>

#include "render/post/bloom_spread.h"

namespace rambla::render {
namespace {

constexpr std::size_t k_levels = k_bloom_sigmas_px.size();
constexpr std::array<const char*, k_levels> k_reduce_names{"", "bloom 1/16", "bloom 1/32", "bloom 1/64"};
constexpr std::array<const char*, k_levels> k_across_names{"bloom 1/8 across", "bloom 1/16 across",
                                                           "bloom 1/32 across", "bloom 1/64 across"};
constexpr std::array<const char*, k_levels> k_up_names{"bloom 1/8 up", "bloom 1/16 up", "bloom 1/32 up",
                                                       "bloom 1/64 up"};

/// What is left of a level's variance for its blur, in its texels²: on the way down the tent that makes the
/// first level and the halvings have spread the light already, and on the way up the interpolations will.
double blur_variance(std::size_t level) {
    const double texel_px = static_cast<double>(k_bloom_texel_px << level);
    const double wanted = k_bloom_sigmas_px[level] * k_bloom_sigmas_px[level] / (texel_px * texel_px);
    double spent = 0.0;
    double size = static_cast<double>(k_bloom_texel_px) / texel_px;  // of a texel of the level, in this one's
    spent += 2.0 * size * size * interpolation_variance(k_bloom_texel_px);
    for (std::size_t i = 1; i <= level; ++i) {
        size *= 2.0;
        spent += 2.0 * size * size * interpolation_variance(2.0);
    }
    return wanted - spent;
}

const std::array<BlurKernel, k_levels>& kernels() {
    static const auto all = [] {
        std::array<BlurKernel, k_levels> made;
        for (std::size_t level = 0; level < k_levels; ++level)
            made[level] = gaussian_kernel(blur_variance(level));
        return made;
    }();
    return all;
}

}  // namespace

BloomLight spread_by_pyramid(BloomSteps& steps, BloomLight bright) {
    std::array<BloomLight, k_levels> levels{bright};
    for (std::size_t level = 1; level < k_levels; ++level)
        levels[level] = steps.step(k_reduce_names[level], BloomProgram::reduce,
                                   half_of(levels[level - 1].size), levels[level - 1]);
    BloomLight sum{};
    for (std::size_t level = k_levels; level-- > 0;) {
        const BlurKernel& kernel = kernels()[level];
        const glm::uvec2 size = levels[level].size;
        const BloomLight across = steps.step(k_across_names[level], BloomProgram::gaussian, size,
                                             levels[level], blur_step(kernel, {1.0f, 0.0f}));
        shared::BloomStep up = blur_step(kernel, {0.0f, 1.0f});
        up.share.x = 1.0f / static_cast<float>(k_levels);
        sum = steps.step(k_up_names[level],
                         sum.texture.valid() ? BloomProgram::gaussian_onto : BloomProgram::gaussian, size,
                         across, up, sum);
    }
    return sum;
}

}  // namespace rambla::render
