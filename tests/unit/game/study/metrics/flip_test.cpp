#include "game/study/metrics/flip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <stdexcept>

#include "unit/game/study/metrics/flip_by_definition.h"
#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

using testing::Each;
using testing::HasSubstr;

// Single precision against double. What enlarges rounding errors of 1e-7 is the 0.7th power of a colour
// difference near 0, where those of L*a*b* (of about 1e-5, in units of 100) become 0.95 / 16.5 · 1e-5^0.7 =
// 2e-5.
constexpr double k_flat_tolerance = 3e-5;
// On top of it the feature term takes the square root: √(1e-7 / √2) = 3e-4 in an exponent, of which a power
// of d makes −d ln d, at most 1/e: 1e-4.
constexpr double k_tolerance = 1.5e-4;

constexpr glm::vec3 k_red{1.0f, 0.0f, 0.0f};
constexpr glm::vec3 k_green{0.0f, 1.0f, 0.0f};
constexpr glm::vec3 k_blue{0.0f, 0.0f, 1.0f};

double flip_of_colours(glm::vec3 a, glm::vec3 b) {
    return ldr_flip(filled(8, 5, a), filled(8, 5, b)).mean;
}

TEST(Flip, ScreenOfThePaperHas67PixelsPerDegree) {
    EXPECT_NEAR(k_flip_pixels_per_degree, 67.0206, 1e-4);  // 3840 π / 180
    EXPECT_NEAR(pixels_per_degree(1.4, 0.7, 3840.0), 2.0 * k_flip_pixels_per_degree, 1e-9);
}

TEST(Flip, IsZeroOnEqualPictures) {
    const Picture picture = noise(40, 30, 1);
    const Flip flip = ldr_flip(picture, picture);
    EXPECT_EQ(flip.width, 40u);
    EXPECT_EQ(flip.height, 30u);
    EXPECT_EQ(flip.map.size(), 1200u);
    EXPECT_THAT(flip.map, Each(0.0f));
    EXPECT_EQ(flip.mean, 0.0);
}

TEST(Flip, IsSymmetricToTheLastBit) {
    const Picture a = noise(50, 30, 1);
    const Picture b = noise(50, 30, 2);
    const Flip forward = ldr_flip(a, b);
    EXPECT_GT(forward.mean, 0.1);
    EXPECT_EQ(forward.map, ldr_flip(b, a).map);
}

TEST(Flip, OfPlainColoursIsTheirColourDifference) {
    // Kernels of weight 1 leave a plain picture as it is and features are 0.
    const std::vector<std::pair<glm::vec3, glm::vec3>> pairs{
        {k_white, k_black}, {k_red, k_green},
        {k_red, k_blue},    {k_blue, k_white},
        {k_black, k_blue},  {glm::vec3{0.5f}, glm::vec3{0.25f}},
        {k_red, k_black},   {glm::vec3{0.2f, 0.5f, 0.1f}, glm::vec3{0.21f, 0.5f, 0.1f}}};
    for (const auto& [a, b] : pairs)
        EXPECT_NEAR(flip_of_colours(a, b), by_definition::colour_difference(a, b), k_flat_tolerance)
            << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Flip, OfGreenAgainstBlueIsOne) {
    EXPECT_NEAR(flip_of_colours(k_green, k_blue), 1.0, 1e-6);  // the largest there is, by construction
}

TEST(Flip, OfWhiteAgainstBlackIsAlmostOne) {
    // By hand: HyAB is 100 and the largest 203.4, from L*a*b* of green (87.7, −86.2, 83.2) and blue
    // (32.3, 79.2, −107.9): 55.4 + |(−75.6 − 25.6, 73.0 + 34.8)| = 55.4 + 147.9. With its 0.7th power, (100 /
    // 203.3)^0.7 = 0.6084, the upper branch gives 0.95 + 0.05 · (0.6084 − 0.4) / 0.6. Hand figures of three
    // digits: 1e-4.
    EXPECT_NEAR(flip_of_colours(k_white, k_black), 0.95 + 0.05 * 0.2084 / 0.6, 1e-4);
}

TEST(Flip, FollowsTheDefinitionPixelByPixel) {
    // Noise has every frequency and direction; borders are most of a picture this small.
    for (const double ppd : {67.0206, 20.0, 9.0}) {
        const Picture a = noise(17, 12, 3);
        const Picture b = noise(17, 12, 4);
        const Flip flip = ldr_flip(a, b, ppd);
        const std::vector<double> expected = by_definition::ldr_flip(a, b, ppd);
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(double{flip.map[i]}, expected[i], k_tolerance) << i << " at " << ppd;
        EXPECT_NEAR(
            flip.mean,
            std::accumulate(flip.map.begin(), flip.map.end(), 0.0) / static_cast<double>(flip.map.size()),
            1e-12);  // sums of 204 doubles
    }
}

