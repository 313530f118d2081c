// The shaders' reflectance functions against double-precision references written from the publications.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "assets/trace/reflectance.h"
#include "render/shader_harness.h"

namespace {

namespace assets = rambla::assets;
using rambla::tests::add;
using rambla::tests::Inputs;
using rambla::tests::Random;
using rambla::tests::ShaderHarness;

constexpr double k_pi = 3.14159265358979323846;

assets::ReflectingPoint point_of(const glm::vec4* inputs) {
    return {.normal = glm::dvec3{inputs[0]},
            .base_colour = glm::dvec3{inputs[3]},
            .roughness = inputs[0].w,
            .metalness = inputs[1].w};
}

const char* const k_reflected =
    "Surface s = make_surface(a.xyz, d.rgb, a.w, b.w, 1.0);\n"
    "result.rgb = reflected(s, b.xyz, c.xyz);";

TEST(Brdf, EqualsTheReference) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    constexpr int k_samples = 100000;
    for (int i = 0; i < k_samples; ++i) {
        const glm::vec3 n = random.direction();
        glm::vec3 v = random.direction();
        if (glm::dot(n, v) < 0.0f) v = -v;
        add(inputs, {n, random()}, {v, random()}, {random.direction(), 0.0f},
            {random(), random(), random(), 0.0f});
    }
    const std::vector<glm::vec4> found = gpu.run("brdf.glsl", k_reflected, inputs);
    double worst = 0.0;
    for (int i = 0; i < k_samples; ++i) {
        const glm::vec4* in = &inputs[4 * static_cast<std::size_t>(i)];
        const glm::dvec3 expected = assets::reflected_ggx(point_of(in), glm::dvec3{in[1]}, glm::dvec3{in[2]});
        for (int channel = 0; channel < 3; ++channel) {
            const double error = std::fabs(found[static_cast<std::size_t>(i)][channel] - expected[channel]);
            worst = std::max(worst, error / (expected[channel] + 1e-2));
        }
    }
    // Float inputs are unit vectors to 6e-8; the sharpest lobe (α = 0.002) turns that into 6e-8/α = 3e-5
    // relative to the lobe's width, squared and inverted twice: 4e-4 covers it.
    EXPECT_LT(worst, 4e-4);
}

TEST(Brdf, TheCheaperGradesEqualTheirReferences) {
    Random random;
    Inputs inputs;
    constexpr int k_samples = 100000;
    for (int i = 0; i < k_samples; ++i) {
        const glm::vec3 n = random.direction();
        glm::vec3 v = random.direction();
        if (glm::dot(n, v) < 0.0f) v = -v;
        // From 0.3 on: sharper lobes raise the cosine's rounding of 6e-8 to the power of 2/α² = 247.
        add(inputs, {n, 0.3f + 0.7f * random()}, {v, random()}, {random.direction(), 0.0f},
            {random(), random(), random(), 0.0f});
    }
    const auto worst_against = [&](const char* grade, auto reference) {
        ShaderHarness gpu;
        const std::string text = std::string{"Surface s = make_surface(a.xyz, d.rgb, a.w, b.w, 1.0);\n"} +
                                 "float n_dot_l = dot(s.normal, c.xyz);\n" +
                                 "result.rgb = n_dot_l <= 0.0 ? vec3(0.0) : " + grade + ";";
        const std::vector<glm::vec4> found = gpu.run("brdf.glsl", text, inputs);
        double worst = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const glm::vec4* in = &inputs[4 * i];
            const glm::dvec3 expected = reference(point_of(in), glm::dvec3{in[1]}, glm::dvec3{in[2]});
            for (int channel = 0; channel < 3; ++channel)
                worst = std::max(
                    worst, std::fabs(found[i][channel] - expected[channel]) / (expected[channel] + 1e-2));
        }
        return worst;
    };
    // log2 and exp2 of the software rasteriser are polynomials: 1e-5 of a logarithm times an exponent of 247.
    EXPECT_LT(worst_against("reflected_blinn(s, b.xyz, c.xyz, n_dot_l)", assets::reflected_blinn), 3e-3);
    // A handful of roundings of 6e-8, relative to 1e-2 at least.
    EXPECT_LT(worst_against("reflected_lambert(s, n_dot_l)", assets::reflected_lambert), 3e-6);
}

