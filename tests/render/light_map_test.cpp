// Baked light: radiance of a Lambert surface, whichever way the rest is lit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "assets/process/srgb.h"
#include "render/support.h"

namespace {

using namespace rambla;
using render::LightingPath;
using tests::matte;
using tests::Picture;
using tests::Stage;

constexpr LightingPath k_paths[] = {LightingPath::tiled, LightingPath::fullscreen, LightingPath::volumes,
                                    LightingPath::clustered, LightingPath::forward};

float from_byte(int byte) {
    return assets::linear_from_srgb_bytes()[static_cast<std::size_t>(byte)];
}

/// As R11F_G11F_B10F keeps it, with 6 bits of mantissa, blue with 5; 1/512 for bytes that the device decodes
/// and half floats.
void expect_kept(glm::vec3 found, glm::vec3 expected, const char* what) {
    EXPECT_NEAR(found.x, expected.x, expected.x * (1.0f / 64.0f + 1.0f / 512.0f)) << what;
    EXPECT_NEAR(found.y, expected.y, expected.y * (1.0f / 64.0f + 1.0f / 512.0f)) << what;
    EXPECT_NEAR(found.z, expected.z, expected.z * (1.0f / 32.0f + 1.0f / 512.0f)) << what;
}

std::uint64_t gbuffer_bytes(const Picture& picture) {
    for (const systems::PassTiming& pass : picture.feedback.passes)
        if (pass.name == "gbuffer") return pass.bytes_written;
    return 0;
}

/// A square in the dark that is lit by a map whose columns lie along its second coordinates: those run along
/// v of the first.
class LightMap : public ::testing::Test {
protected:
    LightMap() {
        stage.frame.environment = tests::only_sun({0, 0, 1}, glm::vec3{0.0f});
        stage.settings.shadows.method = render::ShadowMethod::off;
        // Kept by a byte of albedo as they are.
        material = matte({from_byte(188), from_byte(120), from_byte(230)});
        material.light_map_texture =
            stage.texture(2, 1, {{255, 188, 64, 255}, {20, 100, 200, 255}}, assets::ColourSpace::srgb);
        material.light_map_texture.uv_set = 1;
        material.light_map_strength = 0.5f;
    }

    void place() {
        const std::uint32_t square = stage.square();
        assets::Mesh& mesh = stage.scene.meshes[square];
        for (const glm::vec2 uv : mesh.uv0)
            mesh.uv1.emplace_back(uv.y, uv.x);
        stage.place(square, stage.material(material));
    }

    /// What each half sends: the upper one shows the map's first column.
    [[nodiscard]] glm::vec3 baked(bool upper) const {
        const glm::ivec3 texel = upper ? glm::ivec3{255, 188, 64} : glm::ivec3{20, 100, 200};
        const glm::vec3 light{from_byte(texel.x), from_byte(texel.y), from_byte(texel.z)};
        return glm::vec3{material.base_colour} * light * material.light_map_strength;
    }
    [[nodiscard]] glm::vec3 seen(const Picture& picture, bool upper) const {
        const glm::vec2 at = stage.pixel_of({-0.5f, upper ? 0.5f : -0.5f, 0});
        return picture.radiance(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y));
    }
    void expect_both_halves(glm::vec3 share, glm::vec3 besides, const char* what) {
        const Picture picture = stage.draw();
        for (const bool upper : {true, false})
            expect_kept(seen(picture, upper), share * baked(upper) + besides, what);
    }

    Stage stage;
    assets::Material material;
};

TEST_F(LightMap, SendsAlbedoTimesMapTimesStrength) {
    place();
    for (const LightingPath path : k_paths) {
        for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
            stage.settings.lighting.path = path;
            stage.settings.gbuffer.layout = layout;
            expect_both_halves(glm::vec3{1.0f}, glm::vec3{0.0f},
                               render::k_lighting_paths[static_cast<std::size_t>(path)].data());
        }
    }
}

TEST_F(LightMap, IsBrighterThanAByteAndAddsToEmission) {
    material.light_map_strength = 300.0f;
    material.emissive = {4.0f, 8.0f, 2.0f};
    place();
    for (const LightingPath path : {LightingPath::tiled, LightingPath::forward}) {
        stage.settings.lighting.path = path;
        expect_both_halves(glm::vec3{1.0f}, material.emissive, "300");
    }
}

