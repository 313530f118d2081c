// The functions of temporal.glsl, on the GPU.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/shader_harness.h"

namespace {

using namespace rambla;
using tests::add;
using tests::Inputs;
using tests::Random;
using tests::ShaderHarness;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinite = std::numeric_limits<float>::infinity();

TEST(TemporalFunctions, ColoursComeBackFromTheirCompressedForm) {
    Inputs inputs;
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const float scale = std::exp2(-14.0f + 29.0f * random());
        add(inputs, {scale * random(), scale * random(), scale * random(), 0});
    }
    const auto outputs =
        ShaderHarness{}.run("temporal.glsl", "result.rgb = expanded(compressed(a.rgb));", inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const glm::vec3 colour{inputs[4 * i]};
        const float largest = std::max({colour.x, colour.y, colour.z});
        // What is left of 1 after luma/(1 + luma) has lost log2(luma) bits of 23.
        const float tolerance = largest * (1e-5f + 2.5e-7f * largest);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(outputs[i][channel], colour[channel], tolerance) << i;
    }
}

TEST(TemporalFunctions, WhateverIsExpandedCanBeStored) {
    Inputs inputs;
    for (const float y : {-2.0f, 0.0f, 0.5f, 1.0f, 1.5f, 1e20f, k_nan, k_infinite})
        for (const float c : {-2.0f, 0.0f, 1.0f, k_nan})
            add(inputs, {y, c, -c, 0});
    for (const glm::vec4& colour :
         ShaderHarness{}.run("temporal.glsl", "result.rgb = expanded(a.rgb);", inputs)) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(colour[channel], 0.0f);
            EXPECT_LE(colour[channel], 60000.0f);
        }
    }
}

TEST(TemporalFunctions, OnlyNumbersAreTakenFromThePast) {
    Inputs inputs;
    const std::vector<float> bad{k_nan, k_infinite, -k_infinite};
    for (const float value : bad)
        for (int channel = 0; channel < 3; ++channel) {
            glm::vec4 colour{0.5f, 0.5f, 0.5f, 0.0f};
            colour[channel] = value;
            add(inputs, colour);
        }
    const std::size_t rejected = inputs.size() / 4;
    for (const float value : {0.0f, 1e-7f, 1.0f, 65504.0f})
        for (int channel = 0; channel < 3; ++channel) {
            glm::vec4 colour{0.5f * value};
            colour[channel] = value;
            add(inputs, colour);
        }
    const auto outputs =
        ShaderHarness{}.run("temporal.glsl", "result.x = is_colour(compressed(a.rgb)) ? 1.0 : 0.0;", inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i)
        EXPECT_EQ(outputs[i].x, i < rejected ? 0.0f : 1.0f) << i;
}

