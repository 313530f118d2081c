#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "assets/image.h"

namespace rambla::assets::generate {

/// What a texture is while it is painted: per texel a colour (in the encoding it will be stored in) and a
/// height.
struct Texel {
    glm::vec4 colour{1.0f};
    float height_m = 0.0f;
    float roughness = 1.0f;
};

/// Heights below a surface.
struct Relief {
    Image image;
    float depth = 0.0f;  ///< from the lowest to the highest, as a share of the width
};

/// A painted texture before it is cut into images.
class Canvas {
public:
    Canvas(std::uint32_t width, std::uint32_t height)
        : width_{width}, height_{height}, texels_(width * height) {}

    /// Paints every texel from its centre (u, v) in (0, 1)², v downwards. Rows in parallel; `brush` must be
    /// pure.
    template <class Brush>
    void paint(const Brush& brush) {
        tbb::parallel_for(std::uint32_t{0}, height_, [&](std::uint32_t y) {
            const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height_);
            for (std::uint32_t x = 0; x < width_; ++x)
                texels_[y * width_ + x] =
                    brush(glm::vec2{(static_cast<float>(x) + 0.5f) / static_cast<float>(width_), v});
        });
    }

    [[nodiscard]] Texel& at(std::uint32_t x, std::uint32_t y) { return texels_[y * width_ + x]; }
    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }

    [[nodiscard]] Image colour_image(const std::string& name) const;
    /// Tangent-space normals of the heights, wrapping around: x right, y up the image, z outwards.
    /// @param width_m  what the canvas's width covers
    [[nodiscard]] Image normal_image(const std::string& name, float width_m) const;
    /// The same heights from the lowest, 0, to the highest, 1, in all channels.
    [[nodiscard]] Relief relief(const std::string& name, float width_m) const;
    /// Roughness in G, metalness 0 in B, occlusion 1 in R.
    [[nodiscard]] Image roughness_image(const std::string& name) const;

private:
    std::uint32_t width_;
    std::uint32_t height_;
    std::vector<Texel> texels_;
};

}  // namespace rambla::assets::generate
