#include "game/study/picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace rambla::game::study {
namespace {

template <class Value, std::size_t count>
assets::Image image_of(std::uint32_t width, std::uint32_t height, assets::PixelFormat format,
                       const std::array<Value, count>& values) {
    assets::Image image{.name = "", .width = width, .height = height, .format = format, .texels = {}};
    image.texels.resize(sizeof values);
    std::memcpy(image.texels.data(), values.data(), sizeof values);
    return image;
}

TEST(Picture, OfBytesIsTheirLinearLight) {
    const std::array<std::uint8_t, 8> bytes{0, 255, 128, 7, 10, 1, 188, 0};
    const Picture picture = to_picture(image_of(2, 1, assets::PixelFormat::rgba8, bytes));
    EXPECT_EQ(picture.width, 2u);
    EXPECT_EQ(picture.height, 1u);
    EXPECT_EQ(picture.at(0, 0).x, 0.0f);
    EXPECT_EQ(picture.at(0, 0).y, 1.0f);
    // Single precision.
    EXPECT_NEAR(picture.at(0, 0).z, std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(picture.at(1, 0).x, 10.0 / 255.0 / 12.92, 1e-8);
    EXPECT_NEAR(picture.at(1, 0).z, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
}

TEST(Picture, OfFloatsIsTheFloats) {
    const std::array<float, 8> floats{0.1f, 20.0f, -3.0f, 9.0f, 1e30f, 0.0f, 1.0f, 9.0f};
    const Picture picture = to_picture(image_of(1, 2, assets::PixelFormat::rgba32f, floats));
    EXPECT_EQ(picture.at(0, 0), (glm::vec3{0.1f, 20.0f, -3.0f}));
    EXPECT_EQ(picture.at(0, 1), (glm::vec3{1e30f, 0.0f, 1.0f}));
}

TEST(Picture, OfNanKeepsIt) {
    const std::array<float, 4> floats{std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f, 1.0f};
    EXPECT_TRUE(std::isnan(to_picture(image_of(1, 1, assets::PixelFormat::rgba32f, floats)).at(0, 0).x));
}

TEST(Picture, OfNothingIsEmpty) {
    EXPECT_TRUE(to_picture({}).texels.empty());
}

}  // namespace
}  // namespace rambla::game::study
