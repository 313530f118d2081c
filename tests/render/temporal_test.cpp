// Temporal anti-aliasing: what a picture takes over from earlier ones, and what it must not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/jitter.h"
#include "render/temporal_world.h"

namespace {

using namespace rambla;
using tests::k_settling_frames;
using tests::matte;
using tests::Picture;
using tests::World;

/// What edges are averaged in: temporal.glsl's compressed luma of a grey, as Reinhard's curve shows it.
double shown(double radiance) {
    return radiance / (1.0 + radiance);
}

/// Share of a pixel on the lower side of a line y = slope·x + offset, in pixels from the middle of the
/// picture.
double share_below(double x, double y, double slope, double offset) {
    constexpr int k_steps = 64;
    double below = 0.0;
    for (int i = 0; i < k_steps; ++i) {
        const double column = x + (i + 0.5) / k_steps;
        below += std::clamp(slope * column + offset - y, 0.0, 1.0) / k_steps;
    }
    return below;
}

/// And what its pixels may be off by.
struct Slope {
    float slope;
    double rms;
    double worst;
};
class EdgeAtRest : public testing::TestWithParam<Slope> {};

TEST_P(EdgeAtRest, ConvergesToWhatItCovers) {
    World world;
    const float angle = std::atan(GetParam().slope);
    world.place(world.glowing(glm::vec3{0.1f}), {-90, -90}, {90, 90}, 0.0f);
    world.place(world.glowing(glm::vec3{2.0f}), {-120, -120}, {120, 0}, 1.0f, angle);
    const auto error_of = [&](const Picture& picture, double& worst) {
        double sum2 = 0.0;
        int count = 0;
        worst = 0.0;
        for (int x = -50; x < 50; ++x) {
            for (int y = -60; y < 60; ++y) {
                const double share = share_below(x, y, std::tan(angle), 0.0);
                if (share <= 0.0 || share >= 1.0) continue;
                const double radiance =
                    picture.radiance(static_cast<std::uint32_t>(x + 64), static_cast<std::uint32_t>(63 - y))
                        .x;
                const double found = (shown(radiance) - shown(0.1)) / (shown(2.0) - shown(0.1));
                sum2 += (found - share) * (found - share);
                worst = std::max(worst, std::fabs(found - share));
                ++count;
            }
        }
        EXPECT_GT(count, 100);
        return std::sqrt(sum2 / count);
    };
    double worst_first = 0.0, worst = 0.0;
    const double first = error_of(world.after(1), worst_first);
    EXPECT_GT(first, 0.25) << "one sample is all or nothing";
    Picture settled = world.after(k_settling_frames);
    // Eight samples of the sequence, the latest weighed by a twentieth and the oldest by 0.95^7 of that, know
    // the share of a half plane to 0.064 (root of the mean square over all directions and distances); along
    // diagonals some lie in line.
    for (std::uint32_t i = 0; i < render::k_jitter_length; ++i) {
        EXPECT_LT(error_of(settled, worst), GetParam().rms) << i;
        EXPECT_LT(worst, GetParam().worst) << i;
        settled = world.stage.draw_next();
    }
    // Long after, it is still there: repeated rounding and the mean of the jitter move nothing.
    for (int i = 0; i < 200; ++i)
        static_cast<void>(world.stage.redraw());
    EXPECT_LT(error_of(world.stage.draw_next(), worst), GetParam().rms);
}

INSTANTIATE_TEST_SUITE_P(TemporalAntiAliasing, EdgeAtRest,
                         testing::Values(Slope{0.0317f, 0.075, 0.22}, Slope{0.13f, 0.075, 0.22},
                                         Slope{0.57f, 0.075, 0.22}, Slope{0.93f, 0.105, 0.29}));

/// A wall whose texels are as large as pixels must show them as one picture without jitter does, to the grey
/// that a box of one pixel makes of two neighbours that it lies between.
TEST(TemporalAntiAliasing, AWallAtRestKeepsItsTexture) {
    const auto contrast_of = [](render::AntiAliasing method) {
        World world{method};
        std::vector<glm::u8vec4> texels;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                texels.push_back(((x ^ y) & 1) != 0 ? glm::u8vec4{255, 255, 255, 255}
                                                    : glm::u8vec4{64, 64, 64, 255});
        assets::Material m = matte();
        m.unlit = true;
        m.base_colour_texture = world.stage.texture(64, 64, texels);
        world.place(world.stage.material(m), {-64, -64}, {64, 64}, 0.0f);  // two pixels a texel
        const Picture picture = world.after(method == render::AntiAliasing::taa ? k_settling_frames : 1);
        double sum = 0.0;
        for (std::uint32_t y = 32; y < 96; ++y)
            for (std::uint32_t x = 32; x < 96; ++x)
                sum += std::fabs(picture.radiance(x, y).x - picture.radiance(x + 2, y).x);
        return sum / (64 * 64);
    };
    const double without = contrast_of(render::AntiAliasing::none);
    EXPECT_NEAR(without, 0.75, 0.01);
    EXPECT_GT(contrast_of(render::AntiAliasing::taa), 0.97 * without);
}

/// Where nothing of the present differs, another pre-exposure changes nothing but the rounding of half
/// floats.
TEST(TemporalAntiAliasing, AnotherExposureIsAFactorOnThePast) {
    World world;
    world.place(world.glowing(glm::vec3{0.1f}), {-90, -90}, {90, 90}, 0.0f);
    world.place(world.glowing(glm::vec3{0.4f}), {-120, -120}, {120, 0}, 1.0f, 0.13f);
    const Picture before = world.after(k_settling_frames);
    world.stage.settings.exposure.ev = 0.25f;
    const Picture after = world.stage.draw_next();
    for (std::size_t i = 0; i < after.linear.size(); ++i) {
        // A new sample counts a twentieth of the difference between the two surfaces, and another exposure
        // weighs it anew.
        ASSERT_NEAR(after.linear[i].x, before.linear[i].x, 0.05 * 0.3 + 0.01) << i;
    }
}

/// What the first picture of all shows, which has no past.
void expect_no_past(const Picture& picture, World& fresh) {
    const Picture first = fresh.stage.draw();
    EXPECT_EQ(picture.bytes, first.bytes);
}

void build_cross(World& world) {
    world.place(world.glowing(glm::vec3{0.1f}), {-90, -90}, {90, 90}, 0.0f);
    world.place(world.glowing(glm::vec3{1.0f}), {-8, -60}, {8, 60}, 1.0f, 0.3f);
    world.place(world.glowing({0.2f, 0.9f, 0.1f}), {-60, -8}, {60, 8}, 1.5f, 0.3f);
}

TEST(TemporalAntiAliasing, ACutLeavesNothingOfThePictureBefore) {
    World world, fresh;
    for (World* w : {&world, &fresh})
        build_cross(*w);
    world.stage.look({100, 0, World::k_eye_m}, {100, 0, 0}, World::k_vertical_fov_rad);
    world.stage.frame.view.eye_local_m = world.stage.eye;
    static_cast<void>(world.after(5));
    world.stage.look({0, 0, World::k_eye_m}, {0, 0, 0}, World::k_vertical_fov_rad);
    world.stage.frame.view.eye_local_m = world.stage.eye;
    expect_no_past(world.stage.draw_next(), fresh);
}

TEST(TemporalAntiAliasing, AnotherSceneLeavesNothingOfThePictureBefore) {
    World world, fresh;
    for (World* w : {&world, &fresh})
        build_cross(*w);
    world.stage.things[2].world_from_local = World::rectangle({-30, 10}, {50, 20}, 1.0f);
    static_cast<void>(world.after(5));
    world.stage.things = fresh.stage.things;
    expect_no_past(world.stage.draw(), fresh);
}

TEST(TemporalAntiAliasing, BeginsAnewWhenItIsChosenAgain) {
    World world, fresh;
    for (World* w : {&world, &fresh})
        build_cross(*w);
    static_cast<void>(world.after(5));
    world.stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    static_cast<void>(world.stage.draw_next());
    world.stage.settings.anti_aliasing.method = render::AntiAliasing::taa;
    expect_no_past(world.stage.draw_next(), fresh);
}

/// Two sheets of glass that send as much as a half float holds make infinity where they overlap.
TEST(TemporalAntiAliasing, InfinityIsGoneWithTheNextPicture) {
    World world, plain;
    for (World* w : {&world, &plain})
        build_cross(*w);
    assets::Material glass = matte(glm::vec3{60000.0f});
    glass.unlit = true;
    glass.alpha_mode = assets::AlphaMode::blend;
    const std::uint32_t blinding = world.stage.material(glass);
    static_cast<void>(world.after(8));
    static_cast<void>(plain.after(8));
    const std::vector<tests::Stage::Thing> dark = world.stage.things;
    for (const float z_m : {2.0f, 2.5f})
        world.place(blinding, {-20, -20}, {20, 20}, z_m);
    const Picture hit = world.stage.draw_next();
    static_cast<void>(plain.stage.draw_next());
    EXPECT_GT(hit.radiance(64, 64).x, 100.0f);
    world.stage.things = dark;
    const glm::uvec2 flat{64 + 17, 64 - 17};  // of the sheets, before nothing but the wall
    for (int frame = 1; frame <= 4; ++frame) {
        const Picture next = world.stage.draw_next();
        const Picture expected = plain.stage.draw_next();
        EXPECT_NEAR(next.radiance(flat.x, flat.y).x, expected.radiance(flat.x, flat.y).x, 1e-3f) << frame;
        for (std::size_t i = 0; i < next.linear.size(); ++i) {
            ASSERT_TRUE(std::isfinite(next.linear[i].x)) << i;
            // Kept within the colours around the pixel, of which the brightest is 1; where it may have come
            // from something thin, after three pictures.
            ASSERT_LE(next.linear[i].x, frame == 4 ? 1.01f : 60000.0f) << i;
        }
    }
}

/// Seen from an eye that creeps to the side by a fraction of a pixel per picture, a line at rest of half a
/// pixel: how much the sum over a row of pixels varies from picture to picture, as a share of what is
/// covered.
double flicker_of(render::AntiAliasing method, double& mean) {
    World world{method};
    world.place(world.glowing(glm::vec3{0.05f}), {-90, -90}, {90, 90}, 0.0f);
    world.place(world.glowing(glm::vec3{1.0f}), {-0.25f, -80}, {0.25f, 80}, 1.0f, 0.02f);
    std::vector<double> sums;
    for (int frame = 0; frame < 60; ++frame) {
        world.stage.eye.x = world.stage.frame.view.eye_local_m.x = 0.0017f * static_cast<float>(frame);
        const Picture picture = frame == 0 ? world.stage.draw() : world.stage.draw_next();
        double sum = 0.0;
        for (std::uint32_t px = 32; px < 96; ++px)
            sum += (shown(picture.radiance(px, 40).x) - shown(0.05)) / (shown(1.0) - shown(0.05));
        if (frame >= 10) sums.push_back(sum);
    }
    constexpr double k_covered = 0.5;
    double variance = 0.0;
    mean = 0.0;
    for (const double sum : sums)
        mean += sum / static_cast<double>(sums.size());
    for (const double sum : sums)
        variance += (sum - mean) * (sum - mean) / static_cast<double>(sums.size());
    return std::sqrt(variance) / k_covered;
}

TEST(TemporalAntiAliasing, AThinLineFlickersLessAndDoesNotVanish) {
    double mean_without = 0.0, mean = 0.0;
    const double without = flicker_of(render::AntiAliasing::none, mean_without);
    const double with = flicker_of(render::AntiAliasing::taa, mean);
    EXPECT_GT(without, 0.5) << "half of the time it falls between the samples";
    EXPECT_LT(with, 0.4 * without);
    EXPECT_GT(mean, 0.6 * 0.5);
}

TEST(TemporalAntiAliasing, DrawsMotionOnlyWhereSomethingMoves) {
    World world;
    build_cross(world);
    const Picture first = world.stage.draw();
    EXPECT_TRUE(first.has_pass("temporal anti-aliasing"));
    EXPECT_FALSE(first.has_pass("motion vectors"));
    world.stage.things[2].world_from_local = World::rectangle({-60, -6}, {60, 10}, 1.5f, 0.3f);
    EXPECT_TRUE(world.stage.draw_next().has_pass("motion vectors"));
    EXPECT_FALSE(world.stage.draw_next().has_pass("motion vectors"));
    world.stage.settings.debug.view = render::DebugView::depth;
    EXPECT_FALSE(world.stage.draw_next().has_pass("temporal anti-aliasing"))
        << "debug views show one picture";
}

}  // namespace
