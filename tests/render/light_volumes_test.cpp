// Rectangles and solids of lamps light the same pixels, wherever the eye is.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render/support.h"

namespace {

using namespace rambla;
using render::LightVolume;
using tests::matte;
using tests::Picture;
using tests::Stage;

constexpr float k_half_height_m = 5.0f;

/// One lamp in a room, and an eye. Places are in the world.
struct Look {
    const char* name = "";
    glm::vec3 lamp_m{0.0f};
    float radius_m = 1.0f;
    float cos_outer = -2.0f;
    glm::vec3 direction{0, -1, 0};
    glm::vec3 eye_m{0, 2, 8};
    glm::vec3 target_m{0, 1, 0};
    bool orthographic = false;
};

const glm::vec3 k_ahead{0, 0, -1};
const glm::vec3 k_down_ahead = glm::normalize(glm::vec3{0, -1, -1});

/// The near plane is 0.05 m before the eye, its corners 0.065 m from it. A small board hangs at z = 6.2.
const std::vector<Look> k_looks{
    {.name = "before the eye", .lamp_m = {0, 1, 0}, .radius_m = 3},
    {.name = "large and beside the view", .lamp_m = {-5, 2, 2}, .radius_m = 4.5f},
    {.name = "around the eye", .lamp_m = {1, 2, 6}, .radius_m = 9},
    {.name = "at the eye", .lamp_m = {0, 2, 8}, .radius_m = 6},
    {.name = "behind the eye", .lamp_m = {0, 2, 11}, .radius_m = 6},
    {.name = "its hull just before the eye",  // whose vertices lie 0.2143 m from the lamp
     .lamp_m = {0, 2, 6.25f},
     .radius_m = 0.2f,
     .eye_m = {0, 2, 6.47f},
     .target_m = {0, 2, 0}},
    {.name = "the eye in a corner of its hull",
     .lamp_m = {0, 2, 6.25f},
     .radius_m = 0.2f,
     .eye_m = {0, 2, 6.458f},
     .target_m = {0, 2, 0}},
    {.name = "tiny",
     .lamp_m = {0.5f, 0.01f, 4},
     .radius_m = 0.03f,
     .eye_m = {0.5f, 0.3f, 4.5f},
     .target_m = {0.5f, 0, 4}},
    {.name = "endless", .lamp_m = {0, 3, 0}, .radius_m = 1e9f},
    {.name = "a spot before the eye", .lamp_m = {0, 4, 0}, .radius_m = 6, .cos_outer = 0.8f},
    {.name = "a spot along the floor",
     .lamp_m = {-3, 0.3f, 0},
     .radius_m = 5,
     .cos_outer = 0.7f,
     .direction = {1, 0, 0}},
    {.name = "a narrow spot", .lamp_m = {-2, 4, 0}, .radius_m = 6, .cos_outer = 0.995f},
    {.name = "the narrowest spot",
     .lamp_m = {-2, 4, 0},
     .radius_m = 6,
     .cos_outer = 0.9999f,
     .eye_m = {-2, 1, 1.5f},
     .target_m = {-2, 0, 0}},
    {.name = "the widest cone", .lamp_m = {0, 3, 0}, .radius_m = 4, .cos_outer = 0.502f},
    {.name = "a spot too wide for a cone", .lamp_m = {0, 3, 0}, .radius_m = 4, .cos_outer = 0.2f},
    {.name = "a spot that lights half of all", .lamp_m = {0, 3, 0}, .radius_m = 4, .cos_outer = 0.0f},
    {.name = "a torch at the eye",
     .lamp_m = {0, 2, 8},
     .radius_m = 12,
     .cos_outer = 0.9f,
     .direction = k_ahead},
    {.name = "a torch below the eye",
     .lamp_m = {0, 1.9f, 8},
     .radius_m = 12,
     .cos_outer = 0.95f,
     .direction = k_ahead},
    {.name = "a torch behind the eye",
     .lamp_m = {0, 2.2f, 9},
     .radius_m = 12,
     .cos_outer = 0.7f,
     .direction = k_down_ahead},
    {.name = "a spot that meets the eye",
     .lamp_m = {0, 3, 2},
     .radius_m = 8,
     .cos_outer = 0.7f,
     .direction = {0, -0.3f, 0.953939f}},
    {.name = "flat, before the eye", .lamp_m = {0, 1, 0}, .radius_m = 3, .orthographic = true},
    {.name = "flat, around the eye", .lamp_m = {0, 2, 7}, .radius_m = 9, .orthographic = true},
    {.name = "flat, across the near plane and beside the eye",
     .lamp_m = {3, 2, 8},
     .radius_m = 2.9f,
     .orthographic = true},
    {.name = "flat, beyond the far plane too", .lamp_m = {0, 2, 0}, .radius_m = 300, .orthographic = true},
    {.name = "flat, reaching beyond the far plane",
     .lamp_m = {0, 2, -60},
     .radius_m = 62,
     .orthographic = true},
    {.name = "flat, a spot before the eye",
     .lamp_m = {0, 4, 0},
     .radius_m = 6,
     .cos_outer = 0.8f,
     .orthographic = true},
    {.name = "flat, a spot through the near plane",
     .lamp_m = {0, 2, 12},
     .radius_m = 16,
     .cos_outer = 0.97f,
     .direction = k_ahead,
     .target_m = {0, 2, 0},
     .orthographic = true},
};

/// A floor, a wall behind, pillars before it, and a board close to the eye; all else is sky.
void furnish(Stage& stage) {
    assets::Material white = matte();
    white.double_sided = true;
    const std::uint32_t material = stage.material(white);
    const std::uint32_t square = stage.square();
    const auto place = [&](glm::vec3 at, glm::vec3 size) {
        stage.place(square, material, glm::scale(glm::translate(glm::mat4{1.0f}, at), size));
    };
    stage.place(square, material,
                glm::scale(glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}), glm::vec3{30.0f}));
    place({0, 1.5f, -6}, {12, 1.5f, 1});
    for (int i = 0; i < 5; ++i)
        place({-4.0f + 2.0f * static_cast<float>(i), 1, -3.0f + 1.5f * static_cast<float>(i % 3)},
              {0.4f, 1, 1});
    place({0, 2, 6.2f}, {0.1f, 0.1f, 1});
}

