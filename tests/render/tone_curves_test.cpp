// Tone curves, and what follows them, against double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/display_harness.h"
#include "render/post/picture_reference.h"
#include "render/shader_harness.h"

namespace {

using namespace rambla;
using render::ToneCurve;
using render::ToneOn;
using tests::add;
using tests::DisplayHarness;
using tests::Inputs;
using tests::Light;
using tests::Random;
using tests::ShaderHarness;
using tests::Shown;

constexpr double k_wanted = 1.0 / 1024.0;

const char* name_of(std::size_t curve) {
    return render::k_tone_curves[curve].data();
}

std::string call(std::size_t curve) {
    return std::string{"result.rgb = tone_"}.append(name_of(curve)).append("(a.rgb, a.w);");
}

/// Scene light that the curve shows as display white; 0: none does.
double white_of(ToneCurve curve, double parameter) {
    switch (curve) {
        case ToneCurve::extended:
        case ToneCurve::filmic:
            return parameter;
        case ToneCurve::aces:
            return 7.25;
        case ToneCurve::agx:
            return 0.18 * std::exp2(6.5);
        case ToneCurve::reinhard:
            break;
    }
    return 0.0;
}

/// Greys from 0 over what hardly is a float to more than exposed half floats can be.
Inputs greys(float white) {
    Inputs inputs;
    for (const float x : {0.0f, 1e-45f, 1e-40f, 1.2e-38f, 1e-20f})
        add(inputs, glm::vec4{glm::vec3{x}, white});
    for (int i = 0; i < 4000; ++i)
        add(inputs, glm::vec4{glm::vec3{static_cast<float>(1e-8 * std::pow(1e16, i / 3999.0))}, white});
    return inputs;
}

TEST(ToneCurves, EqualTheirFormulasOnGreysAndRise) {
    ShaderHarness gpu;
    for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
        for (const float white : {0.25f, 1.0f, 3.0f, 64.0f}) {
            const Inputs inputs = greys(white);
            const auto found = gpu.run("tone_curves.glsl", call(curve), inputs);
            EXPECT_NEAR(found[0].x, 0.0f, 1e-12f) << name_of(curve) << ", whose two halves cancel";
            float previous = 0.0f;
            for (std::size_t i = 0; i < found.size(); ++i) {
                const glm::dvec3 scene{inputs[4 * i]};
                const double expected = render::tone_mapped(scene, static_cast<ToneCurve>(curve),
                                                            ToneOn::channels, static_cast<double>(white))
                                            .x;
                ASSERT_NEAR(found[i].x, expected, k_wanted) << name_of(curve) << " of " << scene.x;
                ASSERT_GE(found[i].x, previous - 1e-6f) << name_of(curve) << " falls at " << scene.x;
                ASSERT_LE(found[i].x, 1.0f + 1e-6f) << name_of(curve) << " of " << scene.x;
                previous = std::max(previous, found[i].x);
            }
        }
    }
}

TEST(ToneCurves, EqualTheirFormulasOnColours) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (int i = 0; i < 3000; ++i) {
        const float level = 1e-4f * std::pow(1e7f, random());
        add(inputs, glm::vec4{level * glm::vec3{random(), random(), random()}, 3.0f});
    }
    for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
        const auto found = gpu.run("tone_curves.glsl", call(curve), inputs);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const glm::dvec3 expected = render::tone_mapped(
                glm::dvec3{inputs[4 * i]}, static_cast<ToneCurve>(curve), ToneOn::channels, 3.0);
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(found[i][channel], expected[channel], k_wanted) << name_of(curve);
        }
    }
}

TEST(ToneCurves, ShowTheirWhiteAsWhite) {
    ShaderHarness gpu;
    for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
        for (const float parameter : {0.25f, 1.0f, 3.0f, 64.0f}) {
            const double white = white_of(static_cast<ToneCurve>(curve), static_cast<double>(parameter));
            if (white == 0.0) continue;
            Inputs inputs;
            add(inputs, glm::vec4{glm::vec3{static_cast<float>(white)}, parameter});
            add(inputs, glm::vec4{glm::vec3{static_cast<float>(0.8 * white)}, parameter});
            const auto found = gpu.run("tone_curves.glsl", call(curve), inputs);
            EXPECT_NEAR(found[0].x, 1.0f, 1e-4f) << name_of(curve) << " " << parameter;
            EXPECT_LT(found[1].x, 1.0f - 1e-4f) << name_of(curve) << " is white too early";
        }
    }
}

