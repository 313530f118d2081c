// The sun's shadow in pictures, against geometry.
#include <gtest/gtest.h>

#include <cmath>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

/// A floor 20 m wide seen from straight above, one pixel 0.1 m, north (−Z) up; and a square board 2 m wide
/// that hovers 2 m above its middle.
struct Court {
    Court() {
        stage.frame.view.size_px = {200, 200};
        stage.look_flat({0, 30, 0}, {0, 0, 0}, 10.0f, {0, 0, -1});
        square = stage.square();
        white = stage.material(matte());
        flat = glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0});
        stage.place(square, white, flat * glm::scale(glm::mat4{1.0f}, glm::vec3{9.0f}));
        stage.settings.shadows.size_texels = 1024;
    }
    void add_board(std::uint32_t material) {
        stage.place(square, material, glm::translate(glm::mat4{1.0f}, {0, 2, 0}) * flat);
    }
    static constexpr float k_pixel_m = 0.1f;

    Stage stage;
    std::uint32_t square = 0;
    std::uint32_t white = 0;
    glm::mat4 flat{1.0f};
};

/// Radiance of the floor along the row of pixels at z, as a share of the lit floor's.
std::vector<float> profile(const Picture& picture, float z, float lit) {
    std::vector<float> row;
    const auto y = static_cast<std::uint32_t>((z + 10.0f) / Court::k_pixel_m);
    for (std::uint32_t x = 0; x < picture.size.x; ++x)
        row.push_back(picture.radiance(x, y).x / lit);
    return row;
}

/// Where a profile first passes ½, in metres, between pixel centres.
float crossing(const std::vector<float>& row, std::size_t from, int step) {
    for (std::size_t i = from;; i += static_cast<std::size_t>(step)) {
        const std::size_t next = i + static_cast<std::size_t>(step);
        if ((row[i] >= 0.5f) == (row[next] >= 0.5f)) continue;
        const float share = (0.5f - row[i]) / (row[next] - row[i]);
        return (static_cast<float>(i) + 0.5f + static_cast<float>(step) * share) * Court::k_pixel_m - 10.0f;
    }
}

TEST(SunShadow, EdgesLieWhereGeometryPutsThem) {
    for (const auto taps : {render::ShadowTaps::four, render::ShadowTaps::sixteen}) {
        SCOPED_TRACE(render::k_shadow_taps[static_cast<std::size_t>(taps)]);
        Court court;
        court.add_board(court.white);
        court.stage.settings.shadows.taps = taps;
        // Sun in the west: tan = 2, so the shadow of the board at 2 m falls 4 m to the east: x from 3 to 5.
        court.stage.frame.environment = only_sun({-2, 1, 0});
        const Picture picture = court.stage.draw();
        ASSERT_TRUE(picture.has_pass("sun shadow map"));
        const float lit = picture.radiance(20, 100).x;
        const std::vector<float> row = profile(picture, 0.5f, lit);
        EXPECT_GT(lit, 0.3f);
        EXPECT_NEAR(row[140], 0.0f, 1e-3f) << "the shadow's middle";
        // Normal offset moves the edge by 1.5·2 texels of 2 cm times sin θ · tan θ, i.e. 0.1 m here; a pixel
        // is 0.1 m.
        const float tolerance_m = 1.5f * Court::k_pixel_m;
        EXPECT_NEAR(crossing(row, 140, 1), 5.0f, tolerance_m);
        EXPECT_NEAR(crossing(row, 140, -1), 3.0f, tolerance_m);
        // North of the shadow (z < −1) and south of it (z > 1) all is lit, up to the filter's reach.
        EXPECT_GT(profile(picture, -1.3f, lit)[140], 0.99f);
        EXPECT_GT(profile(picture, 1.3f, lit)[140], 0.99f);
        EXPECT_LT(profile(picture, -0.7f, lit)[140], 0.01f);
        EXPECT_LT(profile(picture, 0.7f, lit)[140], 0.01f);
    }
}

TEST(SunShadow, IsGoneWithoutItsPasses) {
    Court court;
    court.add_board(court.white);
    court.stage.frame.environment = only_sun({-2, 1, 0});
    const float shadowed = court.stage.draw().radiance(140, 105).x;
    court.stage.settings.shadows.method = render::ShadowMethod::off;
    const Picture off = court.stage.draw();
    EXPECT_FALSE(off.has_pass("sun shadow map"));
    EXPECT_FALSE(off.has_pass("shadow result"));
    EXPECT_LT(shadowed, 1e-3f);
    EXPECT_GT(off.radiance(140, 105).x, 0.3f);
}

