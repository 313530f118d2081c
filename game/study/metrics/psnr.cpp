#include "game/study/metrics/psnr.h"

#include <cmath>
#include <limits>

#include "assets/process/srgb.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

glm::dvec3 display_value(glm::vec3 light) {
    return {assets::srgb_from_linear(light.x), assets::srgb_from_linear(light.y),
            assets::srgb_from_linear(light.z)};
}

/// Sum over the three channels.
double squared_difference(glm::vec3 a, glm::vec3 b) {
    if (is_finite(a) != is_finite(b)) return 3.0;
    const glm::dvec3 difference = display_value(finite_or_black(a)) - display_value(finite_or_black(b));
    return glm::dot(difference, difference);
}

}  // namespace

double psnr_db(const Picture& reference, const Picture& test) {
    require_same_size(reference, test);
    double sum = 0.0;
    for (std::size_t i = 0; i < reference.texels.size(); ++i)
        sum += squared_difference(reference.texels[i], test.texels[i]);
    if (sum == 0.0) return std::numeric_limits<double>::infinity();
    const double mean = sum / (3.0 * static_cast<double>(reference.texels.size()));
    return -10.0 * std::log10(mean) + 0.0;  // + 0: no negative zero for black against white
}

}  // namespace rambla::game::study
