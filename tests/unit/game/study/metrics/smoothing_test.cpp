#include "game/study/metrics/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "unit/game/study/metrics/pictures.h"

namespace rambla::game::study {
namespace {

using Mask = std::vector<std::uint8_t>;

constexpr std::uint32_t k_size = 16;
const Mask k_everywhere(std::size_t{k_size} * k_size, 1);
const Mask k_nowhere(std::size_t{k_size} * k_size, 0);

/// White from a column on, black before it; the column itself shows so much white, as display light.
Picture edge_at(std::uint32_t column, float share = 1.0f) {
    Picture picture = filled(k_size, k_size, k_black);
    for (std::uint32_t y = 0; y < k_size; ++y)
        for (std::uint32_t x = column; x < k_size; ++x)
            picture.at(x, y) = x == column ? glm::vec3{share} : k_white;
    return picture;
}

/// Where edge_at() changes.
Mask edge_mask(std::uint32_t column) {
    Mask mask = k_nowhere;
    for (std::uint32_t y = 0; y < k_size; ++y)
        mask[y * k_size + column] = mask[y * k_size + column - 1] = 1;
    return mask;
}

/// Mean of 3×3 pixels; the picture goes on beyond its border with its outermost texels.
Picture blurred(const Picture& picture) {
    Picture result = picture;
    const auto at = [&](int x, int y) {
        return picture.at(static_cast<std::uint32_t>(std::clamp(x, 0, static_cast<int>(picture.width) - 1)),
                          static_cast<std::uint32_t>(std::clamp(y, 0, static_cast<int>(picture.height) - 1)));
    };
    for (int y = 0; y < static_cast<int>(picture.height); ++y) {
        for (int x = 0; x < static_cast<int>(picture.width); ++x) {
            glm::vec3 sum{0.0f};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    sum += at(x + dx, y + dy);
            result.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) = sum / 9.0f;
        }
    }
    return result;
}

TEST(PixelRegions, AreWithinAndBeyondTheirDistancesAndLeaveTheRestOut) {
    Mask edges = k_nowhere;
    edges[8 * k_size + 5] = 1;
    const PixelRegions regions = pixel_regions({k_size, k_size}, edges, 1.5, 3.0);
    for (std::uint32_t y = 0; y < k_size; ++y) {
        for (std::uint32_t x = 0; x < k_size; ++x) {
            const double distance = std::hypot(x - 5.0, y - 8.0);
            EXPECT_EQ(regions.edges[y * k_size + x], distance <= 1.5 ? 1 : 0) << x << " " << y;
            EXPECT_EQ(regions.textures[y * k_size + x], distance > 3.0 ? 1 : 0) << x << " " << y;
        }
    }
    EXPECT_EQ(std::count(regions.edges.begin(), regions.edges.end(), 1), 9);
}

TEST(PixelRegions, WithoutEdgesAreTexturesAlone) {
    const PixelRegions regions = pixel_regions({k_size, k_size}, k_nowhere, 1.5, 3.0);
    EXPECT_EQ(regions.edges, k_nowhere);
    EXPECT_EQ(regions.textures, k_everywhere);
}

TEST(RmsDisplay, OfEqualPicturesIsZero) {
    const Picture any = noise(k_size, k_size, 3);
    EXPECT_EQ(rms_display(any, any, k_everywhere), 0.0);
    EXPECT_EQ(rms_display(any, filled(k_size, k_size, k_black), k_nowhere), 0.0) << "of nothing";
}

TEST(RmsDisplay, IsOfCodesNotOfLight) {
    // 0.2140411 is the light of code 0.5.
    EXPECT_NEAR(rms_display(filled(k_size, k_size, k_black), filled(k_size, k_size, glm::vec3{0.2140411f}),
                            k_everywhere),
                0.5, 1e-6);
    EXPECT_NEAR(rms_display(filled(k_size, k_size, k_black), filled(k_size, k_size, {0.2140411f, 0.0f, 0.0f}),
                            k_everywhere),
                0.5 / std::sqrt(3.0), 1e-6);
}

TEST(RmsDisplay, OfAShiftedEdgeIsOfThePixelsItPassed) {
    const Picture reference = edge_at(8);
    const Mask edges = edge_mask(8);  // two columns, of which a shift by one pixel makes one wrong
    EXPECT_NEAR(rms_display(reference, edge_at(7), edges), std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(rms_display(reference, edge_at(7), k_everywhere), std::sqrt(1.0 / k_size), 1e-6);
    // Half way, as code 0.5, half as wrong.
    EXPECT_NEAR(rms_display(reference, edge_at(7, 0.2140411f), edges), 0.5 * std::sqrt(0.5), 1e-6);
    EXPECT_EQ(rms_display(reference, edge_at(7), edge_mask(3)), 0.0) << "another place";
}

TEST(RmsDisplay, TakesWhatIsNotFiniteForBlack) {
    const Picture hole = with(filled(k_size, k_size, k_white), 4, 4, glm::vec3{std::nanf("")});
    EXPECT_NEAR(rms_display(filled(k_size, k_size, k_white), hole, k_everywhere), 1.0 / k_size, 1e-9);
}

TEST(MeanWithin, IsOfTheRegionAlone) {
    const std::vector<float> map{1.0f, 2.0f, 4.0f, 8.0f};
    EXPECT_EQ(mean_within(map, Mask{0, 1, 1, 0}), 3.0);
    EXPECT_EQ(mean_within(map, Mask{0, 0, 0, 0}), 0.0);
    EXPECT_THROW(static_cast<void>(mean_within(map, Mask{1})), std::invalid_argument);
}

TEST(LocalContrast, OfAFlatPictureIsZero) {
    // Rounding of nine squares of at most 1 in double precision, under a root.
    EXPECT_NEAR(local_contrast(filled(k_size, k_size, {0.3f, 0.6f, 0.1f}), k_everywhere), 0.0, 1e-7);
}

TEST(LocalContrast, OfAnEdgeIsTheDeviationInItsTwoColumns) {
    // Windows about the two columns hold three or six white pixels of nine, of code 1: √(1/3·2/3).
    EXPECT_NEAR(local_contrast(edge_at(8), edge_mask(8)), std::sqrt(2.0) / 3.0, 1e-7);
    EXPECT_NEAR(local_contrast(edge_at(8), edge_mask(3)), 0.0, 1e-7);
}

TEST(LocalContrast, IsLostToBlur) {
    const Picture sharp = noise(k_size, k_size, 7);
    const double before = local_contrast(sharp, k_everywhere);
    const double after = local_contrast(blurred(sharp), k_everywhere);
    // Nine independent pixels' mean deviates by a third; neighbouring means share pixels, hence differ less.
    EXPECT_LT(after, before / 2.0);
    EXPECT_GT(after, before / 9.0);
}

TEST(LocalContrast, DoesNotCountTheRim) {
    Picture picture = filled(k_size, k_size, k_black);
    picture.at(0, 5) = k_white;
    Mask rim = k_nowhere;
    for (std::uint32_t y = 0; y < k_size; ++y)
        rim[y * k_size] = 1;
    EXPECT_EQ(local_contrast(picture, rim), 0.0);
    EXPECT_GT(local_contrast(picture, k_everywhere), 0.0) << "but its neighbours see it";
}

TEST(Smoothing, RefusesRegionsOfOtherSizes) {
    const Picture picture = filled(k_size, k_size, k_black);
    EXPECT_THROW(static_cast<void>(rms_display(picture, picture, Mask(3, 1))), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(local_contrast(picture, Mask(3, 1))), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(rms_display(picture, filled(2, 2, k_black), k_everywhere)),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rambla::game::study
