#include "assets/process/mips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "assets/process/image_rows.h"
#include "assets/process/raster.h"
#include "assets/process/srgb.h"

namespace rambla::assets::test {
namespace {

using Texel = std::array<int, 4>;

template <class Colour>
Image painted(std::uint32_t width, std::uint32_t height, Colour&& colour) {
    Image image{.name = {}, .width = width, .height = height, .texels = {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (const int channel : Texel{colour(x, y)})
                image.texels.push_back(static_cast<std::byte>(channel));
    return image;
}

int channel(const Image& image, std::uint32_t x, std::uint32_t y, std::size_t c) {
    return std::to_integer<int>(image.texels[4 * (std::size_t{y} * image.width + x) + c]);
}

Image float_image(std::uint32_t width, std::uint32_t height, const std::vector<glm::vec4>& texels) {
    Image image{.name = {}, .width = width, .height = height, .format = PixelFormat::rgba32f, .texels = {}};
    image.texels.resize(texels.size() * 16);
    std::memcpy(image.texels.data(), texels.data(), image.texels.size());
    return image;
}

std::vector<glm::vec4> floats(const Image& image) {
    std::vector<glm::vec4> texels(image.texels.size() / 16);
    std::memcpy(texels.data(), image.texels.data(), image.texels.size());
    return texels;
}

TEST(Mips, SrgbIsAveragedAsLight) {
    // Half black and half white send half of white's light: sRGB 188, not 128.
    const Image checks = painted(2, 2, [](auto x, auto y) {
        return (x + y) % 2 == 0 ? Texel{0, 0, 0, 255} : Texel{255, 255, 255, 255};
    });
    EXPECT_EQ(channel(colour_mips(checks, {.colour_space = ColourSpace::srgb})[1], 0, 0, 0), 188);
    EXPECT_EQ(channel(colour_mips(checks, {.colour_space = ColourSpace::linear})[1], 0, 0, 0), 128);
}

TEST(Mips, SrgbRoundTripsEveryByte) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(byte_from_unit(srgb_from_linear(linear_from_srgb_bytes()[static_cast<std::size_t>(i)])), i);
        // IEC 61966-2-1, in double.
        const double v = i / 255.0;
        EXPECT_NEAR(linear_from_srgb_bytes()[static_cast<std::size_t>(i)],
                    v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4), 1e-6);
    }
}

TEST(Mips, SizesHalveDownToOne) {
    for (const auto& [width, height] :
         {std::pair{1u, 1u}, {1u, 9u}, {13u, 1u}, {5u, 7u}, {64u, 16u}, {100u, 3u}}) {
        const auto levels = colour_mips(painted(width, height,
                                                [](auto, auto) {
                                                    return Texel{90, 120, 7, 200};
                                                }),
                                        {});
        EXPECT_EQ(levels.size(), mip_count(width, height));
        for (std::size_t i = 0; i < levels.size(); ++i) {
            EXPECT_EQ(levels[i].width, std::max(1u, width >> i));
            EXPECT_EQ(levels[i].height, std::max(1u, height >> i));
            for (std::uint32_t x = 0; x < levels[i].width; ++x) {
                EXPECT_EQ(channel(levels[i], x, 0, 0), 90);
                EXPECT_EQ(channel(levels[i], x, 0, 2), 7);
                EXPECT_EQ(channel(levels[i], x, 0, 3), 200);
            }
        }
        EXPECT_EQ(levels.back().width * levels.back().height, 1u);
    }
}

TEST(Mips, OddSizesNeitherShiftNorLoseLight) {
    std::mt19937 random{3};
    std::uniform_real_distribution<float> unit{0.0f, 1.0f};
    for (const std::uint32_t width : {3u, 5u, 7u, 37u, 101u, 127u, 255u, 300u}) {
        std::vector<glm::vec4> ramp;
        std::vector<glm::vec4> noise;
        double mean = 0.0;
        for (std::uint32_t x = 0; x < width; ++x) {
            const float place = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
            ramp.emplace_back(place, 1.0f - place, 0.0f, 1.0f);
            noise.emplace_back(unit(random), 0.0f, 0.0f, 1.0f);
            mean += noise.back().x / static_cast<double>(width);
        }
        // A ramp stays one: at a texel's centre, its place. Means of means are not quite the area's mean; the
        // three weights' centre is off by at most a quarter of an old texel over the new width.
        double allowed = 1e-5;
        for (const Image& level : colour_mips(float_image(width, 1, ramp), {})) {
            const auto texels = floats(level);
            for (std::size_t x = 0; x < texels.size(); ++x)
                EXPECT_NEAR(texels[x].x, (static_cast<double>(x) + 0.5) / static_cast<double>(texels.size()),
                            allowed)
                    << width << " to " << texels.size();
            const double old_width = static_cast<double>(texels.size());
            allowed += 0.25 / old_width / std::max(1.0, std::floor(old_width / 2));
        }
        EXPECT_NEAR(floats(colour_mips(float_image(width, 1, noise), {}).back())[0].x, mean, 1e-5);
    }
    // Five texels onto two, by hand: weights (2, 2, 1)/5 and (1, 2, 2)/5.
    const std::vector<glm::vec4> spike{{0, 0, 0, 1}, {0, 0, 0, 1}, {5, 0, 0, 1}, {0, 0, 0, 1}, {10, 0, 0, 1}};
    const auto half = floats(colour_mips(float_image(5, 1, spike), {})[1]);
    EXPECT_FLOAT_EQ(half[0].x, 1.0f);
    EXPECT_FLOAT_EQ(half[1].x, 5.0f);
}

TEST(Mips, TransparentTexelsLendNoColour) {
    // Green leaves on transparent magenta.
    const Image leaf = painted(4, 4, [](auto x, auto) {
        return x < 1 ? Texel{0, 200, 0, 255} : Texel{255, 0, 255, 0};
    });
    const Image blended = colour_mips(leaf, {.alpha = AlphaUse::blended})[1];
    EXPECT_EQ(channel(blended, 0, 0, 0), 0);
    EXPECT_EQ(channel(blended, 0, 0, 1), 200);
    EXPECT_EQ(channel(blended, 0, 0, 3), 128);
    EXPECT_EQ(channel(blended, 1, 0, 0), 255);  // nothing but transparent ones: their own colour
    EXPECT_GT(channel(colour_mips(leaf, {.alpha = AlphaUse::ignored})[1], 0, 0, 0), 100);
}

/// Share of a repeated picture that passes, at 8 × 8 bilinear samples a texel: written apart from the code's
/// own.
double coverage_of(const Image& image, float cutoff) {
    std::size_t passing = 0;
    constexpr std::uint32_t k_side = 8;
    const auto alpha = [&](std::int64_t x, std::int64_t y) {
        const auto w = static_cast<std::int64_t>(image.width);
        const auto h = static_cast<std::int64_t>(image.height);
        return channel(image, static_cast<std::uint32_t>((x + w) % w),
                       static_cast<std::uint32_t>((y + h) % h), 3) /
               255.0;
    };
    for (std::uint32_t sy = 0; sy < image.height * k_side; ++sy)
        for (std::uint32_t sx = 0; sx < image.width * k_side; ++sx) {
            const double px = (sx + 0.5) / k_side - 0.5;
            const double py = (sy + 0.5) / k_side - 0.5;
            const auto x = static_cast<std::int64_t>(std::floor(px));
            const auto y = static_cast<std::int64_t>(std::floor(py));
            const double fx = px - static_cast<double>(x);
            const double fy = py - static_cast<double>(y);
            const double a = (1 - fy) * ((1 - fx) * alpha(x, y) + fx * alpha(x + 1, y)) +
                             fy * ((1 - fx) * alpha(x, y + 1) + fx * alpha(x + 1, y + 1));
            passing += a >= cutoff ? 1 : 0;
        }
    return static_cast<double>(passing) / (image.width * image.height * k_side * k_side);
}

Image passing_or_not(Image image, float cutoff) {
    for (std::size_t i = 3; i < image.texels.size(); i += 4) {
        const bool passes = std::to_integer<int>(image.texels[i]) >= cutoff * 255.0f;
        image.texels[i] = passes ? std::byte{255} : std::byte{0};
    }
    return image;
}

TEST(Mips, AlphaTestedPicturesLoseNoCoverage) {
    std::mt19937 random{21};
    std::uniform_real_distribution<float> unit{0.0f, 1.0f};
    std::vector<glm::vec3> discs;
    for (int i = 0; i < 400; ++i)
        discs.emplace_back(unit(random), unit(random), 0.006f + 0.018f * unit(random));
    const Image leaves = painted(160, 120, [&](auto x, auto y) {
        const glm::vec2 at{(static_cast<float>(x) + 0.5f) / 160.0f, (static_cast<float>(y) + 0.5f) / 120.0f};
        float edge = 0.0f;
        for (const glm::vec3& disc : discs)
            edge = std::max(
                edge, glm::clamp(0.5f + 80.0f * (disc.z - glm::distance(at, glm::vec2{disc})), 0.0f, 1.0f));
        return Texel{40, 120, 30, static_cast<int>(255.0f * edge)};
    });
    double lost = 0.0;
    int raised = 0;
    for (const float cutoff : {0.3f, 0.5f, 0.75f}) {
        const double wanted = coverage_of(leaves, cutoff);
        ASSERT_GT(wanted, 0.1);
        ASSERT_LT(wanted, 0.9);
        const auto levels = colour_mips(leaves, {.alpha = AlphaUse::tested, .cutoff = cutoff});
        const auto means = colour_mips(passing_or_not(leaves, cutoff), {.alpha = AlphaUse::blended});
        for (std::size_t i = 1; i < levels.size(); ++i) {
            if (levels[i].width * levels[i].height < 12) break;  // so few texels cannot show every share
            const double mean = coverage_of(means[i], cutoff);
            EXPECT_NEAR(coverage_of(levels[i], cutoff), std::max(wanted, mean), 0.01)
                << levels[i].width << " × " << levels[i].height;
            raised += mean < wanted - 0.02 ? 1 : 0;
        }
        lost = std::max(
            lost,
            std::abs(coverage_of(colour_mips(leaves, {.alpha = AlphaUse::blended})[4], cutoff) - wanted));
    }
    EXPECT_GT(lost, 0.05) << "without it, the picture would not show the difference";
    EXPECT_GT(raised, 0);
}

TEST(Mips, ASlopeOfAlphaIsCutAtTheSamePlaceInAllLevels) {
    // The lower half slopes; dots above, which coarser levels lose, must not move where it is cut.
    const Image sloping = painted(256, 256, [](auto x, auto y) {
        const bool dot = y < 64 && x % 4 == 0 && y % 4 == 0;
        const int slope = y < 128 ? 0 : static_cast<int>(y - 128) * 2;
        return Texel{90, 90, 90, dot ? 255 : slope};
    });
    for (const float cutoff : {0.25f, 0.5f, 0.75f}) {
        const auto levels = colour_mips(sloping, {.alpha = AlphaUse::tested, .cutoff = cutoff});
        for (const Image& level : levels) {
            if (level.height < 8) break;  // a slope of a few texels
            std::uint32_t first = level.height / 2;
            while (channel(level, 1, first, 3) < cutoff * 255.0f)
                ++first;
            const float texel = 1.0f / static_cast<float>(level.height);
            EXPECT_NEAR(static_cast<float>(first) * texel, 0.5f + 0.5f * cutoff, texel) << level.height;
        }
    }
}

TEST(Mips, ThinBarsBetweenBroadRailsAreNotLostForWhatTheRailsGain) {
    constexpr float k_cutoff = 0.25f;
    const auto passing = [](const Image& level, std::uint32_t y) {
        std::size_t count = 0;
        for (std::uint32_t x = 0; x < level.width; ++x)
            count += channel(level, x, y, 3) >= k_cutoff * 255.0f ? 1 : 0;
        return count;
    };
    // Bars of 3 in 16 texels, wherever they lie between the texels of coarser levels, and two rails.
    for (std::uint32_t shift = 0; shift < 16; ++shift) {
        const Image railing = painted(128, 80, [shift](auto x, auto y) {
            const bool rail = y % 40 < 5;
            return Texel{20, 20, 20, (x + shift) % 16 < 3 || rail ? 255 : 0};
        });
        const auto levels = colour_mips(railing, {.alpha = AlphaUse::tested, .cutoff = k_cutoff});
        const auto means = colour_mips(railing, {.alpha = AlphaUse::blended});
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::uint32_t between_rails = levels[i].height * 3 / 4;
            EXPECT_GE(passing(levels[i], between_rails), passing(means[i], between_rails))
                << "level " << i << ", bars moved by " << shift;
        }
    }
}

