#include "game/study/metrics/edge_distance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rambla::game::study {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

std::vector<double> by_trying_all(glm::uvec2 size, const std::vector<std::uint8_t>& is_edge) {
    std::vector<double> distances(is_edge.size(), k_infinity);
    for (std::size_t i = 0; i < is_edge.size(); ++i)
        for (std::size_t k = 0; k < is_edge.size(); ++k) {
            const auto coordinate = [](std::size_t value) {
                return static_cast<double>(value);
            };
            const double dx = coordinate(i % size.x) - coordinate(k % size.x);
            const double dy = coordinate(i / size.x) - coordinate(k / size.x);
            if (is_edge[k] != 0) distances[i] = std::min(distances[i], std::sqrt(dx * dx + dy * dy));
        }
    return distances;
}

TEST(EdgeDistance, IsTheSmallestOfAll) {
    std::mt19937 random{1};
    for (int round = 0; round < 300; ++round) {
        const glm::uvec2 size{1 + random() % 24, 1 + random() % 24};
        const std::uint32_t rarity = 1u << random() % 8;  // from everywhere to hardly any
        std::vector<std::uint8_t> is_edge(std::size_t{size.x} * size.y);
        for (std::uint8_t& value : is_edge)
            value = random() % rarity == 0 ? 1 : 0;
        ASSERT_EQ(edge_distance_px(size, is_edge), by_trying_all(size, is_edge)) << round;
    }
}

TEST(EdgeDistance, OfASinglePixelIsTheHypotenuse) {
    std::vector<std::uint8_t> is_edge(5 * 6, 0);
    is_edge[1 * 5 + 0] = 1;
    const std::vector<double> distances = edge_distance_px({5, 6}, is_edge);
    EXPECT_EQ(distances[5 * 5 + 3], 5.0);  // 3, 4, 5
    EXPECT_EQ(distances[1 * 5 + 0], 0.0);
    EXPECT_EQ(distances[0 * 5 + 1], std::sqrt(2.0));
}

TEST(EdgeDistance, IsInfiniteWithoutEdges) {
    EXPECT_THAT(edge_distance_px({4, 3}, std::vector<std::uint8_t>(12, 0)), testing::Each(k_infinity));
    EXPECT_TRUE(edge_distance_px({0, 0}, {}).empty());
}

}  // namespace
}  // namespace rambla::game::study
