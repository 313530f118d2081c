#include "game/study/picture_part.h"

#include <gtest/gtest.h>

namespace rambla::game::study {
namespace {

/// Red counts columns, green rows.
assets::Image counted(std::uint32_t width, std::uint32_t height) {
    assets::Image image{.name = {}, .width = width, .height = height, .texels = {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (const std::uint32_t channel : {x, y, 0u, 255u})
                image.texels.push_back(static_cast<std::byte>(channel));
    return image;
}

TEST(PicturePart, IsCutOutAndEndsWhereThePictureDoes) {
    const assets::Image part = part_of(counted(20, 10), {17, 3}, {8, 4});
    EXPECT_EQ(part.width, 3u);
    EXPECT_EQ(part.height, 4u);
    ASSERT_EQ(part.texels.size(), 3u * 4u * 4u);
    EXPECT_EQ(part.texels[0], std::byte{17});
    EXPECT_EQ(part.texels[1], std::byte{3});
    EXPECT_EQ(part.texels[4 * 11], std::byte{19});
    EXPECT_EQ(part.texels[4 * 11 + 1], std::byte{6});
    EXPECT_TRUE(part_of(counted(20, 10), {30, 0}, {8, 4}).texels.empty());
}

TEST(PicturePart, TheMostDifferentOneHoldsTheDifference) {
    const assets::Image a = counted(128, 64);
    assets::Image b = a;
    // A block of 8×8 with its corner at (90, 40): parts of 16×8 that begin at every second column, every row.
    for (std::uint32_t y = 40; y < 48; ++y)
        for (std::uint32_t x = 90; x < 98; ++x)
            b.texels[4 * (y * 128 + x) + 2] = std::byte{200};
    const glm::uvec2 found = most_different_part(a, b, {16, 8});
    EXPECT_LE(found.x, 90u);
    EXPECT_GE(found.x + 16, 98u);
    EXPECT_EQ(found.y, 40u);
    EXPECT_EQ(most_different_part(a, a, {16, 8}), glm::uvec2(0)) << "nothing differs";
    EXPECT_EQ(most_different_part(a, b, {256, 256}), glm::uvec2(0)) << "all of it";
}

TEST(PicturePart, EnlargedRepeatsItsPixels) {
    const assets::Image small = counted(4, 3);
    const assets::Image large = enlarged(small, 3);
    ASSERT_EQ(large.width, 12u);
    ASSERT_EQ(large.height, 9u);
    ASSERT_EQ(large.texels.size(), std::size_t{12} * 9 * 4);
    for (std::size_t y = 0; y < 9; ++y)
        for (std::size_t x = 0; x < 12; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel)
                EXPECT_EQ(large.texels[4 * (12 * y + x) + channel],
                          small.texels[4 * (4 * (y / 3) + x / 3) + channel]);
}

}  // namespace
}  // namespace rambla::game::study
