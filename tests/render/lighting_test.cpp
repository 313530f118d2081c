// Light on surfaces: numbers in pictures against the formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "render/reference.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::k_pi;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::rough_dielectric;
using tests::Stage;
using tests::stored_albedo;

TEST(SunLight, OnAPlaneEqualsTheFormula) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    for (const float slope_rad : {0.0f, 0.6f, 1.2f}) {
        const glm::vec3 to_sun{std::sin(slope_rad), 0.0f, std::cos(slope_rad)};
        stage.frame.environment = only_sun(to_sun, {3.0f, 2.0f, 1.0f});
        const Picture picture = stage.draw();
        const double v_dot_h = std::cos(0.5 * slope_rad);  // the eye looks along the normal
        const double expected = rough_dielectric(1.0, std::cos(slope_rad), 1.0, v_dot_h);
        const glm::vec3 found = picture.radiance(64, 64);
        // Half floats carry 11 bits (4.9e-4); the pixel's centre lies half a pixel off the axis (0.2 % of
        // Fresnel's 4 %).
        EXPECT_NEAR(found.x, 3.0 * expected, 3.0 * expected * 1.5e-3) << "slope " << slope_rad;
        EXPECT_NEAR(found.y, 2.0 * expected, 2.0 * expected * 1.5e-3);
        EXPECT_NEAR(found.z, 1.0 * expected, 1.0 * expected * 1.5e-3);
    }
}

TEST(SunLight, IsReflectedInProportionToTheAlbedo) {
    Stage stage;
    const std::uint32_t material = stage.material(matte());
    stage.place(stage.square(), material, glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = only_sun({0, 0, 1});
    for (const float albedo : {0.02f, 0.2f, 0.6f}) {
        stage.scene.materials[material].base_colour = glm::vec4{glm::vec3{albedo}, 1.0f};
        const double expected = k_pi * rough_dielectric(stored_albedo(albedo), 1.0, 1.0, 1.0);
        // A byte's step in sRGB at 0.02 is 3 % of the albedo, of which decoding may lose 0.06; half floats.
        const double tolerance = 3e-3;
        EXPECT_NEAR(stage.draw().radiance(64, 64).x, expected, expected * tolerance) << "albedo " << albedo;
    }
}

TEST(SunLight, DoesNotReachTheBackOfASurface) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = only_sun({0.3f, 0.0f, -1.0f});
    EXPECT_EQ(stage.draw().radiance(64, 64), glm::vec3{0.0f});
}

TEST(SunLight, ExposureScalesThePictureButNotTheCapture) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte(glm::vec3{0.2f})),
                glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = only_sun({0, 0, 1});
    const Picture plain = stage.draw();
    stage.settings.exposure.ev = 1.0f;
    const Picture exposed = stage.draw();
    EXPECT_NEAR(exposed.radiance(64, 64).x, plain.radiance(64, 64).x,
                1e-6f);  // a power of two is exact in half floats
    EXPECT_GT(exposed.display(64, 64).x, plain.display(64, 64).x + 20);
}

TEST(DirectionalLights, AddToTheSunOnAllSidesAsTheFormulaSays) {
    for (const render::LightingPath path : {render::LightingPath::tiled, render::LightingPath::forward}) {
        Stage stage;
        stage.settings.lighting.path = path;
        stage.frame.environment = only_sun({0, 0, -1});  // behind the square
        stage.place(stage.square(), stage.material(matte(glm::vec3{0.5f})));
        EXPECT_LT(stage.draw().radiance(64, 64).x, 1e-4f);
        const glm::vec3 slanted{0.6f, 0.0f, -0.8f};
        stage.frame.directional_lights = {{.intensity = {k_pi, 0.0f, 0.0f}, .direction = {0, 0, -1}},
                                          {.intensity = {0.0f, k_pi, 0.0f}, .direction = slanted},
                                          {.intensity = {0.0f, 0.0f, k_pi}, .direction = {0, 0, 1}}};
        const glm::vec3 lit = stage.draw().radiance(64, 64);
        const double albedo = stored_albedo(0.5);
        const double half = std::sqrt(0.5 * (1.0 + 0.8));  // cosine of half the angle between light and eye
        EXPECT_NEAR(lit.x, k_pi * rough_dielectric(albedo, 1.0, 1.0, 1.0), 0.002);
        EXPECT_NEAR(lit.y, k_pi * rough_dielectric(albedo, 0.8, 1.0, half), 0.002);
        EXPECT_LT(lit.z, 1e-4f) << "from behind";
    }
}