TEST(TemporalFunctions, DepthAndNumbersShareAHalfFloat) {
    Inputs inputs;
    for (int exponent = 0; exponent < 28; ++exponent)
        for (const float mantissa : {1.0f, 0.95f, 0.77f, 0.51f})
            for (const float pictures : {0.0f, 1.0f, 7.0f, 40.0f})
                for (const float misses : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f})
                    add(inputs, {mantissa * std::exp2(static_cast<float>(-exponent)), pictures, misses,
                                 exponent % 2});
    add(inputs, {0, 5, 1, 1});
    const auto outputs = ShaderHarness{}.run(
        "temporal.glsl",
        "Kept given = Kept(a.x, uint(a.y), uint(a.z), a.w > 0.0);"
        "Kept k = kept(unpackHalf2x16(packHalf2x16(vec2(stored(given), 0.0))).x);"
        "result = vec4(k.depth, float(k.pictures), float(k.misses), k.moved ? 1.0 : 0.0);",
        inputs);
    const auto hidden =
        ShaderHarness{}.run("temporal.glsl",
                            "Kept k = kept(stored(Kept(a.x, 1u, 0u, false)));"
                            "result = vec4(was_hidden(k.depth, a.x, 0.0, k_kept_depth_slack), "
                            "was_hidden(k.depth, 0.9 * a.x, 0.0, k_kept_depth_slack),"
                            "was_hidden(k.depth, 0.9 * a.x, 0.2 * a.x, k_kept_depth_slack), 0.0);",
                            inputs);
    constexpr float k_least = 1.0f / (16384.0f * 16384.0f);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const glm::vec4 given = inputs[4 * i];
        const float depth = std::max(given.x, k_least);
        EXPECT_LE(outputs[i].x, depth * 1.001f) << "a depth that is too small hides nothing" << i;
        EXPECT_GE(outputs[i].x, depth * (1.0f - 1.0f / 32.0f - 1.0f / 1024.0f)) << i;
        EXPECT_EQ(outputs[i].y, std::min(given.y, 7.0f)) << i;
        EXPECT_EQ(outputs[i].z, std::min(given.z, 3.0f)) << i;
        EXPECT_EQ(outputs[i].w, given.w) << i;
        EXPECT_EQ(hidden[i].x, 0.0f) << "what is at the same depth is the same" << i;
        // A tenth nearer, of which a thirtieth may have been cut off and another one is allowed for.
        EXPECT_EQ(hidden[i].y, given.x > 1.2f * k_least ? 1.0f : 0.0f) << i;
        EXPECT_EQ(hidden[i].z, 0.0f) << "on a slope as steep" << i;
    }
}

TEST(TemporalFunctions, DepthsThatAreNoNumbersAreUnknown) {
    Inputs inputs;
    add(inputs, {k_nan, 0, 0, 0});
    add(inputs, {k_infinite, 0, 0, 0});
    add(inputs, {0, 0, 0, 0});
    for (const glm::vec4& found : ShaderHarness{}.run(
             "temporal.glsl",
             "Kept k = kept(a.x); result = vec4(k.depth, float(k.pictures), float(k.misses), k.moved);",
             inputs))
        EXPECT_EQ(found, glm::vec4(0.0f));
    const auto hidden = ShaderHarness{}.run(
        "temporal.glsl", "result.x = float(was_hidden(a.x, 0.5, 0.0, 0.1));", {inputs.data(), 4});
    EXPECT_EQ(hidden[0].x, 1.0f) << "what is no number is not known to have been seen";
}

TEST(TemporalFunctions, ThePastCountsLessTheMoreItsResamplingBlurs) {
    Inputs inputs;
    add(inputs, {0, 0, 0, 0});
    add(inputs, {0.5f, 0, 0, 0});
    add(inputs, {0, 0.25f, 0, 0});
    add(inputs, {0, 0.99f, 0, 0});
    const auto shares = ShaderHarness{}.run("temporal.glsl", "result.x = share_against_blur(a.xy);", inputs);
    EXPECT_EQ(shares[0].x, 0.0f);
    EXPECT_FLOAT_EQ(shares[1].x, 0.2f);
    EXPECT_FLOAT_EQ(shares[2].x, 0.15f);
    EXPECT_LT(shares[3].x, 0.01f);
}

TEST(TemporalFunctions, TheCubicPassesThroughItsSamplesAndKeepsStraightLines) {
    Inputs inputs;
    for (int i = 0; i <= 64; ++i)
        add(inputs, {static_cast<float>(i) / 64.0f, 0, 0, 0});
    const auto weights = ShaderHarness{}.run("temporal.glsl", "result = catmull_rom(a.x);", inputs);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const glm::vec4 w = weights[i];
        const float t = inputs[4 * i].x;
        EXPECT_NEAR(w.x + w.y + w.z + w.w, 1.0f, 1e-6f);
        EXPECT_NEAR(-w.x + w.z + 2.0f * w.w, t, 1e-6f) << "the mean place of the samples";
    }
    EXPECT_EQ(weights.front(), glm::vec4(0, 1, 0, 0));
    EXPECT_EQ(weights.back(), glm::vec4(0, 0, 1, 0));
}

}  // namespace
