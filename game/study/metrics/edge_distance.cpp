#include "game/study/metrics/edge_distance.h"

#include <cmath>
#include <limits>

#include "assets/assert.h"

namespace rambla::game::study {
namespace {

using Squared = std::int64_t;  // whole, so that nothing is rounded; holds the square of any side

constexpr std::int64_t k_none = -1;  // a column without an edge

/// Rows to the nearest edge of the same column, k_none without.
std::vector<std::int64_t> distances_in_columns(glm::uvec2 size, std::span<const std::uint8_t> is_edge) {
    std::vector<std::int64_t> rows(is_edge.size(), k_none);
    const auto come_from = [&](std::size_t i, std::size_t neighbour) {
        if (rows[neighbour] == k_none) return;
        if (rows[i] == k_none || rows[i] > rows[neighbour] + 1) rows[i] = rows[neighbour] + 1;
    };
    const std::size_t width = size.x;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (is_edge[i] != 0) rows[i] = 0;
        if (i >= width) come_from(i, i - width);
    }
    for (std::size_t i = rows.size(); i-- > width;)
        come_from(i - width, i);
    return rows;
}

/// The parabola (x − column)² + height: squared distance to the edge that lies nearest in a column.
struct Parabola {
    std::int64_t column = 0;
    Squared height = 0;
    std::int64_t from = 0;  ///< x from which on it is the lowest of those to its left
};

std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
    return a / b - (a % b < 0 ? 1 : 0);  // b > 0
}

/// First x where `right` is below `left`:
/// (x − r)² + h_r < (x − l)² + h_l  ⇔  2x·(r − l) > r² + h_r − l² − h_l.
std::int64_t crossing(const Parabola& left, const Parabola& right) {
    const Squared difference =
        right.column * right.column + right.height - left.column * left.column - left.height;
    return floor_divided(difference, 2 * (right.column - left.column)) + 1;
}

/// Lowest parabolas of a row from left to right; kept in `lowest`, whose memory is used again.
void find_lowest(std::span<const std::int64_t> rows, std::vector<Parabola>& lowest) {
    lowest.clear();
    for (std::size_t x = 0; x < rows.size(); ++x) {
        if (rows[x] == k_none) continue;
        Parabola next{.column = static_cast<std::int64_t>(x), .height = rows[x] * rows[x], .from = 0};
        while (!lowest.empty()) {
            next.from = crossing(lowest.back(), next);
            if (next.from > lowest.back().from) break;
            lowest.pop_back();  // next is lower wherever it was the lowest
            next.from = 0;
        }
        lowest.push_back(next);
    }
}

void write_distances(std::span<const Parabola> lowest, std::span<double> distances) {
    std::size_t i = 0;
    for (std::size_t column = 0; column < distances.size(); ++column) {
        const auto x = static_cast<std::int64_t>(column);
        while (i + 1 < lowest.size() && lowest[i + 1].from <= x)
            ++i;
        const std::int64_t across = x - lowest[i].column;
        distances[column] = std::sqrt(static_cast<double>(across * across + lowest[i].height));
    }
}

}  // namespace

std::vector<double> edge_distance_px(glm::uvec2 size_px, std::span<const std::uint8_t> is_edge) {
    RAMBLA_ASSERT(is_edge.size() == std::size_t{size_px.x} * size_px.y, "every pixel says if it is an edge");
    std::vector<double> distances(is_edge.size(), std::numeric_limits<double>::infinity());
    const std::vector<std::int64_t> rows = distances_in_columns(size_px, is_edge);
    std::vector<Parabola> lowest;
    for (std::size_t y = 0; y < size_px.y; ++y) {
        const std::size_t first = y * size_px.x;
        find_lowest(std::span{rows}.subspan(first, size_px.x), lowest);
        if (!lowest.empty()) write_distances(lowest, std::span{distances}.subspan(first, size_px.x));
    }
    return distances;
}

}  // namespace rambla::game::study