TEST(SunShadow, CostsNothingAtNightOrWithoutCasters) {
    Court court;
    court.stage.frame.environment = only_sun({-2, 1, 0}, glm::vec3{0.0f});
    EXPECT_FALSE(court.stage.draw().has_pass("sun shadow map"));
    court.stage.frame.environment = only_sun({-2, 1, 0});
    court.stage.things.front().casts = false;
    const Picture picture = court.stage.draw();
    EXPECT_FALSE(picture.has_pass("sun shadow map"));
    EXPECT_GT(picture.radiance(100, 100).x, 0.3f);
}

TEST(SunShadow, LeavesNoAcneOnSlopes) {
    for (const float sun_height : {0.15f, 0.5f, 1.0f, 3.0f}) {
        Court court;  // the floor casts onto itself
        court.stage.frame.environment = only_sun({-1.0f, sun_height, 0.3f});
        const Picture picture = court.stage.draw();
        ASSERT_TRUE(picture.has_pass("sun shadow map"));
        const float lit = picture.radiance(100, 100).x;
        for (std::uint32_t y = 15; y < 185; ++y) {
            for (std::uint32_t x = 15; x < 185; ++x) {
                ASSERT_NEAR(picture.radiance(x, y).x, lit, 0.02f * lit)
                    << x << " " << y << " height " << sun_height;
            }
        }
    }
}

TEST(SunShadow, OfAMaskedThingHasItsHoles) {
    Court court;
    assets::Material fence = matte();
    fence.alpha_mode = assets::AlphaMode::mask;
    // Left half opaque, right half a hole.
    fence.base_colour_texture = court.stage.texture(2, 1, {{255, 255, 255, 255}, {255, 255, 255, 0}});
    court.add_board(court.stage.material(fence));
    court.stage.frame.environment = only_sun({-2, 1, 0});
    const Picture picture = court.stage.draw();
    const float lit = picture.radiance(20, 100).x;
    const std::vector<float> row = profile(picture, 0.5f, lit);
    EXPECT_LT(row[135], 0.01f) << "x = 3.5, under the opaque half";
    EXPECT_GT(row[145], 0.99f) << "x = 4.5, under the hole";
    EXPECT_GT(row[104], 0.99f) << "the hole shows the floor itself, lit";
}

TEST(SunShadow, OfCastersFarTowardsTheSunIsKept) {
    Court court;
    // 500 m up, far outside the depth range that the floor needs: clamped, not lost.
    court.stage.place(court.square, court.white,
                      glm::translate(glm::mat4{1.0f}, {0, 500, 0}) * court.flat *
                          glm::scale(glm::mat4{1.0f}, glm::vec3{3.0f}));
    court.stage.frame.environment = only_sun({0, 1, 0});
    court.stage.things.back().world_from_local[3].x = 0.0f;
    court.stage.look_flat({0, 30, 0}, {0, 0, 0}, 10.0f, {0, 0, -1});
    const Picture picture = court.stage.draw();
    EXPECT_LT(picture.radiance(100, 100).x, 1e-3f);
    EXPECT_GT(picture.radiance(20, 100).x, 0.3f);
}

TEST(SunShadow, FadesOutAtItsDistance) {
    Stage stage;
    const std::uint32_t square = stage.square();
    const std::uint32_t white = stage.material(matte());
    const glm::mat4 flat = glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0});
    stage.place(square, white, flat * glm::scale(glm::mat4{1.0f}, glm::vec3{200.0f}));
    stage.place(
        square, white,
        glm::translate(glm::mat4{1.0f}, {0, 20, 0}) * flat * glm::scale(glm::mat4{1.0f}, glm::vec3{200.0f}));
    stage.frame.environment = only_sun({0, 1, 0});
    stage.settings.shadows.distance_m = 50.0f;
    stage.look({0, 5, 0}, {0, 3, -20});
    const Picture picture = stage.draw();
    const auto floor_at = [&](float distance) {
        const glm::vec2 p = stage.pixel_of({0, 0, -distance});
        return picture.radiance(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y)).x;
    };
    EXPECT_LT(floor_at(20.0f), 0.01f);
    EXPECT_LT(floor_at(40.0f), 0.01f);
    EXPECT_GT(floor_at(60.0f), 0.9f);
}

}  // namespace
