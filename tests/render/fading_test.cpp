// Things that fade: blended as the deferred paths draw them, each with its own depth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::Picture;
using tests::Stage;

/// A box of half size 1, seen from outside.
assets::Mesh box() {
    assets::Mesh m;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal{0.0f}, u{0.0f}, v{0.0f};
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0f;
            const auto first = static_cast<std::uint32_t>(m.positions.size());
            for (const glm::vec2 c : {glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                m.positions.push_back(normal + c.x * u + c.y * v);
                m.normals.push_back(normal);
                m.uv0.push_back(0.5f * c + 0.5f);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
                m.indices.push_back(first + i);
        }
    }
    return m;
}

/// A tilted glossy box before a wall, with sun, sky, a lamp and shadows.
struct Scene {
    Stage stage;
    std::uint32_t mesh = 0;
    std::uint32_t material = 0;
    glm::mat4 place = glm::rotate(glm::mat4{1.0f}, 0.6f, glm::normalize(glm::vec3{1, 2, 0})) *
                      glm::scale(glm::mat4{1.0f}, glm::vec3{0.7f});

    Scene() {
        stage.frame.environment = assets::noon();
        stage.frame.lights = {
            {.position_m = glm::vec3{0.8f, 0.6f, 2} - stage.eye, .radius_m = 6.0f, .intensity = {2, 1, 1}}};
        stage.place(
            stage.square(), stage.material(matte({0.3f, 0.5f, 0.7f})),
            glm::translate(glm::mat4{1.0f}, {0, 0, -2}) * glm::scale(glm::mat4{1.0f}, glm::vec3{6.0f}));
        assets::Material m = matte({0.8f, 0.5f, 0.2f});
        m.roughness = 0.4f;
        material = stage.material(m);
        mesh = stage.mesh(box());
    }
    void add(std::uint8_t faded, bool casts = true) {
        stage.place(mesh, material, place, casts);
        stage.things.back().faded = faded;
    }
};

int largest_difference(const Picture& a, const Picture& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        worst = std::max(worst, std::abs(a.bytes[i] - b.bytes[i]));
    return worst;
}

TEST(Fading, OverItselfChangesNothing) {
    Scene scene;
    scene.stage.settings.anti_aliasing.method = render::AntiAliasing::none;
    // The edge of a shadow lies on the box, of texels as large as the picture's pixels: filters look
    // different.
    scene.stage.settings.shadows.size_texels = 256;
    const glm::vec3 to_sun = scene.stage.frame.environment.direction_to_sun;
    scene.stage.place(scene.stage.square(), scene.material,
                      glm::inverse(glm::lookAt(2.0f * to_sun, glm::vec3{0.0f}, {0, 1, 0})) *
                          glm::scale(glm::mat4{1.0f}, glm::vec3{0.4f}));
    scene.add(0);
    for (const render::ShadowTaps taps : {render::ShadowTaps::four, render::ShadowTaps::sixteen}) {
        scene.stage.settings.shadows.taps = taps;
        const Picture alone = scene.stage.draw();
        scene.add(0, false);
        for (const int faded : {1, 64, 128, 200, 254}) {
            scene.stage.things.back().faded = static_cast<std::uint8_t>(faded);
            const Picture both = scene.stage.draw();
            ASSERT_TRUE(both.has_pass("blend"));
            EXPECT_LE(largest_difference(alone, both), 1)
                << faded << ' ' << render::k_shadow_taps[static_cast<std::size_t>(taps)];
        }
        scene.stage.things.pop_back();
    }
}

TEST(Fading, MixesThePictureWithAndWithoutIt) {
    Scene scene;
    scene.add(0);
    const Picture with = scene.stage.draw();
    // Faded by 254 it is hardly there, but throws its shadow, which `without` must have, too.
    scene.stage.things.back().faded = 254;
    const Picture faint = scene.stage.draw();
    const float least = 1.0f / 255.0f;
    for (const int faded : {51, 128, 230}) {
        scene.stage.things.back().faded = static_cast<std::uint8_t>(faded);
        const Picture picture = scene.stage.draw();
        const float left = 1.0f - static_cast<float>(faded) / 255.0f;
        float worst = 0.0f;
        for (std::uint32_t y = 1; y < 128; y += 2) {
            for (std::uint32_t x = 1; x < 128; x += 2) {
                const glm::vec3 behind =
                    (faint.radiance(x, y) - least * with.radiance(x, y)) / (1.0f - least);
                const glm::vec3 expected = glm::mix(behind, with.radiance(x, y), left);
                const glm::vec3 off = glm::abs(picture.radiance(x, y) - expected);
                worst = std::max({worst, off.x, off.y, off.z});
            }
        }
        // Half floats about 1, and what the shadow's and the normal's bytes round apart.
        EXPECT_LT(worst, 4e-3f) << faded;
    }
}

