#include "game/study/crop.h"

#include <gtest/gtest.h>

#include <vector>

namespace rambla::game::study {
namespace {

TEST(HeaviestCrop, HoldsWhereTheMapIsHeaviest) {
    std::vector<float> map(std::size_t{20} * 10, 0.0f);
    map[7 * 20 + 15] = 3.0f;
    map[6 * 20 + 14] = 2.0f;
    map[1 * 20 + 2] = 4.0f;
    const Crop crop = heaviest_crop({20, 10}, map, {4, 3});
    EXPECT_LE(crop.corner_px.x, 14u);
    EXPECT_GT(crop.corner_px.x + crop.size_px.x, 15u);
    EXPECT_LE(crop.corner_px.y, 6u);
    EXPECT_GT(crop.corner_px.y + crop.size_px.y, 7u);
    EXPECT_EQ(crop.size_px, (glm::uvec2{4, 3}));
}

TEST(HeaviestCrop, OfAFlatMapIsTheFirstAndOfASmallPictureAllOfIt) {
    EXPECT_EQ(heaviest_crop({9, 9}, std::vector<float>(81, 0.0f), {4, 4}).corner_px, (glm::uvec2{0, 0}));
    const Crop all = heaviest_crop({3, 9}, std::vector<float>(27, 1.0f), {4, 4});
    EXPECT_EQ(all.size_px, (glm::uvec2{3, 4}));
}

TEST(Enlarged, RepeatsEachPixelOfTheCrop) {
    assets::Image image;
    image.width = 4;
    image.height = 3;
    for (int i = 0; i < 4 * 4 * 3; ++i)
        image.texels.push_back(static_cast<std::byte>(i));
    const assets::Image large = enlarged(image, {.corner_px = {1, 1}, .size_px = {2, 2}}, 3);
    EXPECT_EQ(large.width, 6u);
    EXPECT_EQ(large.height, 6u);
    for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t x = 0; x < 6; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel)
                EXPECT_EQ(large.texels[4 * (6 * y + x) + channel],
                          image.texels[4 * (4 * (1 + y / 3) + 1 + x / 3) + channel]);
}

}  // namespace
}  // namespace rambla::game::study
