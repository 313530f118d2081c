#include "assets/trace/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace rambla::assets {
namespace {

TEST(TraceSamples, EachLiesInACellOfItsOwn) {
    for (const std::uint32_t count : {1u, 7u, 12u, 64u}) {
        const std::uint32_t columns = count == 64 ? 8 : count == 12 ? 3 : 1, rows = count / columns;
        std::set<std::pair<int, int>> cells;
        for (std::uint32_t s = 0; s < count; ++s) {
            const glm::dvec2 p = stratified_sample(9, 4, s, count);
            EXPECT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
            cells.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
        }
        EXPECT_EQ(cells.size(), count);
    }
}

TEST(TraceSamples, DependOnSeedPixelAndNumberAlone) {
    const glm::dvec2 p = stratified_sample(1, 2, 3, 16);
    EXPECT_EQ(p, stratified_sample(1, 2, 3, 16));
    EXPECT_NE(p, stratified_sample(2, 2, 3, 16));
    EXPECT_NE(p, stratified_sample(1, 3, 3, 16));
}

// Moments of the uniform disc: mean 0, mean of x² and of y² ¼; of the cosine-weighted hemisphere: mean cosine
// ⅔.
TEST(TraceSamples, DiscAndHemisphereAreCoveredEvenly) {
    constexpr std::uint32_t k_count = 256 * 256;
    glm::dvec2 mean{0.0}, square{0.0};
    glm::dvec3 sum{0.0};
    const glm::dvec3 normal = glm::normalize(glm::dvec3{0.3, -0.5, -0.8});
    double cosine = 0.0;
    for (std::uint32_t s = 0; s < k_count; ++s) {
        const glm::dvec2 p = on_disc(stratified_sample(0, 0, s, k_count));
        EXPECT_LE(glm::dot(p, p), 1.0 + 1e-12);
        mean += p / static_cast<double>(k_count);
        square += p * p / static_cast<double>(k_count);
        const glm::dvec3 d = around_normal(normal, p);
        EXPECT_NEAR(glm::length(d), 1.0, 1e-12);
        EXPECT_GE(glm::dot(d, normal), -1e-12);
        cosine += glm::dot(d, normal) / k_count;
        sum += d / static_cast<double>(k_count);
    }
    EXPECT_LT(glm::length(mean), 1e-3);  // strata of 1/256, and their errors cancel
    EXPECT_NEAR(square.x, 0.25, 1e-3);
    EXPECT_NEAR(square.y, 0.25, 1e-3);
    EXPECT_NEAR(cosine, 2.0 / 3.0, 1e-3);
    EXPECT_LT(glm::distance(sum, 2.0 / 3.0 * normal), 1e-3);
    EXPECT_EQ(on_disc({0.5, 0.5}), (glm::dvec2{0.0}));
}

TEST(TraceSamples, EveryNormalHasItsHemisphere) {
    for (const glm::dvec3 normal :
         {glm::dvec3{0, 0, 1}, glm::dvec3{0, 0, -1}, glm::dvec3{1, 0, 0}, glm::dvec3{0, -1, 0}}) {
        EXPECT_LT(glm::distance(around_normal(normal, {0, 0}), normal), 1e-12);
        const glm::dvec3 x = around_normal(normal, {1, 0}), y = around_normal(normal, {0, 1});
        EXPECT_NEAR(glm::dot(x, normal), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(y, normal), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(x, y), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace rambla::assets
