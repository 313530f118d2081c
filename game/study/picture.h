#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "assets/image.h"

namespace rambla::game::study {

/// A picture of linear Rec. 709 light, row-major, top row first.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec3> texels{};  ///< width · height

    [[nodiscard]] const glm::vec3& at(std::uint32_t x, std::uint32_t y) const {
        return texels[std::size_t{y} * width + x];
    }
    [[nodiscard]] glm::vec3& at(std::uint32_t x, std::uint32_t y) {
        return texels[std::size_t{y} * width + x];
    }
};

/// @param image  rgba8 is sRGB, rgba32f linear light
[[nodiscard]] Picture to_picture(const assets::Image& image);

}  // namespace rambla::game::study
