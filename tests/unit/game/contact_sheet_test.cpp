#include "game/contact_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rambla::game {
namespace {

assets::Image picture(std::uint32_t width, std::uint32_t height) {
    return {.name = "test",
            .width = width,
            .height = height,
            .format = assets::PixelFormat::rgba8,
            .texels = std::vector<std::byte>(std::size_t{width} * height * 4, std::byte{255})};
}

void set(assets::Image& image, std::uint32_t x, std::uint32_t y, int grey) {
    for (std::uint32_t c = 0; c < 3; ++c) {
        image.texels[(std::size_t{y} * image.width + x) * 4 + c] = static_cast<std::byte>(grey);
    }
}

int grey_at(const assets::Image& image, std::uint32_t x, std::uint32_t y) {
    return std::to_integer<int>(image.texels[(std::size_t{y} * image.width + x) * 4]);
}

/// IEC 61966-2-1, in double precision.
double linear(int byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double mean_linear(const assets::Image& image) {
    double sum = 0.0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x)
            sum += linear(grey_at(image, x, y));
    }
    return sum / (static_cast<double>(image.width) * image.height);
}

TEST(Shrunk, HalfBlackHalfWhiteIsHalfTheLightNotHalfTheByte) {
    assets::Image image = picture(2, 2);
    set(image, 0, 0, 0);
    set(image, 1, 1, 0);
    // Linear 0.5 is 188 in sRGB; averaging bytes would give 128.
    EXPECT_EQ(grey_at(shrunk(image, {1, 1}), 0, 0), 188);
}

TEST(Shrunk, FractionalFootprintsKeepTheMeanLight) {
    std::mt19937 random{5};
    assets::Image image = picture(37, 23);
    for (std::uint32_t y = 0; y < 23; ++y) {
        for (std::uint32_t x = 0; x < 37; ++x)
            set(image, x, y, static_cast<int>(random() % 256));
    }
    // Each texel rounds to a byte, at most half a step of 1/255 · 1.4 (the steepest of sRGB around grey);
    // errors average.
    EXPECT_NEAR(mean_linear(shrunk(image, {10, 7})), mean_linear(image), 0.002);
}

TEST(Shrunk, AnAreaIsAveragedAndNothingElse) {
    assets::Image image = picture(6, 3);
    for (std::uint32_t y = 0; y < 3; ++y) {
        for (std::uint32_t x = 0; x < 3; ++x)
            set(image, x, y, 0);
    }
    const assets::Image small = shrunk(image, {2, 1});
    EXPECT_EQ(grey_at(small, 0, 0), 0);
    EXPECT_EQ(grey_at(small, 1, 0), 255);
}

TEST(Shrunk, TheSameSizeIsTheSamePicture) {
    assets::Image image = picture(16, 16);
    for (std::uint32_t i = 0; i < 256; ++i)
        set(image, i % 16, i / 16, static_cast<int>(i));
    EXPECT_EQ(shrunk(image, {16, 16}).texels, image.texels);
}

TEST(ContactSheet, CellsAreAGridThatHoldsAllPictures) {
    const ContactSheet sheet{7, {960, 540}};
    EXPECT_EQ(sheet.cell_size_px(), glm::uvec2(320, 180));
    const glm::uvec2 cell = sheet.cell_size_px();
    EXPECT_GE(sheet.image().width, 3 * cell.x);  // 3 × 3 cells are the squarest grid for 7
    EXPECT_LT(sheet.image().width, 4 * cell.x);
    EXPECT_GE(sheet.image().height, 3 * cell.y);
    EXPECT_LT(sheet.image().height, 4 * cell.y);
    EXPECT_EQ(sheet.image().texels.size(), std::size_t{sheet.image().width} * sheet.image().height * 4);
}

TEST(ContactSheet, SmallPicturesAreNotEnlarged) {
    EXPECT_EQ((ContactSheet{4, {100, 40}}.cell_size_px()), glm::uvec2(100, 40));
}

TEST(ContactSheet, CellsMayBeWiderThanUsual) {
    EXPECT_EQ((ContactSheet{4, {960, 540}, 640}.cell_size_px()), glm::uvec2(640, 360));
}

TEST(ContactSheet, EachPictureLandsInItsOwnCell) {
    ContactSheet sheet{4, {20, 10}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        assets::Image image = picture(20, 10);
        for (std::uint32_t y = 0; y < 10; ++y) {
            for (std::uint32_t x = 0; x < 20; ++x)
                set(image, x, y, static_cast<int>(50 * i + 10));
        }
        sheet.place(i, image);
    }
    const std::uint32_t width = sheet.image().width;
    const std::uint32_t height = sheet.image().height;
    EXPECT_EQ(grey_at(sheet.image(), width / 4, height / 4), 10);
    EXPECT_EQ(grey_at(sheet.image(), 3 * width / 4, height / 4), 60);
    EXPECT_EQ(grey_at(sheet.image(), width / 4, 3 * height / 4), 110);
    EXPECT_EQ(grey_at(sheet.image(), 3 * width / 4, 3 * height / 4), 160);
    EXPECT_EQ(grey_at(sheet.image(), width / 2, height / 2), 0) << "the gap between the cells";
}

}  // namespace
}  // namespace rambla::game
