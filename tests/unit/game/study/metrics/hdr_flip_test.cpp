#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "game/study/metrics/flip.h"
#include "unit/game/study/metrics/flip_by_definition.h"
#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

/// Noise over sixteen stops.
Picture wide_noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    Picture picture = noise(width, height, seed);
    for (glm::vec3& texel : picture.texels)
        texel = glm::exp2(16.0f * texel - 4.0f);
    return picture;
}

/// Three pixels of luminance `most` and one that is `ratio` times as bright.
Picture with_lamp(float most, float ratio) {
    return with(filled(2, 2, glm::vec3{most}), 1, 0, glm::vec3{most * ratio});
}

/// What Narkowicz' curve makes of a light at an exposure.
double shown(double light, double ev) {
    const double x = light * std::exp2(ev);
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

TEST(HdrFlip, ExposuresShowTheLargestLuminanceAndTheMedianAt85Percent) {
    const FlipExposures exposures = flip_exposures(with_lamp(0.25f, 40.0f));
    EXPECT_NEAR(shown(10.0, exposures.start_ev), 0.85, 1e-6);  // luminance weights sum to 1 but for rounding
    EXPECT_NEAR(shown(0.25, exposures.stop_ev), 0.85, 1e-6);
    EXPECT_EQ(exposures.count, 6u);  // ⌈log2 40⌉ = ⌈5.3⌉
    EXPECT_EQ(exposures.ev(0), exposures.start_ev);
    EXPECT_EQ(exposures.ev(5), exposures.stop_ev);
    EXPECT_NEAR(exposures.ev(1) - exposures.ev(0), std::log2(40.0) / 5.0, 1e-12);  // rounding of doubles
}

TEST(HdrFlip, ThereAreTwoExposuresAtLeast) {
    EXPECT_EQ(flip_exposures(filled(3, 3, glm::vec3{5.0f})).count, 2u);
    EXPECT_EQ(flip_exposures(with_lamp(1.0f, 3.9f)).count, 2u);
    EXPECT_EQ(flip_exposures(with_lamp(1.0f, 4.1f)).count, 3u);
    EXPECT_EQ(flip_exposures(with_lamp(1.0f, 8.0f)).count, 3u);
}

TEST(HdrFlip, ExposuresOfABlackPictureWithALampEnd) {
    const FlipExposures exposures = flip_exposures(with(filled(3, 3, k_black), 1, 1, k_white));
    EXPECT_EQ(exposures.count, 23u);
    EXPECT_TRUE(std::isfinite(exposures.stop_ev));
}

TEST(HdrFlip, ThereAreExposuresOfABlackPicture) {
    EXPECT_EQ(flip_exposures(filled(3, 3, k_black)), FlipExposures{});
    EXPECT_EQ(flip_exposures({}), FlipExposures{});
}

TEST(HdrFlip, ExposuresLeaveOutWhatIsNotFinite) {
    Picture picture = with_lamp(1.0f, 8.0f);
    const FlipExposures expected = flip_exposures(with(picture, 0, 0, glm::vec3{1.0f}));
    picture.width = 3;  // two more texels: the median of those left stays
    picture.texels.push_back(glm::vec3{std::numeric_limits<float>::infinity()});
    picture.texels.push_back(glm::vec3{std::numeric_limits<float>::quiet_NaN()});
    EXPECT_EQ(flip_exposures(picture), expected);
}

TEST(HdrFlip, IsZeroOnEqualPictures) {
    const Picture picture = wide_noise(20, 15, 1);
    EXPECT_THAT(hdr_flip(picture, picture).map, testing::Each(0.0f));
}

TEST(HdrFlip, IsTheLargestOfTheDefinitionOverAllExposures) {
    const Picture reference = wide_noise(11, 8, 1);
    const Picture test = wide_noise(11, 8, 2);
    const FlipExposures exposures = flip_exposures(reference);
    ASSERT_GE(exposures.count, 4u);
    std::vector<double> expected(reference.texels.size(), 0.0);
    for (std::uint32_t i = 0; i < exposures.count; ++i) {
        const double ev =
            exposures.start_ev + (exposures.stop_ev - exposures.start_ev) * i / (exposures.count - 1.0);
        const std::vector<double> map = by_definition::ldr_flip(by_definition::tone_mapped(reference, ev),
                                                                by_definition::tone_mapped(test, ev), 30.0);
        for (std::size_t k = 0; k < map.size(); ++k)
            expected[k] = std::max(expected[k], map[k]);
    }
    const Flip flip = hdr_flip(reference, test, 30.0);
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(double{flip.map[k]}, expected[k], 1.5e-4) << k;  // k_tolerance of flip_test.cpp
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfLight) {
    const Picture reference = wide_noise(30, 20, 1);
    const Picture test = wide_noise(30, 20, 2);
    const Flip flip = hdr_flip(reference, test);
    EXPECT_GT(flip.mean, 0.1);
    for (const int k : {-40, -7, 1, 12, 60}) {
        const float factor = std::ldexp(1.0f, k);
        const Flip other = hdr_flip(scaled(reference, factor), scaled(test, factor));
        for (std::size_t i = 0; i < flip.map.size(); ++i)
            // Exposures round in double; what is shown then differs by 6e-8, a float's last digit, at times,
            // of which the feature term makes √(6e-8 / √2) = 2e-4 in an exponent, at most 1/e of it in the
            // map.
            EXPECT_NEAR(other.map[i], flip.map[i], 1e-4f) << i << " at " << k;
    }
}

TEST(HdrFlip, SeesAHighlightAboveDisplayWhiteThatLdrFlipDoesNot) {
    const Picture reference = with(filled(40, 40, glm::vec3{0.5f}), 20, 20, glm::vec3{2.0f});
    const Picture test = with(reference, 20, 20, glm::vec3{16.0f});
    EXPECT_EQ(ldr_flip(reference, test).mean, 0.0);
    EXPECT_GT(hdr_flip(reference, test).map[20 * 40 + 20], 0.02f);
}

TEST(HdrFlip, SeesADifferenceInTheShadowsOfABrightPicture) {
    Picture reference = filled(40, 20, glm::vec3{0.001f});
    for (std::uint32_t x = 0; x < 15; ++x)
        for (std::uint32_t y = 0; y < 20; ++y)
            reference.at(x, y) = glm::vec3{100.0f};
    Picture test = reference;
    for (std::uint32_t y = 0; y < 20; ++y)
        test.at(39, y) = glm::vec3{0.002f};
    EXPECT_GT(hdr_flip(reference, test).map[39], 5.0f * ldr_flip(reference, test).map[39]);
}

TEST(HdrFlip, SeesOneChangedPixel) {
    const Picture reference = wide_noise(30, 20, 1);
    EXPECT_GT(hdr_flip(reference, with(reference, 8, 9, k_black)).map[9 * 30 + 8], 0.01f);
}

TEST(HdrFlip, TakesExposuresOfTheTestWhenTheReferenceIsBlack) {
    const Picture black = filled(30, 30, k_black);
    EXPECT_EQ(hdr_flip(black, black).mean, 0.0);
    for (const float light : {1e-12f, 1.0f, 1e12f})
        EXPECT_GT(hdr_flip(black, with(black, 9, 9, glm::vec3{light})).map[9 * 30 + 9], 0.2f) << light;
}

TEST(HdrFlip, IsNotSymmetricForItsExposuresAreTheReferences) {
    const Picture dim = filled(30, 30, glm::vec3{0.5f});
    const Picture bright = with(dim, 9, 9, glm::vec3{1000.0f});
    EXPECT_GT(std::abs(hdr_flip(dim, bright).mean - hdr_flip(bright, dim).mean), 1e-4);
}

TEST(HdrFlip, StandsTheLargestAndSmallestFloats) {
    const Picture largest = filled(5, 5, glm::vec3{std::numeric_limits<float>::max()});
    const Picture smallest = filled(5, 5, glm::vec3{std::numeric_limits<float>::denorm_min()});
    for (const Flip& flip : {hdr_flip(largest, smallest), hdr_flip(smallest, largest),
                             hdr_flip(scaled(largest, -1.0f), largest)}) {
        EXPECT_GT(flip.mean, 0.2);  // 0.85 against 1 for the smallest: the largest is white
        EXPECT_LE(flip.mean, 1.0);
    }
}

TEST(HdrFlip, OfASinglePixelIsTheColourDifferenceOfWhatIsShown) {
    const double ev = flip_exposures(filled(1, 1, glm::vec3{4.0f})).start_ev;
    EXPECT_NEAR(hdr_flip(filled(1, 1, glm::vec3{4.0f}), filled(1, 1, glm::vec3{1.0f})).mean,
                by_definition::colour_difference(glm::dvec3{shown(4.0, ev)}, glm::dvec3{shown(1.0, ev)}),
                3e-5);  // k_flat_tolerance of flip_test.cpp
}

}  // namespace
}  // namespace rambla::game::study