TEST(Fading, ShowsNothingOfItsOwnInside) {
    // Its back and inside would show at half opacity if only what is blended had no depth of its own.
    Stage stage;
    assets::Material m = matte({1, 0, 0});
    m.unlit = true;
    for (const bool both_sides : {false, true}) {
        m.double_sided = both_sides;
        stage.things.clear();
        stage.place(stage.mesh(box()), stage.material(m));
        stage.things.back().faded = 128;
        EXPECT_NEAR(stage.draw().radiance(64, 64).x, 127.0f / 255.0f, 2e-3f) << both_sides;
    }
}

TEST(Fading, MasksStayCutOut) {
    Stage stage;
    assets::Material m = matte();
    m.unlit = true;
    m.alpha_mode = assets::AlphaMode::mask;
    m.base_colour_texture = stage.texture(2, 1, {{255, 255, 255, 255}, {255, 255, 255, 0}});
    stage.place(stage.square(), stage.material(m));
    stage.things.back().faded = 128;
    const Picture picture = stage.draw();
    EXPECT_NEAR(picture.radiance(50, 64).x, 127.0f / 255.0f, 2e-3f);
    EXPECT_EQ(picture.radiance(78, 64).x, picture.radiance(2, 2).x) << "the sky behind";
}

TEST(Fading, HidesWhatLiesBehindItAsMuchAsItIsThere) {
    Stage stage;
    assets::Material red = matte({1, 0, 0}), green = matte({0, 1, 0});
    red.unlit = green.unlit = true;
    green.alpha_mode = assets::AlphaMode::blend;
    green.base_colour.w = 0.5f;
    const std::uint32_t square = stage.square();
    // Far to near: a pane, what fades, another pane.
    stage.place(square, stage.material(green), glm::translate(glm::mat4{1.0f}, {0, 0, -1}));
    stage.place(square, stage.material(red));
    stage.things.back().faded = 51;
    stage.place(square, stage.material(green), glm::translate(glm::mat4{1.0f}, {0, 0, 1}));
    const glm::vec3 found = stage.draw().radiance(64, 64);
    EXPECT_NEAR(found.x, 0.8f * 0.5f, 2e-3f);
    EXPECT_NEAR(found.y, 0.5f * 0.2f * 0.5f + 0.5f, 2e-3f);
}

TEST(Fading, IsNoPartOfWhatDebugViewsShowOfTheGBuffer) {
    Scene scene;
    for (const render::DebugView view : {render::DebugView::albedo, render::DebugView::depth}) {
        scene.stage.settings.debug.view = view;
        scene.stage.things.resize(1);
        const Picture without = scene.stage.draw();
        scene.add(128, false);
        const Picture with = scene.stage.draw();
        EXPECT_EQ(with.bytes, without.bytes);
    }
}

TEST(Fading, ThrowsItsWholeShadow) {
    Stage stage;
    stage.frame.environment = tests::only_sun({0, 0.2f, 1});
    stage.place(stage.square(), stage.material(matte()), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    stage.place(stage.square(), stage.material(matte({1, 0, 0})),
                glm::translate(glm::mat4{1.0f}, {0, 0.6f, 3}));
    stage.look({4, 0, 5}, {0, 0, 0});
    const glm::vec2 shadow = stage.pixel_of({0, 0, 0});
    const auto x = static_cast<std::uint32_t>(shadow.x), y = static_cast<std::uint32_t>(shadow.y);
    stage.things.back().faded = 254;
    EXPECT_LT(stage.draw().radiance(x, y).x, 0.01f);
    stage.things.back().casts = false;
    EXPECT_GT(stage.draw().radiance(x, y).x, 0.9f);
}

}  // namespace
