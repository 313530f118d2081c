// What bloom is measured against.
#include "game/study/bloom_reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rambla::game::study {
namespace {

Picture picture(std::uint32_t width, std::uint32_t height, glm::vec3 light) {
    return {.width = width,
            .height = height,
            .texels = std::vector<glm::vec3>(std::size_t{width} * height, light)};
}

TEST(BloomReference, LeavesFlatLightAsItIs) {
    const Picture flat = picture(37, 11, {3.0f, 2.0f, 1.0f});
    const Picture spread = spread_exactly(flat);
    for (const glm::vec3& texel : spread.texels)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(texel[c], flat.texels[0][c], 1e-6f);
}

TEST(BloomReference, SpreadsAPointByTheMeanOfFourGaussians) {
    Picture point = picture(81, 61, glm::vec3{0.0f});
    point.at(50, 20) = glm::vec3{1000.0f};
    const Picture spread = spread_exactly(point);
    for (const glm::uvec2 at : {glm::uvec2{50, 20}, {10, 60}, {80, 0}}) {
        double expected = 0.0;
        for (const double sigma : {24.0, 48.0, 96.0, 192.0}) {
            const auto share = [&](double place, double from, int size) {
                double all = 0.0;
                for (int i = 0; i < size; ++i)
                    all += std::exp(-0.5 * (place - i) * (place - i) / (sigma * sigma));
                return std::exp(-0.5 * (place - from) * (place - from) / (sigma * sigma)) / all;
            };
            expected += 250.0 * share(at.x, 50.0, 81) * share(at.y, 20.0, 61);
        }
        EXPECT_NEAR(spread.at(at.x, at.y).x, expected, 1e-6 * expected);
    }
}

TEST(BloomReference, GlowsAboveTheThresholdAndSoftlyAboutIt) {
    const render::BloomParameters bloom{.threshold = 2.0f, .knee = 0.25f};
    for (const auto& [light, expected] : {std::pair{1.5f, 0.0}, {2.0f, 0.125}, {2.5f, 0.5}, {10.0f, 8.0}}) {
        const Picture glowing = glowing_part(picture(1, 1, glm::vec3{light}), bloom);
        EXPECT_NEAR(glowing.texels[0].y, expected, 1e-5) << light;
    }
}

TEST(BloomReference, MeasuresWhatIsDifferent) {
    const Picture one = picture(4, 2, glm::vec3{1.0f}), half = scaled(one, 0.5f);
    EXPECT_DOUBLE_EQ(energy(one), 24.0);
    EXPECT_DOUBLE_EQ(energy(sum_of(one, half)), 36.0);
    EXPECT_DOUBLE_EQ(change(half, one), 12.0);
    EXPECT_DOUBLE_EQ(relative_rms_pct(one, half), 50.0);
    EXPECT_DOUBLE_EQ(relative_rms_pct(one, one), 0.0);
}

}  // namespace
}  // namespace rambla::game::study