TEST(Brdf, IsFiniteInHardCases) {
    ShaderHarness gpu;
    const glm::vec3 n{0, 0, 1};
    Inputs inputs;
    const std::vector<glm::vec3> directions{{0, 0, 1},
                                            {0, 0, -1},
                                            {1, 0, 0},
                                            {-1, 0, 0},
                                            glm::normalize(glm::vec3{1, 0, 1e-7f}),
                                            glm::normalize(glm::vec3{-1, 0, 1e-7f}),
                                            glm::normalize(glm::vec3{1, 0, -1e-4f}),
                                            {0, 0.6f, 0.8f}};
    for (const float roughness : {0.0f, 1e-6f, 0.5f, 1.0f}) {
        for (const float metalness : {0.0f, 1.0f}) {
            for (const glm::vec3 v : directions) {
                for (const glm::vec3 l : directions)
                    add(inputs, {n, roughness}, {v, metalness}, {l, 0}, {1, 1, 1, 0});
            }
        }
    }
    const std::vector<glm::vec4> found = gpu.run("brdf.glsl", k_reflected, inputs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_TRUE(std::isfinite(found[i][channel])) << "case " << i;
            EXPECT_GE(found[i][channel], 0.0f) << "case " << i;
        }
    }
}

TEST(Brdf, AWhiteMetalReflectsNoMoreThanItReceives) {
    // Monte Carlo over the hemisphere: ∫ f·cos dω ≤ 1. Uniform directions, weight 2π.
    ShaderHarness gpu;
    Random random;
    for (const float roughness : {0.5f, 0.7f, 1.0f}) {
        for (const float cos_v : {0.2f, 0.7f, 1.0f}) {
            Inputs inputs;
            constexpr int k_samples = 40000;
            for (int i = 0; i < k_samples; ++i) {
                glm::vec3 l = random.direction();
                l.z = std::fabs(l.z);
                add(inputs, {0, 0, 1, roughness}, {std::sqrt(1 - cos_v * cos_v), 0, cos_v, 1.0f}, {l, 0},
                    {1, 1, 1, 0});
            }
            double sum = 0.0;
            for (const glm::vec4& f : gpu.run("brdf.glsl", k_reflected, inputs))
                sum += f.x;
            const double albedo = sum * 2.0 * k_pi / k_samples;
            // 3 standard errors of 40 000 samples of this lobe stay below 0.03.
            EXPECT_LT(albedo, 1.03) << "roughness " << roughness << " cos " << cos_v;
            // Light scattered more than once between rough facets is lost. With α = 1, seen head-on, the
            // integral is elementary: ∫ μ/(μ + 1) dμ = 1 − ln 2.
            if (roughness == 1.0f && cos_v == 1.0f) {
                EXPECT_NEAR(albedo, 1.0 - std::log(2.0), 0.01);
            }
        }
    }
}

TEST(Brdf, EnvironmentReflectanceFollowsTheSplitSumIntegral) {
    ShaderHarness gpu;
    Random random;
    for (const float roughness : {0.2f, 0.5f, 0.9f}) {
        for (const double cos_v : {0.15, 0.5, 0.95}) {
            // Reference: ∫ F·D·G/(4 N·V) dω over light directions, by sampling half vectors of GGX (Walter
            // 2007).
            const double a = roughness * roughness;
            const glm::dvec3 v{std::sqrt(1.0 - cos_v * cos_v), 0.0, cos_v};
            double sum = 0.0;
            constexpr int k_samples = 20000;
            for (int i = 0; i < k_samples; ++i) {
                const double u = random(), phi = 2.0 * k_pi * random();
                const double cos_h = std::sqrt((1.0 - u) / (1.0 + (a * a - 1.0) * u));
                const double sin_h = std::sqrt(1.0 - cos_h * cos_h);
                const glm::dvec3 h{sin_h * std::cos(phi), sin_h * std::sin(phi), cos_h};
                const glm::dvec3 l = 2.0 * glm::dot(v, h) * h - v;
                if (l.z <= 0.0) continue;
                const auto lambda = [&](double c) {
                    return 0.5 * (std::sqrt(1.0 + a * a * (1.0 / (c * c) - 1.0)) - 1.0);
                };
                const double g = 1.0 / (1.0 + lambda(l.z) + lambda(cos_v));
                const double f = 0.04 + 0.96 * std::pow(1.0 - glm::dot(v, h), 5.0);
                sum += f * g * glm::dot(v, h) / (cos_h * cos_v);
            }
            Inputs inputs;
            add(inputs, {roughness, cos_v, 0, 0});
            const float found =
                gpu.run("brdf.glsl", "result.x = environment_reflectance(vec3(0.04), 1.0, a.x, a.y).x;",
                        inputs)[0]
                    .x;
            // The published fit is for a phone's GPU and another masking function: off by 0.064 at grazing
            // angles.
            EXPECT_NEAR(found, sum / k_samples, cos_v < 0.3 ? 0.07 : 0.015)
                << "roughness " << roughness << " cos " << cos_v;
        }
    }
}

}  // namespace
