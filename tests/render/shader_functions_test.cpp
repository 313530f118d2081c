// Functions of the shader library against double-precision references written from the publications.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "assets/trace/reflectance.h"
#include "render/shader_harness.h"

namespace {

using rambla::tests::add;
using rambla::tests::Inputs;
using rambla::tests::Random;
using rambla::tests::ShaderHarness;

TEST(ShaderFunctions, OctahedralNormalsSurviveSixteenBits) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (const glm::vec3 axis : {glm::vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        add(inputs, {axis, 0});
        add(inputs, {-axis, 0});
    }
    for (int i = 0; i < 200000; ++i) {
        glm::vec3 n = random.direction();
        if (i % 10 == 0) n[i / 10 % 3] = 0.0f;  // edges of the octahedron
        add(inputs, {glm::normalize(n), 0});
    }
    const std::vector<glm::vec4> found =
        gpu.run("octahedral.glsl",
                "vec2 stored = round(clamp(unorm16_from_octahedral(octahedral_from_unit(a.xyz)), 0.0, 1.0) * "
                "65535.0) / 65535.0;\n"
                "result.xyz = unit_from_octahedral(octahedral_from_unorm16(stored));",
                inputs);
    double worst = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double angle = std::asin(
            std::min(1.0, glm::length(glm::cross(glm::dvec3{found[i]}, glm::dvec3{inputs[4 * i]}))));
        worst = std::max(worst, angle + (glm::dot(found[i], inputs[4 * i]) < 0.0f ? 1.0 : 0.0));
    }
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(glm::vec3{found[i]}, glm::vec3{inputs[4 * i]}) << "axes are exact";
    // Half a step of 1/32767 on both axes of the square is 2.16e-5. On the octahedron, where z = 1 − x − y
    // follows, it is up to √3 times as long; projected to the sphere from a face's middle, 1/√3 from the
    // centre, √3 times again.
    EXPECT_LT(worst, 3.0 * 2.16e-5 + 1e-6);
}

TEST(ShaderFunctions, OctahedralCoversTheSquareAndZero) {
    ShaderHarness gpu;
    Inputs inputs;
    add(inputs, {0, 0, 0, 0});
    add(inputs, {0, 0, -1, 0});
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        for (const float y : {-1.0f, 0.0f, 1.0f})
            add(inputs, {x, y, 0, 1});
    }
    const auto found = gpu.run("octahedral.glsl",
                               "result.xyz = a.w > 0.0 ? unit_from_octahedral(a.xy)"
                               " : unit_from_octahedral(octahedral_from_unit(a.xyz));",
                               inputs);
    EXPECT_EQ(glm::vec3{found[0]}, (glm::vec3{0, 0, 1})) << "no vector at all";
    EXPECT_EQ(glm::vec3{found[1]}, (glm::vec3{0, 0, -1}));
    for (const glm::vec4& n : found)
        EXPECT_NEAR(glm::length(glm::vec3{n}), 1.0f, 1e-6f);
}

TEST(ShaderFunctions, AttenuationFollowsTheWindowedInverseSquare) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (int i = 0; i < 20000; ++i) {
        const float radius = 0.05f + 50.0f * random();
        add(inputs, {radius * 1.2f * random(), radius, 0, 0});
    }
    const std::size_t regular = inputs.size() / 4;
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const glm::vec2 hard : {glm::vec2{0, 10},
                                 {0, 0},
                                 {1, 0},
                                 {10, 10},
                                 {infinity, 10},
                                 {nan, 10},
                                 {1e-30f, 1e-30f},
                                 {1e20f, 1e25f}}) {
        add(inputs, {hard, 0, 0});
    }
    const auto found = gpu.run("lights.glsl", "result.x = distance_attenuation(a.x, a.y);", inputs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_TRUE(std::isfinite(found[i].x)) << inputs[4 * i].x << " of " << inputs[4 * i].y;
        ASSERT_GE(found[i].x, 0.0f);
        if (i >= regular) continue;
        const double distance = inputs[4 * i].x, radius = inputs[4 * i].y;
        const double expected = rambla::assets::lamp_attenuation(distance, radius);
        // Near the rim, 1 − (d/r)⁴ keeps an absolute error of 3e-7, squared against 1/d².
        EXPECT_NEAR(found[i].x, expected, 1e-5 * expected + 2e-6 / std::pow(std::max(distance, 0.01), 2.0));
    }
}

