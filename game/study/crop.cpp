#include "game/study/crop.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "assets/assert.h"

namespace rambla::game::study {
namespace {

/// Sums over all that is above and left of a corner of pixels: (width + 1) × (height + 1) of them.
class SummedArea {
public:
    SummedArea(glm::uvec2 size_px, std::span<const float> map)
        : stride_{std::size_t{size_px.x} + 1}, sums_(stride_ * (size_px.y + 1)) {
        for (std::size_t y = 0; y < size_px.y; ++y) {
            double row = 0.0;
            for (std::size_t x = 0; x < size_px.x; ++x) {
                row += static_cast<double>(map[y * size_px.x + x]);
                sums_[(y + 1) * stride_ + x + 1] = sums_[y * stride_ + x + 1] + row;
            }
        }
    }
    [[nodiscard]] double of(const Crop& crop) const {
        const glm::uvec2 end = crop.corner_px + crop.size_px;
        return at(end.x, end.y) - at(crop.corner_px.x, end.y) - at(end.x, crop.corner_px.y) +
               at(crop.corner_px.x, crop.corner_px.y);
    }

private:
    [[nodiscard]] double at(std::size_t x, std::size_t y) const { return sums_[y * stride_ + x]; }

    std::size_t stride_;
    std::vector<double> sums_;
};

}  // namespace

Crop heaviest_crop(glm::uvec2 picture_px, std::span<const float> map, glm::uvec2 size_px) {
    RAMBLA_ASSERT(map.size() == std::size_t{picture_px.x} * picture_px.y, "every pixel has its weight");
    const SummedArea area{picture_px, map};
    Crop best{.size_px = glm::min(size_px, picture_px)};
    double most = area.of(best);
    for (std::uint32_t y = 0; y + best.size_px.y <= picture_px.y; ++y) {
        for (std::uint32_t x = 0; x + best.size_px.x <= picture_px.x; ++x) {
            const Crop crop{.corner_px = {x, y}, .size_px = best.size_px};
            const double sum = area.of(crop);
            if (sum <= most) continue;
            most = sum;
            best = crop;
        }
    }
    return best;
}

assets::Image enlarged(const assets::Image& image, const Crop& crop, std::uint32_t times) {
    RAMBLA_ASSERT(image.format == assets::PixelFormat::rgba8, "pictures for a page are bytes");
    RAMBLA_ASSERT(
        crop.corner_px.x + crop.size_px.x <= image.width && crop.corner_px.y + crop.size_px.y <= image.height,
        "a crop lies in its picture");
    constexpr std::size_t k_texel = 4;
    assets::Image large;
    large.width = crop.size_px.x * times;
    large.height = crop.size_px.y * times;
    large.texels.resize(k_texel * large.width * large.height);
    for (std::size_t y = 0; y < large.height; ++y) {
        const std::size_t row = (crop.corner_px.y + y / times) * image.width + crop.corner_px.x;
        for (std::size_t x = 0; x < large.width; ++x)
            std::copy_n(image.texels.data() + k_texel * (row + x / times), k_texel,
                        large.texels.data() + k_texel * (y * large.width + x));
    }
    return large;
}

}  // namespace rambla::game::study
