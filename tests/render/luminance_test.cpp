// The average luminance of a picture against double precision, and what broken pixels do to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/display_harness.h"
#include "render/post/picture_reference.h"
#include "render/shader_harness.h"

namespace {

using namespace rambla;
using render::LuminanceMethod;
using tests::DisplayHarness;
using tests::Light;
using tests::Random;
using tests::Shown;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();
constexpr double k_wanted = 1e-3;
/// Sizes that are powers of 4, and such that are none of anything.
constexpr std::array<glm::uvec2, 12> k_sizes{{{1, 1},
                                              {1, 7},
                                              {5, 1},
                                              {2, 3},
                                              {4, 4},
                                              {16, 16},
                                              {17, 16},
                                              {3, 131},
                                              {97, 2},
                                              {63, 65},
                                              {64, 64},
                                              {257, 129}}};

/// Luminances spread evenly over the stops from 1e-4 to the largest half float, and some that are 0.
Light spread_light(glm::uvec2 size, Random& random) {
    Light light{size, glm::vec3{0.0f}};
    for (glm::vec3& texel : light.texels) {
        const float level = 1e-4f * std::pow(65504.0f / 1e-4f, random());
        if (random() > 0.1f) texel = level * glm::vec3{random(), random(), random()};
    }
    light.texels.front() = glm::vec3{65504.0f};
    return light;
}

double reference(const DisplayHarness& gpu, const Light& light) {
    return render::log_average_luminance(light.texels, static_cast<double>(gpu.settings.exposure.delta));
}

double average(const Shown& shown) {
    return static_cast<double>(shown.exposure.value().seen.x);
}

/// How far the GPU's average is from that in double precision, as a share of it.
double error(DisplayHarness& gpu, const Light& light) {
    const double expected = reference(gpu, light);
    return std::fabs(average(gpu.show(light)) - expected) / expected;
}

class Luminance : public testing::TestWithParam<LuminanceMethod> {
protected:
    Luminance() { gpu.settings.exposure.luminance = GetParam(); }
    DisplayHarness gpu;
    Random random;
};

INSTANTIATE_TEST_SUITE_P(By, Luminance, testing::Values(LuminanceMethod::chain, LuminanceMethod::compute),
                         [](const auto& method) {
                             return std::string{
                                 render::k_luminance_methods[static_cast<std::size_t>(method.param)]};
                         });

TEST_P(Luminance, EqualsDoublePrecisionAtEverySize) {
    for (const glm::uvec2 size : k_sizes)
        EXPECT_LT(error(gpu, spread_light(size, random)), k_wanted) << size.x << "x" << size.y;
}

TEST_P(Luminance, CountsThePixelsAtTheRimsLikeAllOthers) {
    // Dark, but for the last row and column, which no whole block holds.
    for (const glm::uvec2 size : {glm::uvec2{5, 5}, {65, 65}, {66, 33}}) {
        Light light{size, glm::vec3{1e-3f}};
        for (std::uint32_t y = 0; y < size.y; ++y)
            for (std::uint32_t x = 0; x < size.x; ++x)
                if (x + 1 == size.x || y + 1 == size.y) light.texels[y * size.x + x] = glm::vec3{1e3f};
        EXPECT_LT(error(gpu, light), k_wanted) << size.x << "x" << size.y;
    }
}

TEST_P(Luminance, CountsEverySquareOfALargePicture) {
    // 17 squares of 64 down and across: more than one workgroup has invocations to add them up. One half is
    // bright.
    Light light{{1030, 1040}, glm::vec3{1e-2f}};
    for (std::size_t i = light.texels.size() / 2; i < light.texels.size(); ++i)
        light.texels[i] = glm::vec3{10.0f};
    EXPECT_LT(error(gpu, light), k_wanted);
}

TEST_P(Luminance, OfBlackIsDelta) {
    for (const float delta : {1e-6f, 1e-4f, 1.0f}) {
        gpu.settings.exposure.delta = delta;
        const Light black{{37, 23}, glm::vec3{0.0f}};
        EXPECT_NEAR(average(gpu.show(black)) / static_cast<double>(delta), 1.0, k_wanted) << delta;
    }
}

TEST_P(Luminance, HardlyChangesForOneHotPixel) {
    Light light{{64, 64}, glm::vec3{0.2f}};
    const double before = average(gpu.show(light));
    light.texels[1234] = glm::vec3{65504.0f};
    EXPECT_LT(error(gpu, light), k_wanted);
    // A 4096th of the logarithm of 65504/0.2 is 0.3 %.
    EXPECT_NEAR(average(gpu.show(light)) / before, std::pow(65504.0 / 0.2, 1.0 / 4096.0), 1e-4);
}

TEST_P(Luminance, TakesInfiniteAndUndefinedPixelsForBlackAndCountsThem) {
    const glm::vec3 broken[] = {glm::vec3{k_nan},
                                glm::vec3{k_infinity},
                                glm::vec3{-k_infinity},
                                {0.2f, k_nan, 0.2f},
                                {k_infinity, 0.2f, -k_infinity}};
    const Light grey{{33, 17}, glm::vec3{0.2f}};
    for (const glm::vec3& texel : broken) {
        Light black = grey, bad = grey;
        black.texels[100] = glm::vec3{0.0f};
        bad.texels[100] = texel;
        const Shown with_black = gpu.show(black), with_bad = gpu.show(bad);
        EXPECT_EQ(with_black.exposure->seen.y, 0.0f);
        EXPECT_EQ(with_bad.exposure->seen.y, 1.0f);
        EXPECT_EQ(with_bad.exposure->seen.x, with_black.exposure->seen.x);
        for (std::size_t i = 0; i < grey.texels.size(); ++i)
            ASSERT_TRUE(i == 100 || with_bad.display(i) == with_black.display(i)) << i;
    }
}

TEST_P(Luminance, IsANumberWhereHalfThePictureIsInfinite) {
    Light light{{50, 30}, glm::vec3{0.5f}};
    for (std::size_t i = 0; i < light.texels.size(); i += 2)
        light.texels[i] = glm::vec3{k_infinity};
    EXPECT_LT(error(gpu, light), k_wanted);
    EXPECT_EQ(gpu.show(light).exposure->seen.y, 750.0f);
}

TEST_P(Luminance, TakesNegativeLightForBlackAndDoesNotCountIt) {
    Light light{{20, 20}, glm::vec3{0.5f}};
    light.texels[7] = glm::vec3{-3.0f};
    light.texels[8] = glm::vec3{-1e-40f};
    EXPECT_LT(error(gpu, light), k_wanted);
    EXPECT_EQ(gpu.show(light).exposure->seen.y, 0.0f);
}

TEST_P(Luminance, ReadsHalfFloatsAndPackedOnes) {
    const Light light{{40, 40}, glm::vec3{0.25f}};  // which both hold exactly
    EXPECT_NEAR(average(gpu.show(light, 0.0, GL_RGBA16F)), 0.2501, 0.2501 * k_wanted);
    EXPECT_NEAR(average(gpu.show(light, 0.0, GL_R11F_G11F_B10F)), 0.2501, 0.2501 * k_wanted);
}

TEST(LuminanceByMips, IsExactWhereEveryLevelHalves) {
    DisplayHarness gpu;
    Random random;
    const Light light = spread_light({64, 32}, random);
    gpu.settings.exposure.luminance = LuminanceMethod::mips;
    EXPECT_LT(error(gpu, light), k_wanted);
    gpu.settings.exposure.luminance = LuminanceMethod::mips16;
    // Halves around 2 are 1/1024 apart, and so are logarithms then; each of the levels may round once.
    EXPECT_LT(error(gpu, light), 11.0 * 0.5 / 512.0);
}

TEST(LuminancePasses, AreThereOnlyForWhatAsksForThem) {
    DisplayHarness gpu;
    const Light light{{9, 9}, glm::vec3{0.3f}};
    const auto looks = [&] {
        const Shown shown = gpu.show(light);
        EXPECT_EQ(shown.exposure.has_value(),
                  std::find(shown.passes.begin(), shown.passes.end(), "luminance") != shown.passes.end());
        return shown.exposure.has_value();
    };
    gpu.settings.exposure.mode = render::ExposureMode::fixed;
    EXPECT_FALSE(looks());
    EXPECT_EQ(gpu.programs(), 1u) << "the curve";
    gpu.settings.tone = {.curve = render::ToneCurve::aces, .estimate = true};
    EXPECT_FALSE(looks()) << "only extended Reinhard has parameters to estimate";
    gpu.settings.tone.curve = render::ToneCurve::extended;
    EXPECT_TRUE(looks());
    gpu.settings.tone.estimate = false;
    EXPECT_FALSE(looks());
    gpu.settings.exposure.mode = render::ExposureMode::automatic;
    EXPECT_TRUE(looks());
    gpu.settings.debug.view = render::DebugView::albedo;
    EXPECT_FALSE(looks()) << "nobody sees the picture";
}

TEST(HdrChain, ABrokenPixelChangesNoOther) {
    const float values[] = {k_nan, k_infinity, -k_infinity, 1e-40f, 65504.0f, 0.0f, -5.0f};
    const std::size_t place = 100;
    for (const auto mode : {render::ExposureMode::fixed, render::ExposureMode::automatic}) {
        for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
            for (const auto on : {render::ToneOn::channels, render::ToneOn::luminance}) {
                DisplayHarness gpu;
                gpu.settings.exposure.mode = mode;
                gpu.settings.tone.curve = static_cast<render::ToneCurve>(curve);
                gpu.settings.tone.on = on;
                gpu.settings.tone.gamma = 1.2f;
                gpu.settings.tone.blue_shift = 0.5f;
                Light light{{33, 17}, glm::vec3{0.3f, 0.2f, 0.1f}};
                light.texels[place] = glm::vec3{0.0f};
                const Shown with_black = gpu.show(light);
                for (const float value : values) {
                    light.texels[place] = glm::vec3{value};
                    gpu.cut = true;
                    const Shown shown = gpu.show(light);
                    for (std::size_t i = 0; i < light.texels.size(); ++i) {
                        if (i == place) continue;
                        // From black to the largest half, one pixel of 561 makes the average 3.6 % brighter,
                        // of which exposure takes 0.4 back: two of 255 in what is encoded.
                        const glm::ivec3 away = glm::abs(shown.display(i) - with_black.display(i));
                        const bool moves = mode == render::ExposureMode::automatic && value == 65504.0f;
                        ASSERT_LE(std::max({away.x, away.y, away.z}), moves ? 2 : 0)
                            << value << " at another pixel, " << render::k_tone_curves[curve];
                    }
                    const bool is_bright = value > 1.0f;
                    const glm::ivec3 self = shown.display(place);
                    if (is_bright) {
                        EXPECT_GE(std::min({self.x, self.y, self.z}), 250) << value;
                    } else {
                        EXPECT_EQ(self, glm::ivec3{0}) << value;
                    }
                }
            }
        }
    }
}

}  // namespace