TEST(ToneCurves, AgxKeepsMiddleGreyAndLeadsBrightColoursToWhite) {
    ShaderHarness gpu;
    Inputs inputs;
    add(inputs, glm::vec4{glm::vec3{0.18f}, 0.0f});
    add(inputs, {0.2f, 0.0f, 0.0f, 0.0f});
    add(inputs, {2000.0f, 20.0f, 0.0f, 0.0f});
    const auto found = gpu.run("tone_curves.glsl", call(static_cast<std::size_t>(ToneCurve::agx)), inputs);
    EXPECT_NEAR(found[0].x, 0.18f, k_wanted);
    EXPECT_GT(found[1].x, 5.0f * found[1].y) << "still red";
    EXPECT_GT(std::min(found[2].y, found[2].z), 0.9f) << "white";
}

TEST(ToneOnLuminance, GivesColoursTheLuminanceOfTheCurveAndKeepsTheirHue) {
    DisplayHarness gpu;
    gpu.settings.exposure.mode = render::ExposureMode::fixed;
    gpu.settings.tone.on = ToneOn::luminance;
    Random random;
    for (std::size_t curve = 0; curve < render::k_tone_curves.size(); ++curve) {
        gpu.settings.tone.curve = static_cast<ToneCurve>(curve);
        Light light{{40, 40}, glm::vec3{0.0f}};
        for (glm::vec3& texel : light.texels)
            texel = 1e-3f * std::pow(1e5f, random()) * glm::vec3{random(), random(), random()};
        const Shown shown = gpu.show(light);
        for (std::size_t i = 0; i < light.texels.size(); ++i) {
            const glm::dvec3 expected = render::tone_mapped(glm::dvec3{light.texels[i]},
                                                            gpu.settings.tone.curve, ToneOn::luminance, 3.0);
            for (int channel = 0; channel < 3; ++channel)
                // A byte rounds by half a step, the encoding is off by 0.012 of one, and AgX by what its
                // matrix does to greys, see below.
                ASSERT_NEAR(shown.display(i)[channel], 255.0 * render::srgb_encoded(expected[channel]), 0.65)
                    << name_of(curve);
        }
    }
}

TEST(ToneCurves, OfTheReferencePassThroughKnownValues) {
    // By hand, from the formulas of the publications: what tests hold the GPU against shall itself stand.
    const auto grey = [](double x, ToneCurve curve, double white) {
        return render::tone_mapped(glm::dvec3{x}, curve, ToneOn::channels, white).x;
    };
    EXPECT_DOUBLE_EQ(grey(1.0, ToneCurve::reinhard, 3.0), 0.5);
    EXPECT_DOUBLE_EQ(grey(1.0, ToneCurve::extended, 2.0), 0.625);
    EXPECT_DOUBLE_EQ(grey(2.0, ToneCurve::extended, 2.0), 1.0);
    EXPECT_NEAR(grey(0.5, ToneCurve::extended, 1.0), 0.5, 1e-15);
    EXPECT_NEAR(grey(1.0, ToneCurve::aces, 3.0), 2.54 / 3.16, 1e-12);
    // Hable's curve at 4 and 12: (2.6 + 0.2 + 0.004)/(2.4 + 2 + 0.06) − 1/15 and so on.
    const double at_4 = (2.4 + 0.2 + 0.004) / (2.4 + 2.0 + 0.06) - 0.02 / 0.30;
    const double at_12 = (21.6 + 0.6 + 0.004) / (21.6 + 6.0 + 0.06) - 0.02 / 0.30;
    EXPECT_NEAR(grey(1.0, ToneCurve::filmic, 3.0), at_4 / at_12, 1e-12);
    // The published matrix keeps greys within 1.4e-4, and so does its inverse; gamma doubles that.
    EXPECT_NEAR(grey(0.18, ToneCurve::agx, 3.0), 0.18, 6e-4);
    EXPECT_NEAR(grey(0.18 * std::exp2(6.5), ToneCurve::agx, 3.0), 1.0, 6e-4);
    EXPECT_NEAR(grey(0.18 * std::exp2(-10.0), ToneCurve::agx, 3.0), 0.0, 6e-4);
}