/// Values of an edge between 0.1 and 0.7 in the middle of a row, continued on both sides.
double edge_light(int x, int width) {
    return double{x < width / 2 ? 0.1f : 0.7f};
}

/// Σ weight(i) · light(x + i) / norm.
template <class Weight>
double along_row(int x, int width, int radius, Weight weight) {
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i)
        sum += weight(i) * edge_light(x + i, width);
    return sum;
}

TEST(Flip, OfAnEdgeAgainstNoneFollowsFromOneDimension) {
    // Where the blurred edge fades out, colours differ by their rounding, 3e-5, and the feature term makes
    // (3e-5)^(1 − 1/4) of it.
    constexpr double k_tail_tolerance = 4e-4;
    constexpr int width = 48;
    constexpr double ppd = 67.0206;
    Picture edge = filled(width, 3, glm::vec3{0.1f});
    for (std::uint32_t y = 0; y < 3; ++y)
        for (std::uint32_t x = width / 2; x < width; ++x)
            edge.at(x, y) = glm::vec3{0.7f};
    const Flip flip = ldr_flip(edge, filled(width, 3, glm::vec3{0.1f}), ppd);

    const auto blur = [&](int i) {
        return std::exp(-9.8696044 * i * i / (ppd * ppd * 0.0047));
    };
    const double deviation = 0.041 * ppd;  // half of 0.082°
    const auto gaussian = [&](int i) {
        return std::exp(-0.5 * i * i / (deviation * deviation));
    };
    const auto first = [&](int i) {
        return i * gaussian(i);
    };
    const auto second = [&](int i) {
        return (i * i / (deviation * deviation) - 1.0) * gaussian(i);
    };
    double blur_sum = 0.0, first_sum = 0.0, second_positive = 0.0, second_negative = 0.0;
    for (int i = -10; i <= 10; ++i)  // ⌈3 · √(0.04 / 2π²) · 67.02⌉
        blur_sum += blur(i);
    for (int i = -9; i <= 9; ++i) {  // ⌈3 · 2.748⌉
        first_sum += std::max(first(i), 0.0);
        second_positive += std::max(second(i), 0.0);
        second_negative += std::max(-second(i), 0.0);
    }
    for (int x = 0; x < width; ++x) {
        const double light = along_row(x, width, 10, blur) / blur_sum;
        const double edges = along_row(x, width, 9, first) / first_sum;
        const double points = along_row(x, width, 9, [&](int i) {
            return second(i) / (second(i) > 0.0 ? second_positive : second_negative);
        });
        const double expected = by_definition::with_features(
            by_definition::colour_difference(glm::dvec3{light}, glm::dvec3{double{0.1f}}), edges, points);
        for (std::uint32_t y = 0; y < 3; ++y)
            EXPECT_NEAR(double{flip.map[y * width + static_cast<std::size_t>(x)]}, expected, k_tail_tolerance)
                << x;
    }
}

TEST(Flip, SeesAnEdgeMoreThanTheSameDifferenceWithoutOne) {
    const Picture flat = filled(40, 9, glm::vec3{0.3f});
    Picture edge = flat;
    for (std::uint32_t y = 0; y < 9; ++y)
        for (std::uint32_t x = 20; x < 40; ++x)
            edge.at(x, y) = glm::vec3{0.4f};
    const Flip flip = ldr_flip(flat, edge);
    // Far from the edge the colour difference alone; right of it the blur takes some of that away, but more
    // comes.
    EXPECT_NEAR(double{flip.map[4 * 40 + 39]},
                by_definition::colour_difference(glm::dvec3{double{0.3f}}, glm::dvec3{double{0.4f}}),
                k_flat_tolerance);
    EXPECT_GT(flip.map[4 * 40 + 20], 1.2f * flip.map[4 * 40 + 39]);
}

TEST(Flip, GrowsWithTheDifference) {
    double last = 0.0;
    for (const float shift : {0.001f, 0.01f, 0.05f, 0.1f, 0.2f, 0.5f}) {
        const double flip = flip_of_colours(glm::vec3{0.4f}, glm::vec3{0.4f + shift, 0.4f, 0.4f});
        EXPECT_GT(flip, last) << shift;
        last = flip;
    }
}