TEST(SkyLight, AWhiteThingVanishesInEvenSurroundings) {
    Stage stage;
    const assets::Material m = matte();
    stage.place(stage.square(), stage.material(m), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment.sky_zenith_radiance = glm::vec3{0.4f};
    stage.frame.environment.sky_horizon_radiance = glm::vec3{0.4f};
    stage.frame.environment.ground_radiance = glm::vec3{0.4f};
    // White in even surroundings shows nothing but them: what is not mirrored is scattered.
    const double expected = 0.4;
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, expected,
                expected * 1.5e-3);  // half floats, and a pixel off the axis
}

TEST(SkyLight, FromBelowIsGroundAndFromAboveIsSky) {
    Stage stage;
    const std::uint32_t square = stage.square();
    const std::uint32_t white = stage.material(matte());
    stage.frame.environment.sky_zenith_radiance = {0.0f, 0.0f, 1.0f};
    stage.frame.environment.sky_horizon_radiance = {0.0f, 0.0f, 1.0f};
    stage.frame.environment.ground_radiance = {1.0f, 0.0f, 0.0f};
    stage.place(square, white, glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}));  // faces up
    stage.look({0, 3, 0.01f}, {0, 0, 0});
    const glm::vec3 floor = stage.draw().radiance(64, 64);
    EXPECT_GT(floor.z, 0.9f);
    EXPECT_LT(floor.x, 0.01f);
    stage.things.front().world_from_local =
        glm::rotate(glm::mat4{1.0f}, 1.5707963f, {1, 0, 0});  // faces down
    stage.look({0, -3, 0.01f}, {0, 0, 0});
    const glm::vec3 ceiling = stage.draw().radiance(64, 64);
    EXPECT_GT(ceiling.x, 0.9f);
    EXPECT_LT(ceiling.z, 0.01f);
}

TEST(SkyLight, WhatHousesHideOfItIsGround) {
    Stage stage;
    stage.frame.environment.sky_zenith_radiance = {0.0f, 0.0f, 1.0f};
    stage.frame.environment.sky_horizon_radiance = {0.0f, 0.0f, 1.0f};
    stage.frame.environment.ground_radiance = {1.0f, 0.0f, 0.0f};
    stage.frame.environment.sky_visibility = 0.25f;
    stage.place(stage.square(), stage.material(matte()),
                glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}));
    stage.look({0, 3, 0.01f}, {0, 0, 0});
    const glm::vec3 floor = stage.draw().radiance(64, 64);
    EXPECT_NEAR(floor.z, 0.25f, 0.005f);  // half floats; white of roughness 1 scatters and mirrors alike
    EXPECT_NEAR(floor.x, 0.75f, 0.005f);
}

TEST(SkyLight, IsMirroredAsTheIndexOfRefractionAndTheSpecularFactorSay) {
    Stage stage;
    stage.frame.environment.sky_zenith_radiance = glm::vec3{1.0f};
    stage.frame.environment.sky_horizon_radiance = glm::vec3{1.0f};
    stage.frame.environment.ground_radiance = glm::vec3{1.0f};
    assets::Material black = matte(glm::vec3{0.0f});
    black.roughness = 0.05f;
    const std::uint32_t material = stage.material(black);
    stage.place(stage.square(), material, glm::scale(glm::mat4{1.0f}, glm::vec3{50.0f}));
    const auto mirrored = [&](float ior, float specular, glm::vec3 colour) {
        assets::Material& m = stage.scene.materials[material];
        m.ior = ior;
        m.specular = specular;
        m.specular_colour = colour;
        return stage.draw().radiance(64, 64).x;
    };
    const glm::vec3 white{1.0f};
    // Seen head-on, F0 = ((n − 1)/(n + 1))², but for the fit of the split sum (0.004) and a byte of its root.
    EXPECT_NEAR(mirrored(1.5f, 1.0f, white), 0.04f, 0.005f);
    EXPECT_NEAR(mirrored(2.0f, 1.0f, white), 1.0f / 9.0f, 0.007f);
    EXPECT_NEAR(mirrored(2.0f, 0.5f, white), 1.0f / 18.0f, 0.007f);
    EXPECT_NEAR(mirrored(2.0f, 1.0f, glm::vec3{0.5f}), 1.0f / 18.0f, 0.007f);
    EXPECT_EQ(mirrored(1.5f, 0.0f, white), 0.0f);
    EXPECT_EQ(mirrored(1.0f, 1.0f, white), 0.0f);
    EXPECT_NEAR(mirrored(0.0f, 1.0f, white), 0.95f * 0.95f, 0.03f)
        << "the most that is kept; the fit loses 3 %";
}