TEST_F(LightMap, HasATransformOfItsOwn) {
    material.light_map_texture.scale = {-1.0f, 1.0f};
    material.light_map_texture.offset = {1.0f, 0.0f};
    place();
    const Picture picture = stage.draw();
    for (const bool upper : {true, false})
        expect_kept(seen(picture, upper), baked(!upper), "turned round");
}

TEST_F(LightMap, IsNotHiddenOnceMore) {
    material.occlusion_texture = stage.texture(1, 1, {{0, 0, 0, 255}});
    place();
    for (const LightingPath path : {LightingPath::tiled, LightingPath::forward}) {
        stage.settings.lighting.path = path;
        expect_both_halves(glm::vec3{1.0f}, glm::vec3{0.0f}, "no occlusion");
    }
}

TEST_F(LightMap, IsScatteredByWhatIsNoMetal) {
    for (const int metalness : {255, 102, 0}) {
        material.metalness = 1.0f;
        material.metalness_roughness_texture = stage.texture(1, 1, {{0, 255, metalness, 255}});
        stage.things.clear();
        place();
        for (const LightingPath path : {LightingPath::tiled, LightingPath::forward}) {
            stage.settings.lighting.path = path;
            expect_both_halves(glm::vec3{1.0f - static_cast<float>(metalness) / 255.0f}, glm::vec3{0.0f},
                               "metalness");
        }
    }
}

TEST_F(LightMap, LeavesUnlitSurfacesAsTheyAre) {
    material.unlit = true;
    place();
    for (const LightingPath path : {LightingPath::tiled, LightingPath::forward}) {
        stage.settings.lighting.path = path;
        expect_both_halves(glm::vec3{0.0f}, glm::vec3{material.base_colour}, "unlit");
    }
}

TEST_F(LightMap, LightsWhatIsBlendedByItsShareOfThePicture) {
    material.alpha_mode = assets::AlphaMode::blend;
    material.base_colour.w = 0.25f;
    place();
    expect_both_halves(glm::vec3{0.25f}, glm::vec3{0.0f}, "alpha");
    // What goes through a surface is not scattered by it.
    stage.scene.materials[0].alpha_mode = assets::AlphaMode::opaque;
    stage.scene.materials[0].transmission = 0.75f;
    expect_both_halves(glm::vec3{0.25f}, glm::vec3{0.0f}, "transmission");
}

TEST_F(LightMap, CostsATargetOnlyWhereThereIsOne) {
    place();
    const Picture with = stage.draw();
    EXPECT_EQ(gbuffer_bytes(with), 128u * 128u * (3 * 4 + 4 + 4));
    stage.scene.materials[0].light_map_strength = 0.0f;
    const Picture without = stage.draw();
    EXPECT_EQ(gbuffer_bytes(without), 128u * 128u * (3 * 4 + 4));
    EXPECT_EQ(seen(without, true), glm::vec3{0.0f});
    stage.scene.materials[0].light_map_strength = 1.0f;
    stage.scene.materials[0].light_map_texture = {};
    EXPECT_EQ(gbuffer_bytes(stage.draw()), 128u * 128u * (3 * 4 + 4));
}

TEST_F(LightMap, IsShownByTheViewOfEmission) {
    place();
    stage.settings.debug.view = render::DebugView::emission;
    const Picture picture = stage.draw();
    const glm::ivec3 shown = picture.display(44, 44);
    // Albedo of bytes 188, 120, 230 under half of 255, 188, 64.
    EXPECT_GT(shown.x, 100);
    EXPECT_GT(shown.x, shown.y);
    EXPECT_GT(shown.y, shown.z);
}