TEST(Flip, SeesOneChangedPixelAndItsSurroundingsOnly) {
    const Picture reference = filled(60, 50, glm::vec3{0.5f});
    const Flip flip = ldr_flip(reference, with(reference, 30, 25, k_white));
    EXPECT_GT(flip.map[25 * 60 + 30], 0.2f);
    EXPECT_GT(flip.mean, 0.0);
    EXPECT_EQ(flip.map[25 * 60 + 30 + 11], 0.0f);  // the widest kernel reaches 10 pixels
    EXPECT_EQ(flip.map[(25 - 11) * 60 + 30], 0.0f);
    EXPECT_GT(flip.map[25 * 60 + 30 + 5], 0.0f);
}

TEST(Flip, SeesLessFromFartherAway) {
    // A checkerboard is a plain grey for eyes that cannot resolve it. Its light has the same mean.
    Picture board = filled(64, 64, k_black);
    for (std::uint32_t i = 0; i < 64 * 64; ++i)
        board.texels[i] = glm::vec3{(i + i / 64) % 2 == 0 ? 0.4f : 0.6f};
    const Picture grey = filled(64, 64, glm::vec3{0.5f});
    const double near = ldr_flip(grey, board, 5.0).mean;
    const double middle = ldr_flip(grey, board, 20.0).mean;
    const double far = ldr_flip(grey, board, 67.0).mean;
    EXPECT_GT(near, middle);
    EXPECT_GT(middle, far);
    EXPECT_LT(far, 0.02);
}

TEST(Flip, ClampsToWhatADisplayShows) {
    EXPECT_EQ(flip_of_colours(glm::vec3{1.0f}, glm::vec3{7.0f}), 0.0);
    EXPECT_EQ(flip_of_colours(glm::vec3{0.0f}, glm::vec3{-3.0f}), 0.0);
}

TEST(Flip, ATexelThatIsNotFiniteIsAsWrongAsCanBe) {
    const Picture reference = filled(30, 30, k_black);
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), k_infinity, -k_infinity}) {
        const Picture broken = with(reference, 3, 4, {0.0f, bad, 0.0f});
        // Black in its place, so that nothing spreads.
        for (const Flip& flip : {ldr_flip(reference, broken), ldr_flip(broken, reference),
                                 hdr_flip(reference, broken), hdr_flip(broken, reference)}) {
            EXPECT_EQ(flip.map[4 * 30 + 3], 1.0f);
            EXPECT_DOUBLE_EQ(flip.mean, 1.0 / 900.0);
        }
        EXPECT_EQ(ldr_flip(broken, broken).mean, 0.0);
        EXPECT_EQ(hdr_flip(broken, broken).mean, 0.0);
    }
}

TEST(Flip, OfASinglePixelIsItsColourDifference) {
    EXPECT_NEAR(ldr_flip(filled(1, 1, k_red), filled(1, 1, k_green)).mean,
                by_definition::colour_difference(k_red, k_green), k_flat_tolerance);
}

TEST(Flip, OfNothingIsZero) {
    EXPECT_EQ(ldr_flip({}, {}).mean, 0.0);
    EXPECT_EQ(hdr_flip({}, {}).mean, 0.0);
    EXPECT_TRUE(ldr_flip({}, {}).map.empty());
}

std::string refusal(const Picture& a, const Picture& b, double ppd) {
    try {
        static_cast<void>(ldr_flip(a, b, ppd));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Flip, RefusesPicturesOfUnequalSizeAndNamesBoth) {
    const std::string text = refusal(filled(4, 3, k_black), filled(3, 4, k_black), 67.0);
    EXPECT_THAT(text, HasSubstr("4x3"));
    EXPECT_THAT(text, HasSubstr("3x4"));
    EXPECT_THROW(static_cast<void>(hdr_flip(filled(4, 3, k_black), filled(3, 4, k_black))),
                 std::invalid_argument);
}

TEST(Flip, RefusesAPictureWithoutItsTexels) {
    Picture torn = filled(4, 3, k_black);
    torn.texels.pop_back();
    EXPECT_THAT(refusal(torn, torn, 67.0), HasSubstr("4x3 has 11 texels"));
}

TEST(Flip, RefusesDistancesBeyondItsRange) {
    const Picture picture = noise(4, 4, 1);
    for (const double ppd : {0.0, -67.0, 0.5, 1e5, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THAT(refusal(picture, picture, ppd), HasSubstr("pixels per degree")) << ppd;
}

TEST(Flip, IsFiniteAtBothEndsOfItsRange) {
    for (const double ppd : {1.0, 10'000.0}) {
        const Flip flip = ldr_flip(noise(4, 3, 1), noise(4, 3, 2), ppd);
        EXPECT_GT(flip.mean, 0.0) << ppd;
        EXPECT_LE(flip.mean, 1.0) << ppd;
    }
}

}  // namespace
}  // namespace rambla::game::study
