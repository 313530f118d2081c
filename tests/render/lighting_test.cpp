// Light on surfaces: numbers in pictures against the formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

constexpr double k_pi = 3.14159265358979323846;

/// Albedo as the G-buffer's 8-bit sRGB texel holds it. The shader's decoding is off by at most 0.06 of a
/// byte's step.
double stored_albedo(double albedo) {
    const double encoded = albedo <= 0.0031308 ? 12.92 * albedo : 1.055 * std::pow(albedo, 1.0 / 2.4) - 0.055;
    const double byte = std::round(encoded * 255.0) / 255.0;
    return byte <= 0.04045 ? byte / 12.92 : std::pow((byte + 0.055) / 1.055, 2.4);
}

/// glTF's dielectric of roughness 1 (α = 1): Lambert under a Fresnel layer; GGX is then 1/π for all half
/// vectors.
/// @param n_dot_l, n_dot_v, v_dot_h  cosines
double rough_dielectric(double albedo, double n_dot_l, double n_dot_v, double v_dot_h) {
    const double fresnel = 0.04 + 0.96 * std::pow(1.0 - v_dot_h, 5.0);
    const double visibility = 0.5 / (n_dot_l + n_dot_v);  // Smith with α = 1
    return ((1.0 - fresnel) * albedo / k_pi + fresnel / k_pi * visibility) * n_dot_l;
}

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
    stage.settings.tone.exposure_ev = 1.0f;
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

TEST(Normals, OfMirroredAndScaledThingsPointOutwards) {
    Stage stage;
    // A roof of two slopes: mirrored in x, its left slope becomes its right one.
    assets::Mesh slope;
    const glm::vec3 normal = glm::normalize(glm::vec3{1, 0, 1});
    slope.positions = {{0, -1, 0}, {1, -1, -1}, {1, 1, -1}, {0, 1, 0}};
    slope.normals.assign(4, normal);
    slope.indices = {0, 1, 2, 0, 2, 3};
    const std::uint32_t mesh = stage.mesh(slope);
    const std::uint32_t white = stage.material(matte());
    stage.place(mesh, white);
    stage.place(mesh, white, glm::scale(glm::mat4{1.0f}, {-1, 1, 1}));
    stage.frame.environment = only_sun({1, 0, 1});
    stage.settings.shadows.method = render::ShadowMethod::off;
    Picture picture = stage.draw();
    const glm::vec2 right = stage.pixel_of({0.5f, 0, -0.5f}), left = stage.pixel_of({-0.5f, 0, -0.5f});
    const auto at = [&](glm::vec2 p) {
        return picture.radiance(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y)).x;
    };
    EXPECT_GT(at(right), 0.9f) << "faces the sun";
    EXPECT_LT(at(left), 0.02f) << "mirrored, it grazes the sun";
    stage.frame.environment = only_sun({-1, 0, 1});
    picture = stage.draw();
    EXPECT_GT(at(left), 0.9f);
    EXPECT_LT(at(right), 0.02f);

    // Scaled by 1 in x and 3 in z: the slope is steeper, its normal (1/1, 1/3), not (1, 3).
    stage.things.pop_back();
    stage.things.front().world_from_local = glm::scale(glm::mat4{1.0f}, {1, 1, 3});
    stage.frame.environment = only_sun({1.0f, 0.0f, 1.0f / 3.0f});
    picture = stage.draw();
    EXPECT_GT(at(stage.pixel_of({0.5f, 0, -1.5f})), 0.93f);
}

