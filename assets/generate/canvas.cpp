#include "assets/generate/canvas.h"

#include <algorithm>

namespace rambla::assets::generate {

namespace {

std::byte quantised(float value) {
    return static_cast<std::byte>(static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f));
}

template <class Pick>
Image image_of(const std::string& name, std::uint32_t width, std::uint32_t height, const Pick& pick) {
    Image image{name, width, height, PixelFormat::rgba8, {}};
    image.texels.resize(std::size_t{width} * height * 4);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec4 value = pick(x, y);
            std::byte* texel = &image.texels[(std::size_t{y} * width + x) * 4];
            for (int i = 0; i < 4; ++i)
                texel[i] = quantised(value[i]);
        }
    }
    return image;
}

}  // namespace

Image Canvas::colour_image(const std::string& name) const {
    return image_of(name, width_, height_,
                    [&](std::uint32_t x, std::uint32_t y) { return texels_[y * width_ + x].colour; });
}

Image Canvas::normal_image(const std::string& name, float width_m) const {
    const float per_texel = static_cast<float>(width_) / width_m;
    return image_of(name, width_, height_, [&](std::uint32_t x, std::uint32_t y) {
        const auto height_at = [&](std::uint32_t tx, std::uint32_t ty) {
            return texels_[(ty % height_) * width_ + tx % width_].height_m;
        };
        const float right = 0.5f * (height_at(x + 1, y) - height_at(x + width_ - 1, y)) * per_texel;
        const float down = 0.5f * (height_at(x, y + 1) - height_at(x, y + height_ - 1)) * per_texel;
        const glm::vec3 normal = glm::normalize(glm::vec3{-right, down, 1.0f});
        return glm::vec4{0.5f * normal + 0.5f, 1.0f};
    });
}

Relief Canvas::relief(const std::string& name, float width_m) const {
    const auto lower = [](const Texel& a, const Texel& b) {
        return a.height_m < b.height_m;
    };
    const auto [lowest, highest] = std::minmax_element(texels_.begin(), texels_.end(), lower);
    const float least = lowest->height_m;
    const float depth_m = highest->height_m - least;
    const float scale = depth_m > 0.0f ? 1.0f / depth_m : 0.0f;
    return {
        image_of(name, width_, height_,
                 [&](std::uint32_t x, std::uint32_t y) {
                     return glm::vec4{glm::vec3{(texels_[y * width_ + x].height_m - least) * scale}, 1.0f};
                 }),
        depth_m / width_m};
}

Image Canvas::roughness_image(const std::string& name) const {
    return image_of(name, width_, height_, [&](std::uint32_t x, std::uint32_t y) {
        return glm::vec4{1.0f, texels_[y * width_ + x].roughness, 0.0f, 1.0f};
    });
}

}  // namespace rambla::assets::generate
