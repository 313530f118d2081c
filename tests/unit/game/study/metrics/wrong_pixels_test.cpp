#include "game/study/metrics/wrong_pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

constexpr glm::uvec2 k_size{20, 10};

std::size_t pixel(std::uint32_t x, std::uint32_t y) {
    return std::size_t{y} * k_size.x + x;
}

/// Shadowed left of x = 10, lit from there on: edge pixels are those of the columns 9 and 10.
std::vector<float> half_lit() {
    std::vector<float> values(200, 0.0f);
    for (std::uint32_t y = 0; y < k_size.y; ++y)
        for (std::uint32_t x = 10; x < k_size.x; ++x)
            values[pixel(x, y)] = 1.0f;
    return values;
}

TEST(WrongPixels, AreNoneInEqualImages) {
    const WrongPixels wrong = wrong_pixels(k_size, half_lit(), half_lit());
    EXPECT_EQ(wrong.wrong_pixels_pct, 0.0);
    EXPECT_EQ(wrong.wrong_beyond_edge_pct, 0.0);
}

TEST(WrongPixels, OneOfTwoHundredIsHalfAPercent) {
    std::vector<float> test = half_lit();
    test[pixel(2, 5)] = 1.0f;
    const WrongPixels wrong = wrong_pixels(k_size, half_lit(), test);
    EXPECT_DOUBLE_EQ(wrong.wrong_pixels_pct, 0.5);
    EXPECT_DOUBLE_EQ(wrong.wrong_beyond_edge_pct, 0.5);
}

TEST(WrongPixels, BelongToTheEdgeUpToTheGivenDistance) {
    std::vector<float> test = half_lit();
    test[pixel(9, 3)] = 1.0f;   // on the edge
    test[pixel(11, 3)] = 0.0f;  // 1 from it
    test[pixel(13, 3)] = 0.0f;  // 3
    test[pixel(5, 3)] = 1.0f;   // 4
    const auto beyond = [&](double edge_px) {
        return wrong_pixels(k_size, half_lit(), test, {.edge_px = edge_px}).wrong_beyond_edge_pct;
    };
    EXPECT_DOUBLE_EQ(beyond(0.0), 1.5);
    EXPECT_DOUBLE_EQ(beyond(0.99), 1.5);
    EXPECT_DOUBLE_EQ(beyond(1.0), 1.0);
    EXPECT_DOUBLE_EQ(beyond(2.99), 1.0);
    EXPECT_DOUBLE_EQ(beyond(3.0), 0.5);
    EXPECT_DOUBLE_EQ(beyond(4.0), 0.0);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, half_lit(), test).wrong_pixels_pct, 2.0);
}

TEST(WrongPixels, DistanceIsEuclidean) {
    std::vector<std::uint32_t> reference(200, 7);
    reference[pixel(0, 0)] = 8;  // edge pixels: (0,0), (1,0) and (0,1)
    std::vector<std::uint32_t> test = reference;
    test[pixel(4, 4)] = 9;  // from (1,0) and (0,1): √(3² + 4²) = 5
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, reference, test, 5.0).wrong_beyond_edge_pct, 0.0);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, reference, test, 4.99).wrong_beyond_edge_pct, 0.5);
}

TEST(WrongPixels, LieBeyondTheEdgeWhereThereIsNone) {
    const std::vector<float> lit(200, 1.0f);
    std::vector<float> test = lit;
    test[pixel(3, 3)] = 0.0f;
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, lit, test, {.edge_px = 1e9}).wrong_beyond_edge_pct, 0.5);
}

TEST(WrongPixels, EdgesAreThoseOfTheReference) {
    const std::vector<float> dark(200, 0.0f);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, dark, half_lit()).wrong_beyond_edge_pct, 50.0);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, half_lit(), dark).wrong_beyond_edge_pct, 40.0);  // columns 12 to 19
}

TEST(WrongPixels, DifferencesUpToTheToleranceAreNeitherWrongNorEdges) {
    std::vector<float> reference(200, 0.0f);
    reference[pixel(5, 5)] = 0.25f;
    std::vector<float> test = reference;
    test[pixel(6, 5)] = 0.25f;
    test[pixel(7, 5)] = 0.5f;
    const WrongPixels exact = wrong_pixels(k_size, reference, test);
    EXPECT_DOUBLE_EQ(exact.wrong_pixels_pct, 1.0);
    EXPECT_DOUBLE_EQ(exact.wrong_beyond_edge_pct, 0.0);  // (7,5) is 1 from the edge pixel (6,5)
    const WrongPixels tolerant = wrong_pixels(k_size, reference, test, {.tolerance = 0.25});
    EXPECT_DOUBLE_EQ(tolerant.wrong_pixels_pct, 0.5);
    EXPECT_DOUBLE_EQ(tolerant.wrong_beyond_edge_pct, 0.5);  // no edge any more
}

TEST(WrongPixels, NanDiffersFromNumbersAndEqualsItself) {
    std::vector<float> broken(200, 1.0f);
    broken[pixel(3, 3)] = std::numeric_limits<float>::quiet_NaN();
    broken[pixel(9, 3)] = std::numeric_limits<float>::infinity();
    const std::vector<float> lit(200, 1.0f);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, lit, broken, {.tolerance = 5.0}).wrong_pixels_pct, 1.0);
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, broken, broken).wrong_pixels_pct, 0.0);
}

TEST(WrongPixels, LargeIdsAreNotRounded) {
    const std::vector<std::uint32_t> reference(200, 0xfffffffeu);
    std::vector<std::uint32_t> test = reference;
    test[0] = 0xffffffffu;  // equal as floats
    EXPECT_DOUBLE_EQ(wrong_pixels(k_size, reference, test).wrong_pixels_pct, 0.5);
}

TEST(WrongPixels, RefuseValuesThatDoNotFillTheSize) {
    const std::vector<float> values(199, 0.0f);
    try {
        static_cast<void>(wrong_pixels(k_size, half_lit(), values));
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("199"), testing::HasSubstr("20x10")));
    }
}

TEST(WrongPixels, OfOneAndOfNoPixel) {
    EXPECT_EQ(wrong_pixels({0, 0}, std::vector<float>{}, std::vector<float>{}).wrong_pixels_pct, 0.0);
    const WrongPixels one = wrong_pixels({1, 1}, std::vector<float>{1.0f}, std::vector<float>{0.0f});
    EXPECT_EQ(one.wrong_pixels_pct, 100.0);
    EXPECT_EQ(one.wrong_beyond_edge_pct, 100.0);
}

TEST(WrongPixels, OfPicturesDifferInAnyChannel) {
    const Picture reference = filled(10, 10, glm::vec3{0.5f});
    EXPECT_EQ(wrong_pixels_pct(reference, reference, 0.0), 0.0);
    const Picture test = with(with(reference, 2, 2, {0.5f, 0.75f, 0.5f}), 4, 4, {0.5f, 0.5f, 1.0f});
    EXPECT_DOUBLE_EQ(wrong_pixels_pct(reference, test, 0.0), 2.0);
    EXPECT_DOUBLE_EQ(wrong_pixels_pct(reference, test, 0.25), 1.0);
    const Picture broken = with(reference, 2, 2, glm::vec3{std::numeric_limits<float>::quiet_NaN()});
    EXPECT_DOUBLE_EQ(wrong_pixels_pct(reference, broken, 1e9), 1.0);
    EXPECT_THROW(static_cast<void>(wrong_pixels_pct(reference, filled(5, 20, k_black), 0.0)),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