void look(Stage& stage, const Look& look) {
    stage.frame.view.size_px = {240, 160};
    if (look.orthographic) {
        stage.look_flat(look.eye_m, look.target_m, k_half_height_m);
    } else {
        stage.look(look.eye_m, look.target_m);
    }
    // Bright enough to show where hulls end: light fades towards its radius by the square of what is missing.
    const float reach_m = std::min(look.radius_m, 20.0f);
    stage.frame.lights = {{.position_m = look.lamp_m - stage.eye,
                           .radius_m = look.radius_m,
                           .intensity = glm::vec3{100.0f * reach_m * reach_m},
                           .cos_outer = look.cos_outer,
                           .direction = look.direction,
                           .cos_inner = look.cos_outer}};
}

Picture drawn_by(Stage& stage, LightVolume volume, bool queries) {
    stage.settings.lighting = {.path = render::LightingPath::volumes, .volume = volume, .queries = queries};
    return stage.draw();
}

std::size_t lit_texels(const Picture& picture) {
    return static_cast<std::size_t>(std::count_if(picture.linear.begin(), picture.linear.end(),
                                                  [](const glm::vec4& texel) { return texel.x > 0.0f; }));
}

class LightVolumesOf : public testing::TestWithParam<Look> {};

TEST_P(LightVolumesOf, LightTheSamePixelsAsQuadsAndAsSolids) {
    Stage stage;
    furnish(stage);
    look(stage, GetParam());
    const Picture quad = drawn_by(stage, LightVolume::quad, false);
    EXPECT_GT(lit_texels(quad), 25u);
    for (const bool queries : {false, true}) {
        const Picture solid = drawn_by(stage, LightVolume::solid, queries);
        // One lamp alone is rounded once, from the same values.
        EXPECT_EQ(solid.linear, quad.linear) << (queries ? "with queries" : "without queries");
    }
}

INSTANTIATE_TEST_SUITE_P(Looks, LightVolumesOf, testing::ValuesIn(k_looks),
                         [](const testing::TestParamInfo<Look>& tested) {
                             std::string name = tested.param.name;
                             std::erase(name, ',');
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

TEST(LightVolumes, AreEachJudgedByTheirOwnQueries) {
    Stage stage;
    furnish(stage);
    look(stage, {.lamp_m = {0, 4, 0}, .radius_m = 6, .cos_outer = 0.8f});
    const systems::FrameLight spot = stage.frame.lights.front();
    const systems::FrameLight in_the_sky{
        .position_m = glm::vec3{0, 6, 0} - stage.eye, .radius_m = 1.0f, .intensity = glm::vec3{100.0f}};
    stage.frame.lights = {in_the_sky, spot};
    const Picture quad = drawn_by(stage, LightVolume::quad, false);
    EXPECT_GT(lit_texels(quad), 25u);
    EXPECT_EQ(drawn_by(stage, LightVolume::solid, true).linear, quad.linear);
}

TEST(LightVolumes, AreDrawnTogetherWhereTheyAreAlike) {
    Stage stage;
    furnish(stage);
    look(stage, {.lamp_m = {0, 1, 0}, .radius_m = 2});
    const systems::FrameLight lamp = stage.frame.lights.front();
    systems::FrameLight spot = lamp;
    spot.cos_outer = 0.8f;
    systems::FrameLight around = lamp;
    around.radius_m = 20.0f;
    systems::FrameLight spot_around = around;
    spot_around.direction = -glm::normalize(lamp.position_m);
    spot_around.cos_outer = 0.8f;
    const auto drawn = [&](const std::vector<systems::FrameLight>& lights, bool queries) {
        stage.frame.lights = lights;
        return drawn_by(stage, LightVolume::solid, queries).feedback;
    };
    const systems::Feedback none = drawn({}, false);
    const auto calls = [&](const std::vector<systems::FrameLight>& lights, bool queries = false) {
        return drawn(lights, queries).draws - none.draws;
    };
    EXPECT_EQ(calls({lamp}), 1u);
    EXPECT_EQ(calls({lamp, lamp, lamp}), 1u);
    EXPECT_EQ(calls({lamp, spot, around, spot_around, lamp, spot}), 4u) << "a shape, and a side of it";
    EXPECT_EQ(calls({lamp, spot, around, around, lamp}, true), 7u) << "tested and drawn one by one outside";
    EXPECT_EQ(drawn({lamp}, false).triangles - none.triangles, 80u);
    EXPECT_EQ(drawn({spot, spot_around}, false).triangles - none.triangles, 60u);
}

}  // namespace
