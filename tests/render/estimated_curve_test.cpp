// The curve that a picture's luminances ask for, against its formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/display_harness.h"
#include "render/post/picture_reference.h"
#include "render/shader_harness.h"

namespace {

using namespace rambla;
using render::ToneCurve;
using tests::add;
using tests::DisplayHarness;
using tests::Inputs;
using tests::Light;
using tests::Random;
using tests::ShaderHarness;
using tests::Shown;

TEST(EstimatedCurve, EqualsTheFormula) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (int i = 0; i < 2000; ++i) {
        const float low = std::exp2(20.0f * random() - 13.0f);
        const float high = low * std::exp2(14.0f * random());
        add(inputs, {std::exp2(glm::mix(std::log2(low), std::log2(high), random())), low, high, 0.0f});
    }
    const auto found = gpu.run("exposure.glsl", "result.xy = estimated_curve(a.x, a.y, a.z);", inputs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::dvec4 in{inputs[4 * i]};
        const double stops = std::log2(in.z / in.y);
        const double alpha =
            0.18 * std::pow(4.0, (2.0 * std::log2(in.x) - std::log2(in.y) - std::log2(in.z)) / stops);
        if (stops < 0.01) continue;  // which no two bins of the histogram are, and where floats say little
        // Logarithms are off by about 1e-5 and divided by the stops.
        EXPECT_NEAR(found[i].x, alpha, alpha * (1e-4 + 2e-4 / stops)) << stops << " stops";
        const double white = std::max({1.5 * std::exp2(stops - 5.0), alpha * in.z / in.x, 1.0});
        EXPECT_NEAR(found[i].y, white, white * (2e-4 + 2e-4 / stops)) << stops << " stops";
        const render::EstimatedCurve reference = render::estimate_curve(in.x, in.y, in.z);
        EXPECT_NEAR(reference.key, alpha, 1e-9);
        EXPECT_NEAR(reference.white, white, 1e-9 * white);
    }
}

TEST(EstimatedCurve, OfEqualLuminancesIsMiddleGrey) {
    ShaderHarness gpu;
    Inputs inputs;
    for (const float level : {1e-6f, 0.18f, 1.0f, 65504.0f}) {
        add(inputs, {level, level, level, 0.0f});
        add(inputs, {3.0f * level, level, level, 0.0f});  // a few far brighter pixels beyond the percentile
    }
    const auto found = gpu.run("exposure.glsl", "result.xy = estimated_curve(a.x, a.y, a.z);", inputs);
    for (const glm::vec4& curve : found) {
        EXPECT_FLOAT_EQ(curve.x, 0.18f);
        EXPECT_FLOAT_EQ(curve.y, 1.0f);
    }
}

/// Extended Reinhard with what it estimates.
struct Estimating : testing::Test {
    Estimating() {
        gpu.settings.exposure.mode = render::ExposureMode::fixed;
        gpu.settings.exposure.delta = 1e-6f;
        gpu.settings.tone = {.curve = ToneCurve::extended, .estimate = true, .dither = false};
    }
    DisplayHarness gpu;
};

TEST_F(Estimating, FindsPercentilesAndFollowsTheFormula) {
    Random random;
    for (const glm::uvec2 size : {glm::uvec2{200, 150}, {64, 64}, {333, 77}}) {
        Light light{size, glm::vec3{0.0f}};
        for (glm::vec3& texel : light.texels)
            texel = glm::vec3{std::exp2(-9.0f + 12.0f * random() * random())};
        for (std::size_t i = 0; i < light.texels.size(); i += 301)  // 0.3 %: beyond the percentiles
            light.texels[i] = glm::vec3{i % 2 == 0 ? 60000.0f : 0.0f};
        const auto found = gpu.show(light).exposure.value();
        const double low = render::luminance_percentile(light.texels, 0.01);
        const double high = render::luminance_percentile(light.texels, 0.99);
        // A bin is 1/28 of a stop wide, 2.5 %, and its middle stands for it.
        EXPECT_NEAR(found.seen.z, low, 0.0125 * low);
        EXPECT_NEAR(found.seen.w, high, 0.0125 * high);
        const render::EstimatedCurve expected =
            render::estimate_curve(static_cast<double>(found.seen.x), static_cast<double>(found.seen.z),
                                   static_cast<double>(found.seen.w));
        EXPECT_NEAR(found.shown.x * found.seen.x, expected.key, 1e-3 * expected.key);
        EXPECT_NEAR(found.shown.y, expected.white, 1e-3 * expected.white);
    }
}

TEST_F(Estimating, LeavesAFlatGreyThatGrey) {
    const auto shown_light = [&](float level) {
        return gpu.show(Light{{31, 9}, glm::vec3{level}}).display(50).y;
    };
    // Middle grey is 117.6 of 255 in sRGB: neither white, which L_white = L would make of it, nor black.
    EXPECT_NEAR(shown_light(0.18f), 255.0 * render::srgb_encoded(0.18), 0.6);
    for (const float level : {0.001f, 0.05f, 1.0f, 100.0f})
        EXPECT_NEAR(shown_light(level), 255.0 * render::srgb_encoded(0.18), 0.8) << level;
}

TEST_F(Estimating, OfBlackAndOfBrokenPicturesIsANumber) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float level : {0.0f, -1.0f, infinity, std::numeric_limits<float>::quiet_NaN(), 65504.0f}) {
        const auto found = gpu.show(Light{{12, 12}, glm::vec3{level}}).exposure.value();
        for (const float value : {found.seen.x, found.seen.z, found.seen.w, found.shown.x, found.shown.y}) {
            EXPECT_TRUE(std::isfinite(value)) << level;
            EXPECT_GT(value, 0.0f) << level;
        }
        const bool is_bright = level > 1.0f && std::isfinite(level);
        EXPECT_GE(found.seen.z, gpu.settings.exposure.delta);
        // Half a bin of the histogram is 1.2 %.
        EXPECT_NEAR(found.seen.w, is_bright ? level : gpu.settings.exposure.delta, 0.0125f * found.seen.w);
    }
}

TEST_F(Estimating, IsNotChangedByExposure) {
    const Light light{{16, 16}, glm::vec3{0.02f}};
    const Shown fixed = gpu.show(light);
    gpu.settings.exposure.mode = render::ExposureMode::automatic;
    EXPECT_EQ(gpu.show(light).bytes, fixed.bytes);
}

}  // namespace