TEST(Normals, OfDoubleSidedSurfacesFaceTheEye) {
    Stage stage;
    assets::Material m = matte();
    m.double_sided = true;
    stage.place(stage.square(), stage.material(m), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.environment = only_sun({0, 0, -1});
    stage.settings.shadows.method = render::ShadowMethod::off;
    stage.look({0, 0, -5}, {0, 0, 0});
    EXPECT_GT(stage.draw().radiance(64, 64).x, 0.9f) << "seen from behind";
    stage.things.front().world_from_local = glm::scale(glm::mat4{1.0f}, {-20, 20, 20});
    EXPECT_GT(stage.draw().radiance(64, 64).x, 0.9f) << "mirrored and seen from behind";
    stage.look({0, 0, 5}, {0, 0, 0});
    EXPECT_LT(stage.draw().radiance(64, 64).x, 0.01f) << "the sun shines on the other side";
}

TEST(NormalMaps, TiltTowardsIncreasingUAndUpwards) {
    for (const bool mirrored_uv : {false, true}) {
        Stage stage;
        std::uint32_t mesh = stage.square();
        if (mirrored_uv) {
            for (glm::vec2& uv : stage.scene.meshes[mesh].uv0)
                uv.x = 1.0f - uv.x;
            stage.scene.meshes[mesh].tangents.assign(4, {-1, 0, 0, -1});  // u along −X; w·(n×t) is still +Y
        }
        const float towards_u = mirrored_uv ? -1.0f : 1.0f;
        const struct {
            glm::u8vec4 texel;
            glm::vec3 tilt;
        } cases[] = {
            {{218, 128, 218, 255}, {towards_u, 0, 0}},  // +T
            {{128, 218, 218, 255}, {0, 1, 0}},          // glTF: green points up, that is against v
        };
        for (const auto& test : cases) {
            assets::Material m = matte();
            m.normal_texture = stage.texture(1, 1, {test.texel});
            stage.things.clear();
            stage.place(mesh, stage.material(m));
            stage.settings.shadows.method = render::ShadowMethod::off;
            for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
                stage.settings.gbuffer.layout = layout;
                stage.frame.environment = only_sun(glm::vec3{0, 0, 1} + test.tilt);
                const float facing = stage.draw().radiance(64, 64).x;
                stage.frame.environment = only_sun(glm::vec3{0, 0, 1} - test.tilt);
                const float away = stage.draw().radiance(64, 64).x;
                EXPECT_GT(facing, 0.93f) << "mirrored " << mirrored_uv << " tilt " << test.tilt.x << " "
                                         << test.tilt.y << " layout " << static_cast<int>(layout);
                EXPECT_LT(away, 0.05f) << "mirrored " << mirrored_uv << " tilt " << test.tilt.x << " "
                                       << test.tilt.y << " layout " << static_cast<int>(layout);
            }
        }
    }
}

TEST(NormalMaps, TurnWithTheirSurfaceWhereItsBackIsSeen) {
    for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
        for (const glm::u8vec4 texel : {glm::u8vec4{218, 128, 218, 255}, glm::u8vec4{128, 218, 218, 255}}) {
            Stage stage;
            stage.settings.gbuffer.layout = layout;
            stage.settings.shadows.method = render::ShadowMethod::off;
            assets::Material m = matte();
            m.double_sided = true;
            m.normal_texture = stage.texture(1, 1, {texel});
            stage.place(stage.square(), stage.material(m));
            stage.look({0, 0, -5}, {0, 0, 0});
            const glm::vec3 tilt = texel.x > 200 ? glm::vec3{1, 0, 0} : glm::vec3{0, 1, 0};
            stage.frame.environment = only_sun(glm::vec3{0, 0, -1} - tilt);
            EXPECT_GT(stage.draw().radiance(64, 64).x, 0.93f);
            stage.frame.environment = only_sun(glm::vec3{0, 0, -1} + tilt);
            EXPECT_LT(stage.draw().radiance(64, 64).x, 0.05f);
        }
    }
}

TEST(PointLight, FallsOffWithTheSquareInsideItsWindow) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const float radius = 4.0f;
    const double aside =
        std::sqrt(2.0) * 5.0 * std::tan(0.5) / 128.0;  // the pixel's centre, from below the light
    for (const float height : {0.5f, 1.0f, 2.0f, 3.5f}) {
        stage.frame.lights = {{.position_m = glm::vec3{0, 0, height} - stage.eye,
                               .radius_m = radius,
                               .intensity = glm::vec3{2.0f}}};
        const Picture picture = stage.draw();
        const double distance = std::hypot(height, aside);
        const double window = std::pow(1.0 - std::pow(distance / radius, 4.0), 2.0);
        const double expected =
            2.0 * window / (distance * distance) * rough_dielectric(1.0, height / distance, 1.0, 1.0);
        EXPECT_NEAR(picture.radiance(64, 64).x, expected, expected * 1.5e-3)
            << "height " << height;  // half floats
    }
}

