#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "assets/material.h"
#include "game/study/lighting_reference.h"
#include "game/study/metrics/flip.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_side = 8;
constexpr std::size_t k_pixels = k_side * k_side;
constexpr std::size_t k_compared = 16;  ///< fewer than half: the median is one of those that are not

double value_of(const std::vector<Metric>& metrics, const std::string& name) {
    for (const Metric& metric : metrics)
        if (metric.name == name) return metric.value;
    ADD_FAILURE() << "no metric " << name;
    return 0.0;
}

Picture grey(float light) {
    return {.width = k_side, .height = k_side, .texels = std::vector(k_pixels, glm::vec3{light})};
}

TEST(LightingErrors, PixelsThatAreLeftOutDoNotChangeThoseThatAreCompared) {
    Picture expected = grey(0.5f);
    expected.texels.front() = glm::vec3{2.0f};
    Picture found = expected;
    found.texels[k_compared / 2] *= 1.1f;
    const Flip whole = hdr_flip(expected, found);
    const double seen = std::accumulate(whole.map.begin(), whole.map.begin() + k_compared, 0.0);
    ASSERT_GT(seen, 0.0);
    const std::vector<std::uint32_t> objects(k_pixels, 7);
    std::vector<std::uint32_t> drawn = objects;
    for (std::size_t i = k_compared; i < k_pixels; ++i) {
        drawn[i] = 8;
        found.texels[i] = glm::vec3{i % 2 == 0 ? 100.0f : 0.0f};
    }
    const auto metrics = lighting_errors(expected, objects, found, drawn, 0.0f);
    EXPECT_EQ(value_of(metrics, "compared_pct"), 25.0);
    EXPECT_DOUBLE_EQ(value_of(metrics, "flip_mean"), seen / k_compared)
        << "as if the pixels that are left out had no error";
    EXPECT_NEAR(value_of(metrics, "error_p99_linear"), 0.05 / 0.51, 0.02) << "10 % of 0.5, over 0.5 + 0.01";
}

TEST(LightingErrors, NothingComparedIsNoPerfectPicture) {
    const std::vector<std::uint32_t> sky(k_pixels, assets::k_none);
    const std::vector<std::uint32_t> objects(k_pixels, 7);
    const std::vector<std::uint32_t> others(k_pixels, 8);
    for (const auto& [expected, found] : {std::pair{sky, sky}, std::pair{objects, others}}) {
        const auto metrics = lighting_errors(grey(1.0f), expected, grey(1.0f), found, 0.0f);
        ASSERT_EQ(metrics.size(), 1u);
        EXPECT_EQ(metrics.front().name, "compared_pct");
        EXPECT_EQ(metrics.front().value, 0.0);
    }
}

}  // namespace
}  // namespace rambla::game::study
