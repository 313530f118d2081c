// Which light glows, and that nothing is drawn where nothing is bright.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "render/bloom_bench.h"
#include "render/shader_harness.h"
#include "render/support.h"

namespace {

using namespace rambla;
using render::BloomMethod;
using tests::add;
using tests::BloomBench;
using tests::fill;
using tests::Inputs;
using tests::k_methods;
using tests::Light;
using tests::name_of;

constexpr double k_default_threshold = 1.5;

TEST(BloomBright, FollowsTheThresholdAndItsSoftKnee) {
    tests::ShaderHarness gpu;
    tests::Random random;
    Inputs inputs;
    for (int i = 0; i < 20000; ++i) {
        const float threshold = 4.0f * random(), knee = threshold * random();
        add(inputs, {2.0f * threshold * random() * (i % 3 == 0 ? 1000.0f : 1.0f), threshold - knee,
                     threshold + knee, threshold});
    }
    const auto found = gpu.run("bloom_bright.glsl", "result.x = glowing_luminance(a.x, a.yzw);", inputs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::dvec4 in{inputs[4 * i]};
        const double above = in.x - in.y, knee = 0.5 * (in.z - in.y);
        const double expected = above <= 0.0   ? 0.0
                                : in.x >= in.z ? in.x - in.w
                                               : above * above / (4.0 * knee);
        // Three roundings of numbers up to 8000.
        ASSERT_NEAR(found[i].x, expected, 1e-6 * in.x + 1e-6) << in.x << " at " << in.w;
    }
}

TEST(BloomBright, KeepsColoursAndMakesNumbersOfWhatIsNone) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float denormal = std::numeric_limits<float>::denorm_min();
    tests::ShaderHarness gpu;
    Inputs inputs;
    add(inputs, {8.0f, 4.0f, 2.0f, 0});
    for (const glm::vec3 hard :
         {glm::vec3{nan}, glm::vec3{-inf}, glm::vec3{-5.0f}, glm::vec3{denormal}, glm::vec3{0.0f}})
        add(inputs, {hard, 0});
    add(inputs, {nan, 8.0f, -8.0f, 0});
    add(inputs, {inf, inf, inf, 0});
    add(inputs, {65504.0f, 65504.0f, 65504.0f, 0});
    const auto found = gpu.run("bloom_bright.glsl",
                               "result.xyz = glowing_light(a.xyz, vec3(0.75, 2.25, 1.5));\n"
                               "result.w = glowing_light(a.xyz, vec3(0.0)).g;",
                               inputs);
    const double luminance = 0.2126 * 8 + 0.7152 * 4 + 0.0722 * 2;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[0][c], inputs[0][c] * (luminance - 1.5) / luminance, 1e-5);
    for (std::size_t i = 1; i < 6; ++i)
        EXPECT_EQ(glm::vec3{found[i]}, glm::vec3{0.0f}) << i;
    for (std::size_t i = 1; i < 6; ++i)
        EXPECT_LE(found[i].w, denormal) << i;
    EXPECT_EQ(found[6].x, 0.0f);
    EXPECT_EQ(found[6].z, 0.0f);
    EXPECT_GT(found[6].y, 1.0f);
    for (const std::size_t i : {7u, 8u}) {
        EXPECT_TRUE(std::isfinite(found[i].x));
        EXPECT_GT(found[i].x, 50000.0f);
    }
}

TEST(Bloom, DrawsNothingWhereNothingIsBright) {
    BloomBench bench;
    // Just below where the knee begins: 1.5 − 0.75.
    const Light scene{{300, 200}, glm::vec3{0.7499f}};
    for (const BloomMethod method : k_methods) {
        bench.settings.bloom.method = method;
        const Light glowing = bench.bloom(scene);
        EXPECT_EQ(bench.fragments(), 0u) << name_of(method);
        EXPECT_EQ(glowing.texels, scene.texels) << name_of(method);
    }
    Light lamp = scene;
    lamp.at(17, 120) = glm::vec3{20.0f};
    bench.settings.bloom.method = BloomMethod::pyramid;
    static_cast<void>(bench.bloom(lamp));
    EXPECT_GT(bench.fragments(), 0u) << "the count counts";
    EXPECT_EQ(bench.bloom(scene).texels, scene.texels) << "what was drawn before is forgotten";
    EXPECT_EQ(bench.fragments(), 0u);
}

TEST(Bloom, IsTheSameWhereAllTilesAreBright) {
    BloomBench bench;
    Light scene{{320, 256}};
    fill(scene, {100, 90}, {130, 99}, {300.0f, 200.0f, 100.0f});
    Light everywhere = scene;
    for (std::uint32_t y = 5; y < 256; y += 64)
        for (std::uint32_t x = 5; x < 320; x += 64)
            everywhere.at(x, y) = glm::vec3{0.7502f};  // glows by 1e-8, which its tile does not know
    for (const BloomMethod method : k_methods) {
        bench.settings.bloom.method = method;
        const Light few = bench.bloom(scene);
        const GLuint64 fragments = bench.fragments();
        const Light all = bench.bloom(everywhere);
        EXPECT_GT(bench.fragments(), fragments) << name_of(method);
        for (std::size_t i = 0; i < few.texels.size(); ++i)
            ASSERT_NEAR(few.texels[i].x - scene.texels[i].x, all.texels[i].x - everywhere.texels[i].x, 1e-6)
                << name_of(method) << " pixel " << i;
    }
}

