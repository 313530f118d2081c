// Transparent surfaces over the lit picture.
#include <gtest/gtest.h>

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

}  // namespace
