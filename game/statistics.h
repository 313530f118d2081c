#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace rambla::game {

/// Value below which the given share of the samples lies, interpolated between neighbours; 0 without samples.
/// @param share  0 (smallest) to 1 (largest); 0.5 is the median
[[nodiscard]] inline double percentile(std::span<const double> samples, double share) {
    if (samples.empty()) return 0.0;
    std::vector<double> sorted{samples.begin(), samples.end()};
    std::sort(sorted.begin(), sorted.end());
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

[[nodiscard]] inline double median(std::span<const double> samples) {
    return percentile(samples, 0.5);
}

}  // namespace rambla::game
