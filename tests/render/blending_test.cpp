// Transparent surfaces over the lit picture.
#include <gtest/gtest.h>

#include <cstring>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::Picture;
using tests::Stage;

TEST(Blending, CoversInTheGivenOrder) {
    Stage stage;
    assets::Material red = matte({1, 0, 0}), green = matte({0, 1, 0});
    for (assets::Material* m : {&red, &green}) {
        m->alpha_mode = assets::AlphaMode::blend;
        m->unlit = true;
        m->base_colour.w = 0.5f;
    }
    assets::Material card = matte({0, 0, 1});
    card.unlit = true;
    const std::uint32_t square = stage.square();
    stage.place(square, stage.material(card), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const std::uint32_t r = stage.material(red), g = stage.material(green);
    stage.place(square, r, glm::translate(glm::mat4{1.0f}, {0, 0, 1}));
    stage.place(square, g, glm::translate(glm::mat4{1.0f}, {0, 0, 2}));
    glm::vec3 found = stage.draw().radiance(64, 64);
    EXPECT_NEAR(found.x, 0.25f, 1e-3f);  // over: red ½ of ½, green ½, blue ¼; half floats, and bytes of 1
    EXPECT_NEAR(found.y, 0.5f, 1e-3f);
    EXPECT_NEAR(found.z, 0.25f, 5e-3f);
    // Behind the card nothing is seen of them.
    stage.things[1].world_from_local = glm::translate(glm::mat4{1.0f}, {0, 0, -1});
    stage.things[2].world_from_local = glm::translate(glm::mat4{1.0f}, {0, 0, -2});
    found = stage.draw().radiance(64, 64);
    EXPECT_NEAR(found.z, 1.0f, 0.02f);
    EXPECT_EQ(found.x, 0.0f);
    stage.things.resize(1);
    EXPECT_FALSE(stage.draw().has_pass("blend"));
}

TEST(Blending, LightsGlassAsOpaqueSurfacesAreLit) {
    Stage stage;
    assets::Material opaque = matte({0.5f, 0.7f, 1.0f});
    opaque.roughness = 0.5f;
    assets::Material blended = opaque;
    blended.alpha_mode = assets::AlphaMode::blend;
    const std::uint32_t square = stage.square();
    const std::uint32_t a = stage.material(opaque), b = stage.material(blended);
    stage.frame.environment = assets::noon();
    stage.frame.lights = {
        {.position_m = glm::vec3{0.3f, 0.2f, 1.0f} - stage.eye, .radius_m = 6.0f, .intensity = {2, 1, 1}}};
    stage.place(square, a);
    const Picture deferred = stage.draw();
    stage.things[0].material = b;
    const Picture forward = stage.draw();
    ASSERT_TRUE(forward.has_pass("blend"));
    for (const std::uint32_t x : {44u, 64u, 84u}) {
        const glm::vec3 expected = deferred.radiance(x, 60), found = forward.radiance(x, 60);
        // Both round what they light to what the G-buffer keeps; half floats carry 11 bits.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 2e-3f * expected[c]) << x;
    }
}

TEST(Blending, DrawsBackFacesOfGlassFirst) {
    Stage stage;
    // A box open at front and back would hide an ordering mistake: two quads in one mesh, the front one
    // first.
    assets::Mesh m;
    m.positions = {{-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1},
                   {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}};
    m.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
    m.colours = {{1, 0, 0, 0.5f}, {1, 0, 0, 0.5f}, {1, 0, 0, 0.5f}, {1, 0, 0, 0.5f},
                 {0, 1, 0, 0.5f}, {0, 1, 0, 0.5f}, {0, 1, 0, 0.5f}, {0, 1, 0, 0.5f}};
    m.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    assets::Material glass = matte();
    glass.alpha_mode = assets::AlphaMode::blend;
    glass.unlit = true;
    glass.double_sided = true;
    stage.place(stage.mesh(m), stage.material(glass));
    const glm::vec3 found = stage.draw().radiance(64, 64);
    EXPECT_NEAR(found.x, 0.5f, 2e-3f);   // red front over
    EXPECT_NEAR(found.y, 0.25f, 2e-3f);  // green back
}

/// What a card of white light behind a pane sends through it, under no other light.
class Transmission : public ::testing::Test {
protected:
    Transmission() {
        stage.frame.environment = {};
        assets::Material card;
        card.unlit = true;
        square = stage.square();
        stage.place(square, stage.material(card), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        pane.base_colour = {0.25f, 0.5f, 1.0f, 1.0f};
        pane.metalness = 0.0f;
        pane.roughness = 0.1f;
        pane.transmission = 1.0f;
    }

    glm::vec3 through(const assets::Material& material) {
        stage.things.resize(1);
        stage.place(square, stage.material(material), glm::translate(glm::mat4{1.0f}, {0, 0, 1}));
        return stage.draw().radiance(68, 64);  // right of the middle
    }

    /// A texture of one colour; channels that glTF's slots name.
    std::uint32_t texture(glm::u8vec4 texel) {
        assets::Image image{.name = "one", .width = 1, .height = 1, .texels = std::vector<std::byte>(4)};
        std::memcpy(image.texels.data(), &texel, 4);
        stage.scene.images.push_back(image);
        stage.scene.textures.push_back({.name = "one",
                                        .image = static_cast<std::uint32_t>(stage.scene.images.size() - 1),
                                        .sampler = {}});
        return static_cast<std::uint32_t>(stage.scene.textures.size() - 1);
    }

    Stage stage;
    std::uint32_t square = 0;
    assets::Material pane;
};

/// Seen head-on, glass of index 1.5 reflects 4 %; the split-sum fit and half floats allow for the rest.
constexpr float k_enters = 0.96f;
constexpr float k_fit = 0.01f;

TEST_F(Transmission, ColoursWhatLiesBehindByTheBaseColour) {
    const glm::vec3 found = through(pane);
    EXPECT_NEAR(found.x, 0.25f * k_enters, k_fit);
    EXPECT_NEAR(found.y, 0.5f * k_enters, k_fit);
    EXPECT_NEAR(found.z, 1.0f * k_enters, k_fit);
    pane.transmission = 0.5f;
    EXPECT_NEAR(through(pane).z, 0.5f * k_enters, k_fit);
}

TEST_F(Transmission, AnOpaqueMaterialsAlphaDoesNotCount) {
    pane.base_colour.w = 0.1f;
    EXPECT_NEAR(through(pane).z, k_enters, k_fit);
    pane.alpha_mode = assets::AlphaMode::blend;  // nine tenths are a hole
    EXPECT_NEAR(through(pane).x, 0.9f + 0.1f * 0.25f * k_enters, k_fit);
}

TEST_F(Transmission, AMaskCutsHolesOut) {
    pane.alpha_mode = assets::AlphaMode::mask;
    pane.base_colour.w = 0.4f;
    EXPECT_NEAR(through(pane).x, 1.0f, 1e-3f);
    pane.base_colour.w = 0.6f;
    EXPECT_NEAR(through(pane).x, 0.25f * k_enters, k_fit);
}

TEST_F(Transmission, MetalsLetNothingThrough) {
    pane.metalness = 1.0f;
    const Picture metal = [&] {
        stage.things.resize(1);
        stage.place(square, stage.material(pane), glm::translate(glm::mat4{1.0f}, {0, 0, 1}));
        return stage.draw();
    }();
    EXPECT_FALSE(metal.has_pass("blend"));
    EXPECT_EQ(metal.radiance(64, 64), glm::vec3{0.0f});
    pane.metalness_roughness_texture.texture = texture({255, 255, 255, 255});
    EXPECT_EQ(through(pane), glm::vec3{0.0f});
    pane.metalness_roughness_texture.texture = texture({255, 255, 0, 255});
    pane.roughness = 0.1f;
    EXPECT_NEAR(through(pane).x, 0.25f * k_enters, k_fit);
}

TEST_F(Transmission, ATextureScalesIt) {
    pane.transmission_texture.texture = texture({51, 255, 255, 255});
    EXPECT_NEAR(through(pane).z, 0.2f * k_enters, k_fit);
    pane.transmission_texture.texture = texture({0, 255, 255, 255});
    EXPECT_EQ(through(pane), glm::vec3{0.0f});
}

TEST_F(Transmission, ClearGlassKeepsItsHighlights) {
    // A mirrored sun, right behind the eye: the same with and without transmission, since it is reflected
    // before the light enters.
    stage.frame.environment.direction_to_sun = {0, 0, 1};
    stage.frame.environment.sun_illuminance = glm::vec3{1.0f};
    pane.base_colour = {0, 0, 0, 1};  // nothing goes through, nothing is scattered
    pane.roughness = 0.5f;
    const float clear = through(pane).x;
    pane.transmission = 0.0f;
    EXPECT_NEAR(clear, through(pane).x, 2e-3f * clear);
    EXPECT_GT(clear, 0.01f);
}

TEST_F(Transmission, WhatGoesThroughIsNotScattered) {
    stage.frame.environment.direction_to_sun = glm::normalize(glm::vec3{1, 0, 1});
    stage.frame.environment.sun_illuminance = glm::vec3{3.0f};
    pane.base_colour = {1, 1, 1, 1};
    pane.roughness = 0.3f;
    const float through_all = through(pane).x;
    pane.transmission = 0.0f;
    const float scattered = through(pane).x;
    pane.transmission = 0.5f;
    EXPECT_NEAR(through_all, k_enters, k_fit);
    EXPECT_NEAR(scattered, 0.6752f, 0.04f);  // 3 cos 45 degrees / pi, less what Fresnel takes
    EXPECT_NEAR(through(pane).x, 0.5f * (through_all + scattered), 2e-3f);
}

TEST_F(Transmission, ItsTextureHasCoordinatesOfItsOwn) {
    assets::Image image{.name = "two", .width = 2, .height = 1, .texels = std::vector<std::byte>(8)};
    image.texels[0] = std::byte{255};  // lets through on the left
    stage.scene.images.push_back(image);
    stage.scene.textures.push_back({.name = "two",
                                    .image = static_cast<std::uint32_t>(stage.scene.images.size() - 1),
                                    .sampler = {.magnify = assets::Filter::nearest}});
    pane.transmission_texture.texture = static_cast<std::uint32_t>(stage.scene.textures.size() - 1);
    EXPECT_EQ(through(pane).z, 0.0f);
    pane.transmission_texture.offset.x = 0.5f;
    EXPECT_NEAR(through(pane).z, k_enters, k_fit);
}

}  // namespace