TEST(ShaderFunctions, ConesHaveASmoothEdgeAndSurviveNoEdge) {
    ShaderHarness gpu;
    Inputs inputs;
    add(inputs, {1.0f, 0.9f, 0.8f, 0});     // on the axis
    add(inputs, {0.85f, 0.9f, 0.8f, 0});    // half way
    add(inputs, {0.79f, 0.9f, 0.8f, 0});    // outside
    add(inputs, {-1.0f, -1.0f, -2.0f, 0});  // a point light, straight behind
    add(inputs, {0.91f, 0.9f, 0.9f, 0});    // equal cones, inside
    add(inputs, {0.89f, 0.9f, 0.9f, 0});    // equal cones, outside
    const auto found = gpu.run("lights.glsl", "result.x = cone_attenuation(a.x, a.y, a.z);", inputs);
    EXPECT_EQ(found[0].x, 1.0f);
    EXPECT_NEAR(found[1].x, 0.25f, 1e-5f);  // the ramp's middle squared; float differences of 0.1
    EXPECT_EQ(found[2].x, 0.0f);
    EXPECT_EQ(found[3].x, 1.0f);
    EXPECT_EQ(found[4].x, 1.0f);
    EXPECT_EQ(found[5].x, 0.0f);
}

TEST(ShaderFunctions, UnprojectionInvertsProjection) {
    ShaderHarness gpu;
    Random random;
    const double near = 0.05, a_x = 1.2, a_y = 2.1, b_x = 0.3, b_y = -0.2;
    Inputs inputs;
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 20000; ++i) {
        const double z = -0.1 * std::pow(1e5, static_cast<double>(random()));  // 0.1 m … 10 km
        const glm::dvec3 p{z * (random() - 0.5f), z * (random() - 0.5f), z};
        const glm::dvec2 ndc{(a_x * p.x + b_x * p.z) / -p.z, (a_y * p.y + b_y * p.z) / -p.z};
        points.push_back(p);
        add(inputs, {0.5 * ndc.x + 0.5, 0.5 * ndc.y + 0.5, near / -p.z, 0}, {1 / a_x, 1 / a_y, b_x, b_y},
            {near, 0, 0, 0});
    }
    const std::size_t perspective = points.size();
    for (int i = 0; i < 5000; ++i) {  // orthographic: depth 1 at z = −1, 0 at z = −101
        const glm::dvec3 p{10.0 * random() - 5.0, 10.0 * random() - 5.0, -1.0 - 100.0 * random()};
        points.push_back(p);
        add(inputs, {0.5 * p.x * 0.2 + 0.5, 0.5 * p.y * 0.2 + 0.5, (p.z + 101.0) / 100.0, 0}, {5, 5, 0, 0},
            {0, 100, -101, 0});
    }
    const auto found = gpu.run("unproject.glsl", "result.xyz = view_position(a.xy, a.z, b, c);", inputs);
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Reversed float depth keeps its relative precision at any distance: 2⁻²⁴ in depth, in uv and in the
        // quotient. Orthographic depth is absolute: 2⁻²⁴ of the range of 100 m.
        const double tolerance = i < perspective ? 5e-7 * -points[i].z : 3e-5;
        EXPECT_NEAR(found[i].x, points[i].x, tolerance);
        EXPECT_NEAR(found[i].y, points[i].y, tolerance);
        EXPECT_NEAR(found[i].z, points[i].z, tolerance);
    }
}

TEST(ShaderFunctions, SrgbEncodingIsWithinHalfAStep) {
    ShaderHarness gpu;
    Inputs inputs;
    for (int i = 0; i <= 65536; ++i)
        add(inputs, glm::vec4{static_cast<float>(i) / 65536.0f});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    add(inputs, {-1.0f, 2.0f, std::numeric_limits<float>::infinity(), nan});
    const auto found = gpu.run("colour.glsl", "result.rgb = encode_srgb(a.rgb);", inputs);
    double worst = 0.0;
    float previous = -1.0f;
    for (std::size_t i = 0; i + 1 < found.size(); ++i) {
        const double x = inputs[4 * i].x;
        const double exact = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
        worst = std::max(worst, std::fabs(found[i].x - exact));
        // Where the two segments meet, the fit may step back by its own error.
        EXPECT_GE(found[i].x, previous - 0.012f / 255.0f);
        previous = found[i].x;
    }
    EXPECT_LT(worst * 255.0, 0.012);  // the fit's stated error; half a step would do
    EXPECT_EQ(found.front().x, 0.0f);
    EXPECT_EQ(found[65536].x, 1.0f);
    EXPECT_EQ(found.back().x, 0.0f);
    EXPECT_EQ(found.back().y, 1.0f);
    EXPECT_EQ(found.back().z, 1.0f);
}

