#include "game/study/metrics/texels.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rambla::game::study {
namespace {

void require_whole(const Picture& picture) {
    if (picture.texels.size() == std::size_t{picture.width} * picture.height) return;
    throw std::invalid_argument(fmt::format("a picture of {}x{} has {} texels", picture.width, picture.height,
                                            picture.texels.size()));
}

}  // namespace

double largest_channel_difference(glm::vec3 a, glm::vec3 b) {
    if (is_finite(a) != is_finite(b)) return std::numeric_limits<double>::infinity();
    if (!is_finite(a)) return 0.0;
    const glm::dvec3 difference = glm::abs(glm::dvec3{a} - glm::dvec3{b});
    return std::max({difference.x, difference.y, difference.z});
}

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void require_same_size(const Picture& a, const Picture& b) {
    require_whole(a);
    require_whole(b);
    if (a.width == b.width && a.height == b.height) return;
    throw std::invalid_argument(
        fmt::format("pictures of {}x{} and {}x{} cannot be compared", a.width, a.height, b.width, b.height));
}

}  // namespace rambla::game::study
