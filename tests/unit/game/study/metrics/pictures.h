#pragma once

#include <cstdint>
#include <random>

#include "game/study/picture.h"

namespace rambla::game::study {

inline constexpr glm::vec3 k_black{0.0f};
inline constexpr glm::vec3 k_white{1.0f};

[[nodiscard]] inline Picture filled(std::uint32_t width, std::uint32_t height, glm::vec3 light) {
    return {.width = width,
            .height = height,
            .texels = std::vector<glm::vec3>(std::size_t{width} * height, light)};
}

[[nodiscard]] inline Picture with(Picture picture, std::uint32_t x, std::uint32_t y, glm::vec3 light) {
    picture.at(x, y) = light;
    return picture;
}

[[nodiscard]] inline Picture scaled(Picture picture, float factor) {
    for (glm::vec3& texel : picture.texels)
        texel *= factor;
    return picture;
}

/// Independent channels, evenly distributed in [0, 1).
[[nodiscard]] inline Picture noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    std::mt19937 random{seed};
    const auto value = [&random] {
        return static_cast<float>(random() >> 8u) / 16777216.0f;
    };
    Picture picture = filled(width, height, k_black);
    for (glm::vec3& texel : picture.texels) {
        texel.x = value();
        texel.y = value();
        texel.z = value();
    }
    return picture;
}

}  // namespace rambla::game::study