TEST(Bloom, TakesAnUnsoundPixelForABlackOne) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    BloomBench bench;
    Light scene{{200, 160}};
    fill(scene, {90, 60}, {110, 80}, glm::vec3{50.0f});
    for (const BloomMethod method : k_methods) {
        bench.settings.bloom.method = method;
        for (const bool fireflies : {false, true}) {
            bench.settings.bloom.fireflies = fireflies;
            for (const float unsound : {nan, -inf, -65504.0f, 1e-8f}) {
                Light black = scene, hurt = scene;
                for (const glm::uvec2 at : {glm::uvec2{95, 70}, {0, 0}, {199, 159}, {20, 90}}) {
                    black.at(at.x, at.y) = glm::vec3{0.0f};
                    hurt.at(at.x, at.y) = glm::vec3{unsound};
                }
                const Light expected = bench.bloom(black, GL_RGBA16F), found = bench.bloom(hurt, GL_RGBA16F);
                int different = 0;
                for (std::size_t i = 0; i < found.texels.size(); ++i)
                    different += found.texels[i] == expected.texels[i] ? 0 : 1;
                EXPECT_LE(different, 4) << name_of(method) << " " << unsound << ": itself, and nothing else";
            }
        }
        Light infinite = scene;
        infinite.at(20, 90) = glm::vec3{inf};
        const Light found = bench.bloom(infinite, GL_RGBA16F);
        for (std::size_t i = 0; i < found.texels.size(); ++i)
            ASSERT_TRUE(std::isfinite(found.texels[i].x) || i == 90 * 200 + 20) << name_of(method);
    }
}

TEST(Bloom, OfALampThatIsSwitchedOnIsThereInThatVeryPicture) {
    BloomBench bench, fresh;
    const Light dark{{256, 192}};
    Light lit = dark;
    fill(lit, {120, 90}, {130, 97}, glm::vec3{40.0f});
    for (int i = 0; i < 3; ++i)
        static_cast<void>(bench.bloom(dark));
    EXPECT_EQ(bench.bloom(lit).texels, fresh.bloom(lit).texels);
    EXPECT_EQ(bench.bloom(dark).texels, dark.texels);
}

TEST(Bloom, IsAddedToSmallFloatsToo) {
    BloomBench bench;
    Light scene{{256, 192}, glm::vec3{0.25f}};
    fill(scene, {120, 90}, {140, 110}, glm::vec3{64.0f});
    const Light whole = bench.bloom(scene), small = bench.bloom(scene, GL_R11F_G11F_B10F);
    EXPECT_GT(whole.at(110, 100).y, 0.5f);
    for (std::size_t i = 0; i < whole.texels.size(); ++i) {
        ASSERT_NEAR(small.texels[i].y, whole.texels[i].y, whole.texels[i].y / 64.0f) << "6 bits of mantissa";
        ASSERT_NEAR(small.texels[i].z, whole.texels[i].z, whole.texels[i].z / 32.0f) << "5 bits";
    }
}

TEST(Bloom, MakesNoObjectBeforeItIsChosen) {
    BloomBench bench;
    bench.settings.bloom.method = BloomMethod::off;
    const Light scene{{64, 64}, glm::vec3{9.0f}};
    EXPECT_EQ(bench.bloom(scene).texels, scene.texels);
    const std::uint32_t before = render::gl::live_counts().objects;
    EXPECT_EQ(bench.bloom(scene).texels, scene.texels);
    EXPECT_EQ(render::gl::live_counts().objects, before);
    bench.settings.bloom.method = BloomMethod::pyramid;
    static_cast<void>(bench.bloom(scene));
    EXPECT_GT(render::gl::live_counts().objects, before);
}

/// A white wall, in the sun or not, and a small lamp before it.
struct Street {
    Street() {
        stage.place(stage.square(), stage.material(tests::matte(glm::vec3{0.5f})),
                    glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        assets::Material glass = tests::matte(glm::vec3{0.0f});
        glass.emissive = glm::vec3{1.0f};
        lamp = stage.material(glass);
        stage.place(
            stage.square(), lamp,
            glm::translate(glm::mat4{1.0f}, {0, 0, 0.5f}) * glm::scale(glm::mat4{1.0f}, glm::vec3{0.1f}));
        stage.frame.environment = tests::only_sun({0, 0, 1});
        stage.settings.bloom = {};
    }
    tests::Stage stage;
    std::uint32_t lamp = 0;
};

TEST(Bloom, OfAStreetWithoutBrightPlacesIsThePictureWithoutIt) {
    Street street;
    const tests::Picture with = street.stage.draw();
    EXPECT_TRUE(with.has_pass("bloom find"));
    street.stage.settings.bloom.method = BloomMethod::off;
    const tests::Picture without = street.stage.draw();
    EXPECT_FALSE(without.has_pass("bloom find"));
    EXPECT_EQ(with.bytes, without.bytes);
}

TEST(Bloom, IsSeenAboutALampAndNotInTheLightThatStudiesCompare) {
    Street street;
    street.stage.frame.environment = tests::only_sun({0, 0, 1}, glm::vec3{0.1f});
    street.stage.scene.materials[street.lamp].emissive = glm::vec3{400.0f};
    const tests::Picture with = street.stage.draw();
    street.stage.settings.bloom.method = BloomMethod::off;
    const tests::Picture without = street.stage.draw();
    EXPECT_GT(with.display(64, 80).y, without.display(64, 80).y + 8);
    EXPECT_GT(with.display(64, 80).y, with.display(64, 120).y) << "fainter farther away";
    EXPECT_EQ(with.linear, without.linear) << "scene colour before bloom";
}

}  // namespace