TEST(SkyLight, IsMirroredAsTheSpecularTexturesSay) {
    for (const render::LightingPath path : {render::LightingPath::clustered, render::LightingPath::forward}) {
        Stage stage;
        stage.settings.lighting.path = path;
        stage.frame.environment.sky_zenith_radiance = glm::vec3{1.0f};
        stage.frame.environment.sky_horizon_radiance = glm::vec3{1.0f};
        stage.frame.environment.ground_radiance = glm::vec3{1.0f};
        assets::Material black = matte(glm::vec3{0.0f});
        black.roughness = 0.05f;
        black.ior = 2.0f;
        black.specular = 0.5f;
        black.specular_colour = {4.0f, 18.0f, 0.0f};  // green: more than everything, before its texture
        // Only the alpha of the one counts, and only the colours of the other: left and right, above and
        // below.
        black.specular_texture = stage.texture(2, 1, {{0, 0, 0, 255}, {255, 255, 255, 102}});
        black.specular_colour_texture =
            stage.texture(1, 2, {{255, 255, 255, 0}, {0, 0, 255, 255}}, assets::ColourSpace::srgb);
        black.specular_colour_texture.scale = {1.0f, -1.0f};  // turned over, by its transform alone
        stage.place(stage.square(), stage.material(black));
        const Picture picture = stage.draw();
        const auto at = [&](glm::vec3 world) {
            const glm::uvec2 p{stage.pixel_of(world)};
            return picture.radiance(p.x, p.y).x;
        };
        // Red is 4/9 and green ends at 1: their luminance. Tolerances as for factors.
        const float f0 = 0.5f * (0.2126f * 4.0f / 9.0f + 0.7152f);
        EXPECT_NEAR(at({-0.1f, -0.1f, 0.0f}), f0, 0.02f);
        EXPECT_NEAR(at({0.1f, -0.1f, 0.0f}), 0.4f * f0, 0.01f);
        EXPECT_EQ(at({-0.1f, 0.1f, 0.0f}), 0.0f) << "a blue texture, and no blue in the factor";
        EXPECT_EQ(at({0.1f, 0.1f, 0.0f}), 0.0f);
    }
}

TEST(SkyLight, IsMirroredByGlassAtGrazingAngles) {
    Stage stage;
    assets::Material glass = matte(glm::vec3{0.02f});
    glass.roughness = 0.05f;
    stage.place(stage.square(), stage.material(glass), glm::scale(glm::mat4{1.0f}, glm::vec3{50.0f}));
    stage.frame.environment.sky_zenith_radiance = glm::vec3{1.0f};
    stage.frame.environment.sky_horizon_radiance = glm::vec3{1.0f};
    stage.look({0, -5, 5}, {0, 0, 0});  // from below: the mirrored ray rises
    const float steep = stage.draw().radiance(64, 64).x;
    stage.look({0, -20, 1.5f}, {0, 0, 0});
    const float grazing = stage.draw().radiance(64, 64).x;
    EXPECT_LT(steep, 0.12f);
    EXPECT_GT(grazing, 0.4f);
}

TEST(Emission, IsShownOnlyWhereAskedFor) {
    Stage stage;
    assets::Material glowing = matte(glm::vec3{0.0f});
    glowing.emissive = {3.0f, 2.0f, 0.5f};
    const std::uint32_t square = stage.square();
    stage.place(square, stage.material(glowing), glm::translate(glm::mat4{1.0f}, {-1.2f, 0, 0}));
    stage.place(square, stage.material(matte(glm::vec3{0.0f})),
                glm::translate(glm::mat4{1.0f}, {1.2f, 0, 0}));
    const Picture picture = stage.draw();
    const auto at = [&](float x) {
        return picture.radiance(static_cast<std::uint32_t>(stage.pixel_of({x, 0, 0}).x), 64);
    };
    EXPECT_NEAR(at(-1.2f).x, 3.0f, 3.0f / 64.0f);  // R11F has 6 bits of mantissa, B10F 5
    EXPECT_NEAR(at(-1.2f).y, 2.0f, 2.0f / 64.0f);
    EXPECT_NEAR(at(-1.2f).z, 0.5f, 0.5f / 32.0f);
    EXPECT_EQ(at(1.2f), glm::vec3{0.0f});
}

TEST(Unlit, ShowsItsBaseColourWhateverTheLight) {
    Stage stage;
    assets::Material m = matte({0.25f, 0.5f, 0.75f});
    m.unlit = true;
    stage.place(stage.square(), stage.material(m), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = assets::noon();
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 10.0f, .intensity = glm::vec3{10.0f}}};
    const glm::vec3 found = stage.draw().radiance(64, 64);
    EXPECT_NEAR(found.x, 0.25f, 0.25f / 64.0f);  // as emission
    EXPECT_NEAR(found.y, 0.5f, 0.5f / 64.0f);
    EXPECT_NEAR(found.z, 0.75f, 0.75f / 32.0f);
}

}  // namespace
