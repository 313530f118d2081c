// Temporal anti-aliasing: what a picture takes over from earlier ones, and what it must not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/jitter.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::Picture;
using tests::Stage;

/// Enough for the mean of earlier pictures to be independent of how it began: 0.95^96 < 1 %.
constexpr int k_settling_frames = 96;

/// 128 × 128 pixels, seen from 5 m before the middle; everything shines by itself.
struct World {
    static constexpr float k_eye_m = 5.0f;
    static constexpr float k_vertical_fov_rad = 1.0f;

    Stage stage;
    std::uint32_t square = 0;

    explicit World(render::AntiAliasing method = render::AntiAliasing::taa) {
        stage.look({0, 0, k_eye_m}, {0, 0, 0}, k_vertical_fov_rad);
        stage.settings.anti_aliasing.method = method;
        square = stage.square();
    }
    std::uint32_t glowing(glm::vec3 radiance) {
        assets::Material m = matte(radiance);
        m.unlit = true;
        return stage.material(m);
    }
    /// A rectangle, in pixels from the middle of the picture, z in metres towards the eye.
    void place(std::uint32_t material, glm::vec2 low_px, glm::vec2 high_px, float z_m,
               float angle_rad = 0.0f) {
        stage.place(square, material, rectangle(low_px, high_px, z_m, angle_rad));
    }
    static glm::mat4 rectangle(glm::vec2 low_px, glm::vec2 high_px, float z_m, float angle_rad = 0.0f) {
        const float metres_per_px = (k_eye_m - z_m) * std::tan(0.5f * k_vertical_fov_rad) / 64.0f;
        const glm::vec2 centre = 0.5f * metres_per_px * (low_px + high_px);
        const glm::vec2 half = 0.5f * metres_per_px * (high_px - low_px);
        return glm::rotate(glm::mat4{1.0f}, angle_rad, glm::vec3{0, 0, 1}) *
               glm::translate(glm::mat4{1.0f}, glm::vec3{centre, z_m}) *
               glm::scale(glm::mat4{1.0f}, glm::vec3{half, 1.0f});
    }
    Picture after(int frames) {
        Picture picture = stage.draw();
        for (int i = 1; i < frames; ++i)
            picture = stage.draw_next();
        return picture;
    }
};

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

TEST(TemporalAntiAliasing, AnEdgeAtRestConvergesToWhatItCovers) {
    World world;
    const float angle = std::atan(0.13f);
    world.place(world.glowing(glm::vec3{0.1f}), {-90, -90}, {90, 90}, 0.0f);
    world.place(world.glowing(glm::vec3{2.0f}), {-120, -120}, {120, 0}, 1.0f, angle);
    const auto error_of = [&](const Picture& picture, double& worst) {
        double sum2 = 0.0;
        int count = 0;
        worst = 0.0;
        for (int x = -60; x < 60; ++x) {
            for (int y = -10; y < 10; ++y) {
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
    // Eight samples know a share to a sixteenth; the mean weighs the latest sample by a twentieth, the oldest
    // by 0.95^7 of that.
    for (std::uint32_t i = 0; i < render::k_jitter_length; ++i) {
        EXPECT_LT(error_of(settled, worst), 0.06) << i;
        EXPECT_LT(worst, 0.16) << i;
        settled = world.stage.draw_next();
    }
    // Long after, it is still there: repeated rounding and the mean of the jitter move nothing.
    for (int i = 0; i < 400; ++i)
        static_cast<void>(world.stage.redraw());
    EXPECT_LT(error_of(world.stage.draw_next(), worst), 0.06);
}

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

struct Trail {
    double worst = 0.0;
    double mean = 0.0;
    int pixels = 0;
};

/// A dark box passes before a bright striped wall. Of the pixels that it has left more than three frames ago:
/// how much darker they are than without the box.
Trail trail_of(int speed_px, bool clamp = true) {
    const auto build = [&](World& world) {
        world.stage.settings.anti_aliasing.clamp = clamp;
        const std::uint32_t bright = world.glowing(glm::vec3{1.0f}), less = world.glowing(glm::vec3{0.5f});
        world.place(bright, {-90, -90}, {90, 90}, 0.0f);
        for (int i = -16; i < 16; ++i)
            world.place(less, {4.0f * i + 0.3f, -90}, {4.0f * i + 1.9f, 90}, 0.1f);
    };
    World with, without;
    build(with);
    build(without);
    const std::uint32_t dark = with.glowing(glm::vec3{0.01f});
    const int frames = std::min(24, 24 + 96 / speed_px);
    const auto box_begin = [&](int frame) {
        return -56 + speed_px * frame;
    };
    constexpr int k_box_px = 24;
    const auto box = [&](int frame) {
        const auto x = static_cast<float>(box_begin(frame));
        return World::rectangle({x, -20}, {x + k_box_px, 20}, 1.0f);
    };
    with.stage.place(with.square, dark, box(0));
    Trail trail;
    for (int frame = 0; frame < frames; ++frame) {
        with.stage.things.back().world_from_local = box(frame);
        const Picture a = frame == 0 ? with.stage.draw() : with.stage.draw_next();
        const Picture b = frame == 0 ? without.stage.draw() : without.stage.draw_next();
        // Left between frames − 4 and − 3 or before: shown for more than three frames since.
        for (int x = box_begin(0); frame >= 4 && x < box_begin(frame - 4) && x < 64; ++x) {
            for (int y = -19; y < 19; ++y) {
                const auto column = static_cast<std::uint32_t>(x + 64),
                           row = static_cast<std::uint32_t>(63 - y);
                const double darker = b.radiance(column, row).x - a.radiance(column, row).x;
                trail.worst = std::max(trail.worst, darker);
                trail.mean += darker;
                ++trail.pixels;
            }
        }
    }
    trail.mean /= std::max(1, trail.pixels);
    return trail;
}

TEST(TemporalAntiAliasing, LeavesNoTrailBehindWhatPasses) {
    for (const int speed_px : {1, 2, 3, 5, 8, 13, 20}) {
        const Trail trail = trail_of(speed_px);
        EXPECT_GT(trail.pixels, 500) << speed_px;
        // A trail would darken by 1; the wall's own stripes, after four samples instead of many, may be off
        // by a third of theirs.
        EXPECT_LT(trail.worst, 0.2) << speed_px;
        EXPECT_LT(trail.mean, 0.01) << speed_px;
        std::printf("speed %d worst %.4f mean %.5f\n", speed_px, trail.worst, trail.mean);
    }
}

}  // namespace