/// A floor and boards of several kinds under sun, sky and lamps, all with light maps.
void furnish(Stage& stage) {
    stage.frame.view.size_px = {160, 100};
    stage.look({0, 2, 7}, {0, 0.5f, 0});
    stage.settings.anti_aliasing.method = render::AntiAliasing::none;  // it decides by thresholds
    stage.frame.environment = assets::noon();
    stage.frame.environment.sun_illuminance *= 0.1f;
    std::vector<glm::u8vec4> ramp, greys;
    for (int i = 0; i < 64; ++i) {
        ramp.emplace_back(4 * i, 255 - 4 * i, 2 * i + 64, 255);
        greys.emplace_back(4 * i + 3, 3 * i + 20, 255 - 3 * i, 255);
    }
    const std::uint32_t square = stage.square();
    assets::Mesh& mesh = stage.scene.meshes[square];
    for (const glm::vec2 uv : mesh.uv0)
        mesh.uv1.emplace_back(0.5f * (uv.x + uv.y), uv.y);
    assets::Material floor = matte();
    floor.base_colour_texture = stage.texture(64, 1, greys, assets::ColourSpace::srgb);
    floor.light_map_texture = stage.texture(64, 1, ramp, assets::ColourSpace::srgb);
    floor.light_map_texture.uv_set = 1;
    floor.light_map_strength = 0.7f;
    stage.place(square, stage.material(floor),
                glm::scale(glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}), glm::vec3{6.0f}));
    assets::Material glowing = floor;
    glowing.emissive = {0.3f, 0.1f, 0.05f};
    glowing.metalness = 0.37f;
    assets::Material bumpy = floor;
    bumpy.roughness = 0.4f;
    bumpy.normal_texture = stage.texture(
        2, 2, {{160, 128, 240, 255}, {128, 100, 240, 255}, {100, 128, 240, 255}, {128, 160, 240, 255}});
    assets::Material cut = floor;
    cut.alpha_mode = assets::AlphaMode::mask;
    cut.base_colour_texture = stage.texture(2, 1, {{255, 255, 255, 255}, {255, 255, 255, 0}});
    assets::Material clear = floor;
    clear.alpha_mode = assets::AlphaMode::blend;
    clear.base_colour.w = 0.5f;
    float x = -4.0f;
    for (const assets::Material& look : {glowing, bumpy, cut, clear}) {
        stage.place(square, stage.material(look), glm::translate(glm::mat4{1.0f}, {x, 1.0f, 0.0f}));
        x += 2.5f;
    }
    for (const float side : {-2.0f, 2.0f})
        stage.frame.lights.push_back({.position_m = glm::vec3{side, 1.0f, 1.5f} - stage.eye,
                                      .radius_m = 4.0f,
                                      .intensity = {0.5f, 0.4f, 0.3f}});
}

TEST(LightMaps, AreTheSameInAllPathsOfLighting) {
    Stage stage;
    furnish(stage);
    stage.settings.lighting.path = LightingPath::fullscreen;
    const Picture all = stage.draw();
    for (const LightingPath path : k_paths) {
        for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
            stage.settings.lighting.path = path;
            stage.settings.gbuffer.layout = layout;
            const Picture picture = stage.draw();
            // Wide keeps albedo and normals finer, so that the light of sun and lamps is not the same there.
            const bool wide = layout == render::GBufferLayout::wide && path != LightingPath::forward;
            int largest = 0;
            std::size_t beyond = 0;
            for (std::size_t i = 0; i < all.bytes.size(); ++i) {
                const int found = std::abs(int{all.bytes[i]} - int{picture.bytes[i]});
                largest = std::max(largest, found);
                beyond += found > 1 ? 1 : 0;
            }
            const std::string_view name = render::k_lighting_paths[static_cast<std::size_t>(path)];
            EXPECT_LE(largest, wide ? 3 : 1) << name;
            EXPECT_LE(beyond, wide ? all.bytes.size() / 1000 : 0) << name;
        }
    }
}

// Without any other light, nothing but the light map's own rounding is left.
TEST(LightMaps, AreRoundedAlikeInTheDark) {
    Stage stage;
    furnish(stage);
    stage.frame.environment = tests::only_sun({0, 0, 1}, glm::vec3{0.0f});
    stage.frame.lights.clear();
    stage.settings.lighting.path = LightingPath::fullscreen;
    const Picture all = stage.draw();
    for (const LightingPath path : k_paths) {
        for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
            stage.settings.lighting.path = path;
            stage.settings.gbuffer.layout = layout;
            const Picture picture = stage.draw();
            std::size_t differ = 0;
            for (std::size_t i = 0; i < all.linear.size(); ++i) {
                const glm::vec3 a{all.linear[i]}, b{picture.linear[i]};
                differ += a != b ? 1 : 0;
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(a[c], b[c], a[c] / 16.0f + 2e-6f)
                        << "a step, of blue where its albedo takes one too, or of what lies below normal "
                           "numbers";
            }
            // Compilers may order products otherwise, which decides where a step of the format begins.
            EXPECT_LE(differ, all.linear.size() / 400)
                << render::k_lighting_paths[static_cast<std::size_t>(path)];
        }
    }
}

}  // namespace