TEST(PointLight, EndsAtItsRadiusAndCostsNothingWhenAbsent) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    EXPECT_FALSE(stage.draw().has_pass("light tiles"));
    stage.frame.lights = {
        {.position_m = glm::vec3{0, 0, 1} - stage.eye, .radius_m = 1.5f, .intensity = glm::vec3{50.0f}}};
    const Picture picture = stage.draw();
    EXPECT_TRUE(picture.has_pass("light tiles"));
    const float rim = std::sqrt(1.5f * 1.5f - 1.0f);  // of the lit circle on the plane
    int lit_beyond = 0, lit_within = 0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            const glm::vec2 plane = (glm::vec2{x + 0.5f, y + 0.5f} / 64.0f - 1.0f) * 5.0f * std::tan(0.5f);
            if (picture.radiance(x, y).x <= 0.0f) continue;
            (glm::length(plane) > rim ? lit_beyond : lit_within) += 1;
        }
    }
    EXPECT_EQ(lit_beyond, 0);
    // The circle's area in pixels, less a rim where the window's light is below a half float's smallest step.
    const float pixels = 3.14159f * std::pow(rim / (5.0f * std::tan(0.5f)) * 64.0f, 2.0f);
    EXPECT_GT(static_cast<float>(lit_within), 0.95f * pixels) << "the light's rectangle cuts it off";
    stage.frame.lights[0].position_m = glm::vec3{0, 0, 50} - stage.eye;  // behind the eye
    EXPECT_FALSE(stage.draw().has_pass("light tiles"));
}

TEST(PointLight, LightsFromAroundTheEyeAndManyOverlap) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.frame.lights = {{.position_m = {0, 0, 0}, .radius_m = 20.0f, .intensity = glm::vec3{10.0f}}};
    const float one = stage.draw().radiance(64, 64).x;
    EXPECT_GT(one, 0.1f);
    stage.frame.lights.assign(8, stage.frame.lights[0]);
    EXPECT_NEAR(stage.draw().radiance(64, 64).x, 8.0f * one,
                8.0f * one * 4e-3f);  // eight roundings to half floats
}

TEST(PointLight, KeepsItsColourWhenOthersLieOutsideTheView) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const auto light = [&](glm::vec3 position, glm::vec3 intensity) {
        return systems::FrameLight{
            .position_m = position - stage.eye, .radius_m = 2.0f, .intensity = intensity};
    };
    stage.frame.lights = {light({0, 0, 30}, {5, 5, 5}), light({-1.5f, 0, 1}, {1, 0, 0}),
                          light({1.5f, 0, 1}, {0, 0, 1})};
    const Picture picture = stage.draw();
    const auto at = [&](float x) {
        return picture.radiance(static_cast<std::uint32_t>(stage.pixel_of({x, 0, 0}).x), 64);
    };
    EXPECT_GT(at(-1.5f).x, 0.2f);
    EXPECT_EQ(at(-1.5f).z, 0.0f);
    EXPECT_GT(at(1.5f).z, 0.2f);
    EXPECT_EQ(at(1.5f).x, 0.0f);
}

TEST(SpotLight, HasAConeWithASmoothEdge) {
    Stage stage;
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const float inner = 0.2f, outer = 0.4f;
    stage.frame.lights = {{.position_m = glm::vec3{0, 0, 3} - stage.eye,
                           .radius_m = 50.0f,
                           .intensity = glm::vec3{20.0f},
                           .cos_outer = std::cos(outer),
                           .direction = {0, 0, -1},
                           .cos_inner = std::cos(inner)}};
    const Picture spot = stage.draw();
    stage.frame.lights[0].cos_outer = -2.0f;
    stage.frame.lights[0].cos_inner = -1.0f;
    const Picture point = stage.draw();
    const auto share = [&](float angle) {
        const glm::vec2 p = stage.pixel_of({3.0f * std::tan(angle), 0.0f, 0.0f});
        const auto x = static_cast<std::uint32_t>(p.x), y = static_cast<std::uint32_t>(p.y);
        return spot.radiance(x, y).x / point.radiance(x, y).x;
    };
    EXPECT_NEAR(share(0.1f), 1.0f, 2e-3f);
    EXPECT_EQ(share(0.45f), 0.0f);
    const float ramp = (std::cos(0.3f) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(share(0.3f), ramp * ramp, 0.06f);  // a pixel is 0.014 rad wide, a fourteenth of the ramp
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
