#include <gtest/gtest.h>

#include <cmath>

#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {
namespace {

glm::vec4 texel(const Image& image, std::uint32_t x, std::uint32_t y) {
    glm::vec4 value{0.0f};
    for (int i = 0; i < 4; ++i)
        value[i] = static_cast<float>(
                       image.texels[(std::size_t{y} * image.width + x) * 4 + static_cast<std::size_t>(i)]) /
                   255.0f;
    return value;
}

/// Mean absolute difference between two columns or rows of texels.
double seam(const Image& image, std::uint32_t a, std::uint32_t b, bool columns) {
    const std::uint32_t count = columns ? image.height : image.width;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec4 d =
            columns ? texel(image, a, i) - texel(image, b, i) : texel(image, i, a) - texel(image, i, b);
        sum += std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    }
    return sum / count;
}

TEST(Textures, FillTheirImages) {
    for (const PaintedSet& set : paint_all_patterns(5)) {
        for (const Image* image :
             {&set.colour, set.normal ? &*set.normal : nullptr, set.roughness ? &*set.roughness : nullptr,
              set.emission ? &*set.emission : nullptr, set.relief ? &set.relief->image : nullptr}) {
            if (image == nullptr) continue;
            EXPECT_EQ(image->texels.size(), std::size_t{image->width} * image->height * 4) << image->name;
        }
    }
}

TEST(Textures, TileWithoutSeams) {
    for (const Pattern pattern : {Pattern::plaster, Pattern::brick, Pattern::stone, Pattern::stucco,
                                  Pattern::asphalt, Pattern::paving, Pattern::bark}) {
        const PaintedSet set = paint_pattern(pattern, 9);
        const Image& image = set.colour;
        const std::uint32_t w = image.width;
        const std::uint32_t h = image.height;
        // The step across the seam must look like steps elsewhere; joints make some of those large, so the
        // largest of a row of inner steps is the measure.
        double inner_x = 0.0;
        double inner_y = 0.0;
        for (std::uint32_t i = 1; i < w; ++i)
            inner_x = std::max(inner_x, seam(image, i - 1, i, true));
        for (std::uint32_t i = 1; i < h; ++i)
            inner_y = std::max(inner_y, seam(image, i - 1, i, false));
        EXPECT_LE(seam(image, w - 1, 0, true), 1.1 * inner_x) << set.name;
        EXPECT_LE(seam(image, h - 1, 0, false), 1.1 * inner_y) << set.name;
    }
}

TEST(Textures, HaveUnitNormalsThatFaceOutwards) {
    for (const PaintedSet& set : paint_all_patterns(5)) {
        if (!set.normal) continue;
        for (std::uint32_t y = 0; y < set.normal->height; y += 7) {
            for (std::uint32_t x = 0; x < set.normal->width; x += 7) {
                const glm::vec3 normal = 2.0f * glm::vec3{texel(*set.normal, x, y)} - 1.0f;
                // Eight bits per component: each is off by 1/255 at most.
                ASSERT_NEAR(glm::length(normal), 1.0f, 0.015f) << set.name;
                ASSERT_GT(normal.z, 0.0f) << set.name;
            }
        }
    }
}

TEST(Textures, HaveHeightsThatNormalsAreTheSlopesOf) {
    for (const Pattern pattern : {Pattern::brick, Pattern::stone, Pattern::paving}) {
        const PaintedSet set = paint_pattern(pattern, 4);
        ASSERT_TRUE(set.relief) << set.name;
        const Image& heights = set.relief->image;
        ASSERT_EQ(heights.width, heights.height) << "coordinates are as long one way as the other";
        float lowest = 1.0f, highest = 0.0f;
        double worst = 0.0;
        for (std::uint32_t y = 1; y + 1 < heights.height; ++y) {
            for (std::uint32_t x = 1; x + 1 < heights.width; ++x) {
                lowest = std::min(lowest, texel(heights, x, y).x);
                highest = std::max(highest, texel(heights, x, y).x);
                const float rise = 0.5f * (texel(heights, x + 1, y).x - texel(heights, x - 1, y).x);
                const float slope = rise * set.relief->depth * static_cast<float>(heights.width);
                const glm::vec3 normal = 2.0f * glm::vec3{texel(*set.normal, x, y)} - 1.0f;
                worst = std::max<double>(worst, std::abs(slope + normal.x / normal.z));
            }
        }
        EXPECT_LT(lowest, 0.02f) << set.name;
        EXPECT_GT(highest, 0.98f) << set.name;
        // Heights are off by half a step of 1/255, and so is a difference of two, halved; normals by 1/255,
        // which weighs up to 1 + slope² ≈ 6 where they are steepest.
        const double step = set.relief->depth * heights.width / 255.0;
        EXPECT_LT(worst, 0.5 * step + 6.0 * 1.5 / 255.0) << set.name;
    }
}

TEST(Textures, ShowLouvresThatShedRain) {
    // Slats lean outwards at their lower edge, so their faces look up: normals point up the image, which in
    // glTF's convention is green above one half.
    const PaintedSet set = paint_pattern(Pattern::louvre, 2);
    double green = 0.0;
    int count = 0;
    for (std::uint32_t y = 0; y < set.normal->height; ++y) {
        const float v = texel(*set.normal, set.normal->width / 2, y).y;
        if (v < 0.5f) continue;  // the steps between slats
        green += v;
        ++count;
    }
    ASSERT_GT(count, 50);
    EXPECT_GT(green / count, 0.55);
    // Steps are few: two texels of each slat's twelve.
    EXPECT_GT(count, static_cast<int>(0.7 * set.normal->height));
}

TEST(Textures, CutLeavesAndRailingsOut) {
    for (const auto& [pattern, least, most] :
         {std::tuple{Pattern::leaves, 0.3, 0.8}, {Pattern::railing, 0.1, 0.5}}) {
        const PaintedSet set = paint_pattern(pattern, 3);
        std::size_t covered = 0;
        for (std::uint32_t y = 0; y < set.colour.height; ++y)
            for (std::uint32_t x = 0; x < set.colour.width; ++x)
                covered += texel(set.colour, x, y).w > 0.5f ? 1 : 0;
        const double share =
            static_cast<double>(covered) / (static_cast<double>(set.colour.width) * set.colour.height);
        EXPECT_GT(share, least) << set.name;
        EXPECT_LT(share, most) << set.name;
    }
}

TEST(Noise, StaysInItsRangeAndRepeats) {
    for (int i = 0; i < 200; ++i) {
        const float v = static_cast<float>(i) / 200.0f;
        const float left = value_noise({0.0f, v}, {5, 7}, 11);
        EXPECT_NEAR(left, value_noise({1.0f, v}, {5, 7}, 11), 1e-6f);
        EXPECT_TRUE(left >= 0.0f && left <= 1.0f);
        const float many = fractal_noise({v, 0.3f}, {4, 4}, 5, 11);
        EXPECT_TRUE(many >= 0.0f && many <= 1.0f);
        const glm::vec2 cells = cell_noise({v, 0.6f}, {6, 6}, 11);
        EXPECT_LE(cells.x, cells.y);
    }
}

}  // namespace
}  // namespace rambla::assets::generate