TEST(Mips, NormalsStayUnitLength) {
    std::mt19937 random{5};
    std::uniform_int_distribution<int> step{60, 195};
    const Image normals = painted(32, 20, [&](auto, auto) {
        return Texel{step(random), step(random), 220, 255};
    });
    for (const Image& level : normal_mips(normals)) {
        if (level.width == 32) continue;  // as it was given
        for (std::uint32_t y = 0; y < level.height; ++y)
            for (std::uint32_t x = 0; x < level.width; ++x) {
                const glm::vec3 n =
                    glm::vec3{channel(level, x, y, 0), channel(level, x, y, 1), channel(level, x, y, 2)} /
                        127.5f -
                    1.0f;
                EXPECT_NEAR(glm::length(n), 1.0f, 0.01f);  // rounding to bytes: √3/255
            }
    }
    // Two that lean by 45° to both sides stand up in the middle.
    const Image leaning = painted(2, 1, [](auto x, auto) { return Texel{x == 0 ? 38 : 217, 128, 217, 255}; });
    const Image up = normal_mips(leaning)[1];
    EXPECT_NEAR(channel(up, 0, 0, 0), 128, 1);
    EXPECT_NEAR(channel(up, 0, 0, 2), 255, 1);
    // Opposite ones cancel out.
    const Image opposite = painted(2, 1, [](auto x, auto) {
        return Texel{x == 0 ? 0 : 255, 127 + static_cast<int>(x), 128, 255};
    });
    EXPECT_GE(channel(normal_mips(opposite)[1], 0, 0, 2), 127);
}

