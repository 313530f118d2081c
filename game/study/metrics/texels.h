#pragma once

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "game/study/picture.h"

namespace rambla::game::study {

[[nodiscard]] inline bool is_finite(glm::vec3 light) {
    return std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z);
}

/// What a metric takes a texel for: NaN and infinities are black, all three channels of it.
[[nodiscard]] inline glm::vec3 finite_or_black(glm::vec3 light) {
    return is_finite(light) ? light : glm::vec3{0.0f};
}

/// Relative luminance of linear Rec. 709 light.
[[nodiscard]] inline double luminance(glm::dvec3 light) {
    return 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
}

/// Largest difference of a channel, linear light. Two texels that are not finite are equal, one that is and
/// one that is not differ infinitely: a hole in a picture never goes unseen.
[[nodiscard]] double largest_channel_difference(glm::vec3 a, glm::vec3 b);

/// Part of a whole in percent; 0 of nothing.
[[nodiscard]] double percent(std::size_t part, std::size_t whole);

/// @throws std::invalid_argument saying both sizes when they differ, or when a picture has not as many texels
///         as its size asks for
void require_same_size(const Picture& a, const Picture& b);

}  // namespace rambla::game::study