/// What is made of encoded light after the curve.
struct AfterTheCurve : testing::Test {
    AfterTheCurve() {
        gpu.settings.exposure.mode = render::ExposureMode::fixed;
        gpu.settings.tone = {.curve = ToneCurve::extended, .white = 1.0f, .dither = false};  // the identity
    }
    int shown(float level) { return gpu.show(Light{{4, 4}, glm::vec3{level}}).display(5).y; }
    DisplayHarness gpu;
};

TEST_F(AfterTheCurve, GammaAndBrightnessDoWhatTheySay) {
    EXPECT_NEAR(shown(0.2f), 255.0 * render::srgb_encoded(0.2), 0.6);
    gpu.settings.tone.brightness = 2.0f;
    EXPECT_NEAR(shown(0.2f), 255.0 * render::srgb_encoded(0.4), 0.6);
    EXPECT_EQ(shown(0.9f), 255);
    gpu.settings.tone.brightness = 1.0f;
    gpu.settings.tone.gamma = 2.0f;
    EXPECT_NEAR(shown(0.2f), 255.0 * std::sqrt(render::srgb_encoded(0.2)), 0.7);
    EXPECT_EQ(shown(0.0f), 0);
    EXPECT_EQ(shown(1.0f), 255);
}

TEST_F(AfterTheCurve, DitherKeepsTheMeanAndIsOffWhenItIsOff) {
    const Light light{{48, 48}, glm::vec3{0.2f}};
    const Shown plain = gpu.show(light);
    for (std::size_t i = 1; i < light.texels.size(); ++i)
        ASSERT_EQ(plain.display(i), plain.display(0));
    gpu.settings.tone.dither = true;
    const Shown dithered = gpu.show(light);
    double mean = 0.0;
    for (std::size_t i = 0; i < light.texels.size(); ++i)
        mean += dithered.display(i).y / static_cast<double>(light.texels.size());
    // 2304 pixels of nearly uniform noise; the encoding's own error is 0.012.
    EXPECT_NEAR(mean, 255.0 * render::srgb_encoded(0.2), 0.1);
}

TEST_F(AfterTheCurve, NightSightTurnsDarkRedsDarkAndLeavesWhatIsBright) {
    gpu.settings.tone.blue_shift = 1.0f;
    gpu.settings.tone.brightness = 4.0f;
    Light light{{3, 1}, glm::vec3{0.0f}};
    light.texels = {{4e-4f, 4e-5f, 4e-5f}, glm::vec3{2e-4f}, {0.24f, 0.2f, 0.2f}};
    const Shown seen = gpu.show(light);
    gpu.settings.tone.blue_shift = 0.0f;
    const Shown plain = gpu.show(light);
    EXPECT_LT(seen.display(0).x, plain.display(0).x);
    EXPECT_GT(seen.display(1).z, seen.display(1).x) << "blue";
    EXPECT_EQ(seen.display(2), plain.display(2)) << "cones alone";
}

TEST_F(AfterTheCurve, NightSightKnowsHowDarkThingsAreAtAnyExposure) {
    gpu.settings.tone.blue_shift = 1.0f;
    gpu.settings.tone.brightness = 4.0f;
    const auto blue_by_red = [&] {
        const glm::ivec3 shown = gpu.show(Light{{4, 4}, glm::vec3{4e-3f}}).display(5);
        const auto linear = [](int byte) {
            return std::pow((byte / 255.0 + 0.055) / 1.055, 2.4);
        };
        return linear(shown.z) / linear(shown.x);
    };
    const double fixed = blue_by_red();
    EXPECT_GT(fixed, 1.5);
    gpu.settings.exposure = {.mode = render::ExposureMode::automatic, .key = 0.032f, .strength = 1.0f};
    // A byte around 33 is half a step off, 2 % of linear light; here three stops brighter.
    EXPECT_NEAR(blue_by_red(), fixed, 0.05 * fixed);
}

}  // namespace
