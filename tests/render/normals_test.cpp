// Which way surfaces face.
#include <gtest/gtest.h>

#include <cmath>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

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

}  // namespace