TEST(ShaderFunctions, SrgbDecodingReturnsEveryByteAndIsWithinATenthOfAStep) {
    ShaderHarness gpu;
    Inputs inputs;
    for (int byte = 0; byte < 256; ++byte)
        add(inputs, {byte / 255.0f, 0, 0, 0});
    const std::vector<glm::vec4> found = gpu.run(
        "colour.glsl", "result.x = decode_srgb(a.xxx).x; result.y = encode_srgb(result.xxx).x;", inputs);
    for (int byte = 0; byte < 256; ++byte) {
        const double x = byte / 255.0;
        const double exact = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        const double slope = x <= 0.04045 ? 1.0 / 12.92 : 2.4 / 1.055 * std::pow((x + 0.055) / 1.055, 1.4);
        const glm::vec4& at = found[static_cast<std::size_t>(byte)];
        EXPECT_NEAR(at.x, exact, 0.1 * slope / 255.0) << byte;
        EXPECT_NEAR(at.y * 255.0, byte, 0.1);
    }
    EXPECT_EQ(found[0].x, 0.0f);
    EXPECT_NEAR(found[255].x, 1.0f, 1e-6f);
}

TEST(ShaderFunctions, StorableRadianceHoldsNothingNonFinite) {
    ShaderHarness gpu;
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Inputs inputs;
    for (const float x : {nan, infinity, -infinity, -1.0f, 0.0f, 1e-40f, 1.0f, 65504.0f, 1e30f})
        add(inputs, glm::vec4{x});
    const std::vector<float> expected{0, 60000, 0, 0, 0, 1e-40f, 1, 60000, 60000};
    const auto found = gpu.run("colour.glsl", "result.rgb = storable_radiance(a.rgb);", inputs);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(found[i].x, expected[i], 1e-38f)
            << "input " << inputs[4 * i].x;  // denormals may flush to 0
    }
}

TEST(ShaderFunctions, AmbientOfTheSkyIsItsCosineWeightedMean) {
    // Numerical integral of the very radiance function, over the hemisphere around each normal.
    ShaderHarness gpu;
    const std::string surroundings =
        "Surroundings s = Surroundings(vec3(0.1, 0.2, 0.5), vec3(0.6), vec3(0.15, 0.1, 0.05), 1.0);\n";
    Random random;
    for (const glm::vec3 n : {glm::vec3{0, 1, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, -1, 0},
                              glm::vec3{0.6f, 0.8f, 0.0f}, glm::vec3{0.8f, -0.6f, 0.0f}}) {
        Inputs inputs;
        constexpr int k_samples = 60000;
        for (int i = 0; i < k_samples; ++i) {
            const glm::vec3 sum = n + random.direction();  // cosine-distributed
            add(inputs, {glm::normalize(sum), 0});
        }
        glm::dvec3 mean{0.0};
        const auto radiance = gpu.run(
            "sky.glsl", surroundings + "result.rgb = a.y > 0.0 ? upper_sky(s, a.y) : s.ground;", inputs);
        for (const glm::vec4& r : radiance)
            mean += glm::dvec3{r} / static_cast<double>(k_samples);
        Inputs normal;
        add(normal, {n, 0});
        const glm::vec3 found{
            gpu.run("sky.glsl", surroundings + "result.rgb = diffuse_ambient(s, a.xyz);", normal)[0]};
        for (int channel = 0; channel < 3; ++channel) {
            // The mean of √height is interpolated between up and sideways, and below the horizon kept: within
            // 2 % of the sky's range; sampling adds a standard error of 0.1 %.
            EXPECT_NEAR(found[channel], mean[channel], 0.02 * 0.6)
                << n.x << " " << n.y << " channel " << channel;
        }
    }
}

}  // namespace
