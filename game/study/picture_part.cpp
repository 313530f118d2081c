#include "game/study/picture_part.h"

#include <algorithm>
#include <cstdlib>

#include "assets/assert.h"

namespace rambla::game::study {
namespace {

/// Sum of the differences of all channels that are seen, over every `k_stride`th pixel both ways.
std::uint64_t difference(const assets::Image& a, const assets::Image& b, glm::uvec2 corner,
                         glm::uvec2 size_px) {
    constexpr std::uint32_t k_stride = 2;
    std::uint64_t sum = 0;
    for (std::uint32_t y = corner.y; y < std::min(corner.y + size_px.y, a.height); y += k_stride) {
        for (std::uint32_t x = corner.x; x < std::min(corner.x + size_px.x, a.width); x += k_stride) {
            const std::size_t texel = 4 * (std::size_t{y} * a.width + x);
            for (std::size_t channel = texel; channel < texel + 3; ++channel)
                sum += static_cast<std::uint64_t>(std::abs(std::to_integer<int>(a.texels[channel]) -
                                                           std::to_integer<int>(b.texels[channel])));
        }
    }
    return sum;
}

}  // namespace

assets::Image part_of(const assets::Image& image, glm::uvec2 corner_px, glm::uvec2 size_px) {
    const glm::uvec2 corner = glm::min(corner_px, {image.width, image.height});
    const glm::uvec2 size = glm::min(size_px, glm::uvec2{image.width, image.height} - corner);
    const std::size_t texel = assets::bytes_per_texel(image.format);
    assets::Image part{
        .name = image.name, .width = size.x, .height = size.y, .format = image.format, .texels = {}};
    part.texels.reserve(std::size_t{size.x} * size.y * texel);
    for (std::uint32_t y = corner.y; y < corner.y + size.y; ++y) {
        const auto row = image.texels.begin() +
                         static_cast<std::ptrdiff_t>((std::size_t{y} * image.width + corner.x) * texel);
        part.texels.insert(part.texels.end(), row, row + static_cast<std::ptrdiff_t>(size.x * texel));
    }
    return part;
}

glm::uvec2 most_different_part(const assets::Image& a, const assets::Image& b, glm::uvec2 size_px) {
    RAMBLA_ASSERT(a.texels.size() == b.texels.size() && a.width == b.width, "pictures of one size");
    const glm::uvec2 step = glm::max(size_px / 8u, glm::uvec2{1});
    glm::uvec2 best{0};
    std::uint64_t most = 0;
    for (std::uint32_t y = 0; y == 0 || y + size_px.y <= a.height; y += step.y) {
        for (std::uint32_t x = 0; x == 0 || x + size_px.x <= a.width; x += step.x) {
            const std::uint64_t sum = difference(a, b, {x, y}, size_px);
            if (sum <= most) continue;
            most = sum;
            best = {x, y};
        }
    }
    return best;
}

assets::Image enlarged(const assets::Image& image, std::uint32_t times) {
    const std::size_t texel = assets::bytes_per_texel(image.format);
    assets::Image large{.name = image.name,
                        .width = times * image.width,
                        .height = times * image.height,
                        .format = image.format,
                        .texels = {}};
    large.texels.reserve(texel * large.width * large.height);
    for (std::size_t y = 0; y < large.height; ++y) {
        for (std::size_t x = 0; x < large.width; ++x) {
            const auto from = image.texels.begin() +
                              static_cast<std::ptrdiff_t>(texel * (y / times * image.width + x / times));
            large.texels.insert(large.texels.end(), from, from + static_cast<std::ptrdiff_t>(texel));
        }
    }
    return large;
}

}  // namespace rambla::game::study