TEST(Mips, RoughnessWidensByTheLostLength) {
    // Normals of slopes ±s: mean length r = 1/√(1 + s²), so α'² = α² + 2 (1 − r)/r.
    const float slope = 0.4f;
    const glm::vec3 n = glm::normalize(glm::vec3{slope, 0, 1});
    const auto byte = [](float v) {
        return static_cast<int>(std::lround(255.0f * (0.5f + 0.5f * v)));
    };
    const Image normals = painted(8, 8, [&](auto x, auto) {
        return Texel{byte(x % 2 == 0 ? n.x : -n.x), byte(0), byte(n.z), 255};
    });
    const Image rough = painted(8, 8, [](auto, auto) { return Texel{17, 102, 255, 255}; });  // 0.4
    const auto levels = roughness_mips(rough, normals, {});
    EXPECT_EQ(channel(levels[0], 3, 3, 1), 102);
    const double r = 1.0 / std::sqrt(1.0 + slope * slope);
    const double expected = std::pow(std::pow(0.4, 4.0) + 2.0 * (1.0 - r) / r, 0.25);
    EXPECT_NEAR(channel(levels[1], 1, 1, 1), 255.0 * expected, 2.0);
    EXPECT_NEAR(channel(levels[3], 0, 0, 1), 255.0 * expected, 2.0);
    EXPECT_EQ(channel(levels[1], 1, 1, 0), 17);
    EXPECT_EQ(channel(levels[1], 1, 1, 2), 255);
    // Flat normals leave it alone; the factor is contained; a flattened map counts as flat.
    const Image flat = painted(8, 8, [](auto, auto) { return Texel{128, 128, 255, 255}; });
    EXPECT_NEAR(channel(roughness_mips(rough, flat, {})[2], 0, 0, 1), 102, 1);
    EXPECT_NEAR(channel(roughness_mips(rough, flat, {.roughness = 0.5f})[0], 0, 0, 1), 51, 1);
    EXPECT_NEAR(channel(roughness_mips(rough, normals, {.normal_scale = 0.0f})[2], 0, 0, 1), 102, 1);
    // A constant takes the normal map's size; a larger normal map widens level 0 already.
    const Image constant = painted(1, 1, [](auto, auto) { return Texel{255, 255, 255, 255}; });
    const auto made = roughness_mips(constant, normals, {.roughness = 0.4f});
    EXPECT_EQ(made[0].width, 8u);
    EXPECT_EQ(channel(made[0], 0, 0, 1), 102);
    EXPECT_NEAR(channel(made[1], 0, 0, 1), 255.0 * expected, 2.0);
    const Image small = painted(2, 2, [](auto, auto) { return Texel{17, 102, 255, 255}; });
    EXPECT_NEAR(channel(roughness_mips(small, normals, {})[0], 0, 0, 1), 255.0 * expected, 2.0);
}

TEST(Mips, WhatIsNotFiniteCountsAsNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec4> texels{{nan, 1, 2, 1}, {3, std::numeric_limits<float>::infinity(), 2, 1}};
    const auto mean = floats(colour_mips(float_image(2, 1, texels), {})[1]);
    EXPECT_EQ(mean[0], glm::vec4(1.5f, 0.5f, 2.0f, 1.0f));
}

}  // namespace
}  // namespace rambla::assets::test
