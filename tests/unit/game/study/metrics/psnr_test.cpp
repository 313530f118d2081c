#include "game/study/metrics/psnr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Light that a display shows for an sRGB value above 0.04045.
glm::vec3 light_of(double value) {
    return glm::vec3{static_cast<float>(std::pow((value + 0.055) / 1.055, 2.4))};
}

TEST(Psnr, IsInfiniteOnEqualPictures) {
    const Picture picture = noise(9, 7, 1);
    EXPECT_EQ(psnr_db(picture, picture), k_infinity);
    EXPECT_EQ(psnr_db({}, {}), k_infinity);
}

TEST(Psnr, OfWhiteAgainstBlackIsZero) {
    EXPECT_EQ(psnr_db(filled(3, 2, k_white), filled(3, 2, k_black)), 0.0);
}

TEST(Psnr, OfAnEvenDifferenceOfDisplayValuesIsItsDecibels) {
    // 20·log10(1 / 0.1). Encoding in single precision errs by 1e-7 of 0.1: 20 / ln 10 · 1e-6 dB.
    EXPECT_NEAR(psnr_db(filled(3, 2, light_of(0.5)), filled(3, 2, light_of(0.6))), 20.0, 1e-4);
    EXPECT_NEAR(psnr_db(filled(3, 2, light_of(0.5)), filled(3, 2, light_of(0.51))), 40.0, 1e-3);
}

TEST(Psnr, OfTheLinearPartOfTheCurve) {
    // 12.92 · 0.002 = 0.02584.
    EXPECT_NEAR(psnr_db(filled(3, 2, k_black), filled(3, 2, glm::vec3{0.002f})), -20.0 * std::log10(0.02584),
                1e-4);
}

TEST(Psnr, SeesOneChangedChannelOfOnePixel) {
    const Picture reference = filled(10, 10, k_black);
    // One of 300 values differs by 1.
    EXPECT_NEAR(psnr_db(reference, with(reference, 4, 4, {0.0f, 1.0f, 0.0f})), 10.0 * std::log10(300.0),
                1e-9);
}

TEST(Psnr, IsSymmetric) {
    EXPECT_EQ(psnr_db(noise(9, 7, 1), noise(9, 7, 2)), psnr_db(noise(9, 7, 2), noise(9, 7, 1)));
}

TEST(Psnr, FallsAsTheDifferenceGrows) {
    double last = k_infinity;
    for (const float light : {0.501f, 0.51f, 0.6f, 0.9f}) {
        const double psnr = psnr_db(filled(2, 2, glm::vec3{0.5f}), filled(2, 2, glm::vec3{light}));
        EXPECT_LT(psnr, last);
        last = psnr;
    }
}

TEST(Psnr, ClampsToTheDisplay) {
    EXPECT_EQ(psnr_db(filled(2, 2, k_white), filled(2, 2, glm::vec3{9.0f})), k_infinity);
}

TEST(Psnr, ATexelThatIsNotFiniteIsAsWrongAsCanBe) {
    const Picture reference = filled(10, 10, k_black);
    const Picture broken = with(reference, 1, 1, glm::vec3{std::numeric_limits<float>::quiet_NaN()});
    EXPECT_NEAR(psnr_db(reference, broken), 20.0, 1e-9);  // 1 of 100
    EXPECT_EQ(psnr_db(broken, broken), k_infinity);
}

TEST(Psnr, RefusesPicturesOfUnequalSize) {
    EXPECT_THROW(static_cast<void>(psnr_db(filled(2, 3, k_black), filled(3, 2, k_black))),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
