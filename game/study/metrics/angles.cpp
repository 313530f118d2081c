#include "game/study/metrics/angles.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "game/statistics.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

bool is_direction(glm::vec3 v) {
    return is_finite(v) && v != glm::vec3{0.0f};
}

}  // namespace

double angle_rad(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Angles angles_between(std::span<const glm::vec3> reference, std::span<const glm::vec3> test) {
    if (reference.size() != test.size())
        throw std::invalid_argument(
            fmt::format("{} directions cannot be compared with {}", reference.size(), test.size()));
    std::vector<double> angles_deg;
    angles_deg.reserve(reference.size());
    for (std::size_t i = 0; i < reference.size(); ++i)
        if (is_direction(reference[i]) && is_direction(test[i]))
            angles_deg.push_back(glm::degrees(angle_rad(glm::dvec3{reference[i]}, glm::dvec3{test[i]})));
    return {.p50_deg = median(angles_deg),
            .p99_deg = percentile(angles_deg, 0.99),
            .max_deg = percentile(angles_deg, 1.0),
            .counted = angles_deg.size(),
            .not_counted = reference.size() - angles_deg.size()};
}

}  // namespace rambla::game::study
