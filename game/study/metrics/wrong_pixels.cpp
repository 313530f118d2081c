#include "game/study/metrics/wrong_pixels.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "game/study/metrics/edge_distance.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

void require_counts(glm::uvec2 size, std::size_t reference, std::size_t test) {
    const std::size_t count = std::size_t{size.x} * size.y;
    if (reference == count && test == count) return;
    throw std::invalid_argument(
        fmt::format("{} reference and {} test values for {}x{} pixels", reference, test, size.x, size.y));
}

/// @param differ  of two values
template <class Value, class Differ>
std::vector<std::uint8_t> find_edges(glm::uvec2 size, std::span<const Value> values, Differ differ) {
    std::vector<std::uint8_t> is_edge(values.size(), 0);
    const auto compare = [&](std::size_t a, std::size_t b) {
        if (differ(values[a], values[b])) is_edge[a] = is_edge[b] = 1;
    };
    for (std::size_t y = 0; y < size.y; ++y)
        for (std::size_t x = 0; x < size.x; ++x) {
            const std::size_t i = y * size.x + x;
            if (x + 1 < size.x) compare(i, i + 1);
            if (y + 1 < size.y) compare(i, i + size.x);
        }
    return is_edge;
}

template <class Value, class Differ>
WrongPixels count_wrong(glm::uvec2 size, std::span<const Value> reference, std::span<const Value> test,
                        double edge_px, Differ differ) {
    require_counts(size, reference.size(), test.size());
    const std::vector<double> distances = edge_distance_px(size, find_edges(size, reference, differ));
    std::size_t wrong = 0;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!differ(reference[i], test[i])) continue;
        ++wrong;
        if (distances[i] > edge_px) ++beyond;
    }
    return {.wrong_pixels_pct = percent(wrong, reference.size()),
            .wrong_beyond_edge_pct = percent(beyond, reference.size())};
}

}  // namespace

WrongPixels wrong_pixels(glm::uvec2 size_px, std::span<const float> reference, std::span<const float> test,
                         WrongPixelLimits limits) {
    return count_wrong(size_px, reference, test, limits.edge_px, [&](float a, float b) {
        if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
        if (a == b) return false;  // infinities too, whose difference is NaN
        return std::abs(double{a} - double{b}) > limits.tolerance;
    });
}

WrongPixels wrong_pixels(glm::uvec2 size_px, std::span<const std::uint32_t> reference,
                         std::span<const std::uint32_t> test, double edge_px) {
    return count_wrong(size_px, reference, test, edge_px,
                       [](std::uint32_t a, std::uint32_t b) { return a != b; });
}

double wrong_pixels_pct(const Picture& reference, const Picture& test, double tolerance) {
    require_same_size(reference, test);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < reference.texels.size(); ++i)
        if (largest_channel_difference(reference.texels[i], test.texels[i]) > tolerance) ++wrong;
    return percent(wrong, reference.texels.size());
}

}  // namespace rambla::game::study
