#include "game/framing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ecs/query.h"
#include "game/stage.h"
#include "systems/components.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

/// A scene of one mesh with the given box, shown by one node.
assets::Scene scene_of(const assets::Bounds& box, const assets::Transform& place) {
    assets::Scene scene;
    assets::Mesh mesh;
    mesh.bounds = box;
    scene.meshes.push_back(mesh);
    assets::Model model;
    model.parts.push_back({0, assets::k_none});
    scene.models.push_back(model);
    assets::Node node;
    node.local = place;
    node.model = 0;
    scene.nodes.push_back(node);
    scene.roots.push_back(0);
    return scene;
}

/// Adds a camera or light node turned by 90° about Y (so that it looks along −X), under a parent that is
/// moved.
std::uint32_t add_turned_node(assets::Scene& scene) {
    const auto parent = static_cast<std::uint32_t>(scene.nodes.size());
    scene.nodes.resize(parent + 2);
    scene.nodes[parent].local.translation_m = {10.0f, 0.0f, 0.0f};
    scene.nodes[parent].local.scale = glm::vec3{2.0f};
    scene.nodes[parent].children = {parent + 1};
    scene.nodes[parent + 1].parent = parent;
    scene.nodes[parent + 1].local.translation_m = {0.0f, 1.0f, 0.0f};
    scene.nodes[parent + 1].local.rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3{0.0f, 1.0f, 0.0f});
    scene.roots.push_back(parent);
    return parent + 1;
}

/// Largest |coordinate| of the box's corners in the picture, where 1 is the rim; infinite behind the eye.
float reach_in_picture(const assets::Bounds& box, const systems::Eye& eye,
                       const systems::WorldPosition& origin, float aspect) {
    const glm::vec3 eye_m = systems::offset_m(origin, eye.place);
    float reach = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point{(corner & 1) != 0 ? box.max.x : box.min.x,
                              (corner & 2) != 0 ? box.max.y : box.min.y,
                              (corner & 4) != 0 ? box.max.z : box.min.z};
        const glm::vec3 seen = glm::conjugate(eye.rotation) * (point - eye_m);
        if (seen.z >= -eye.near_m) return std::numeric_limits<float>::infinity();
        const float scale = 1.0f / (-seen.z * std::tan(0.5f * eye.vertical_fov_rad));
        reach = std::max({reach, std::abs(seen.y) * scale, std::abs(seen.x) * scale / aspect});
    }
    return reach;
}

struct FramedAtAnyScale : testing::TestWithParam<float> {};

TEST_P(FramedAtAnyScale, EverythingIsInThePictureAndFillsAGoodPartOfIt) {
    const float size = GetParam();
    const assets::Bounds box{glm::vec3{-1.0f, 0.0f, 2.0f} * size, glm::vec3{1.0f, 1.5f, 4.0f} * size};
    for (const float aspect : {0.5f, 1.0f, 1.78f}) {
        systems::Eye eye = eye_of(frame_bounds(box, 0.7f, aspect), {});
        eye.vertical_fov_rad = 0.7f;
        const float reach = reach_in_picture(box, eye, {}, aspect);
        EXPECT_LT(reach, 1.0f) << aspect;
        EXPECT_GT(reach, 0.9f) << aspect;
    }
}

INSTANTIATE_TEST_SUITE_P(Metres, FramedAtAnyScale, testing::Values(1e-3f, 1.0f, 100.0f, 1e4f));

TEST(Framing, FarFromTheWorldsOriginTheViewIsTheSame) {
    const assets::Bounds box{{-1.0f, 0.0f, -1.0f}, {1.0f, 2.0f, 1.0f}};
    const systems::WorldPosition far = systems::moved({}, {1.0e6, 0.0, -1.0e6});
    const Orbit orbit = frame_bounds(box, 0.7f, 1.5f);
    const glm::vec3 near_eye = systems::offset_m({}, eye_of(orbit, {}).place);
    const glm::vec3 far_eye = systems::offset_m(far, eye_of(orbit, far).place);
    // Places keep float precision inside a 256 m cell: 3e-5 m at most.
    EXPECT_LT(glm::distance(near_eye, far_eye), 6e-5f);
}

TEST(Framing, APointOrNothingIsFramedToo) {
    for (const assets::Bounds box : {assets::Bounds{}, assets::Bounds{glm::vec3{3.0f}, glm::vec3{3.0f}}}) {
        const Orbit orbit = frame_bounds(box, 0.7f, 1.5f);
        EXPECT_TRUE(std::isfinite(orbit.distance_m) && orbit.distance_m > 1.0f);
        EXPECT_EQ(orbit.target_m, box.empty() ? glm::vec3{0.0f} : glm::vec3{3.0f});
    }
}

TEST(Orbit, BeginsWhereTheEyeIs) {
    const assets::Bounds box{{-1.0f, 0.0f, -1.0f}, {1.0f, 2.0f, 1.0f}};
    const systems::Eye eye = eye_of(frame_bounds(box, 0.7f, 1.5f), {});
    const systems::Eye again = eye_of(orbit_of(eye, box, {}), {}, eye);
    EXPECT_LT(glm::length(systems::offset_m(eye.place, again.place)), 1e-4f);
    // Equal rotations have a product of ±1.
    EXPECT_NEAR(std::abs(glm::dot(eye.rotation, again.rotation)), 1.0f, 1e-5f);
}

TEST(ViewingLight, AFileWithoutLightsStandsInTheLightOfTheTime) {
    const assets::Scene scene = scene_of({glm::vec3{-1.0f}, glm::vec3{1.0f}}, {});
    const ViewingLight noon = viewing_light(scene, {});
    EXPECT_EQ(noon.environment.sun_illuminance, assets::noon().sun_illuminance);
    EXPECT_EQ(noon.exposure_ev, 0.0f);
    const ViewingLight dusk = viewing_light(scene, assets::k_dusk);
    EXPECT_EQ(dusk.environment.sun_illuminance, glm::vec3{0.0f});
    EXPECT_EQ(dusk.environment.direction_to_sun, assets::daylight(assets::k_dusk).direction_to_sun);
    EXPECT_EQ(dusk.exposure_ev, assets::daylight_exposure_ev(assets::k_dusk));
}

TEST(ViewingLight, APointLightMeansNoSunAndADimSky) {
    assets::Scene scene = scene_of({glm::vec3{-1.0f}, glm::vec3{1.0f}}, {});
    scene.lights.push_back({.name = "lamp", .kind = assets::LightKind::point});
    scene.nodes[add_turned_node(scene)].light = 0;
    const assets::Environment light = viewing_light(scene, {}).environment;
    EXPECT_EQ(light.sun_illuminance, glm::vec3{0.0f});
    EXPECT_LT(light.sky_zenith_radiance.z, 0.5f * assets::noon().sky_zenith_radiance.z);
}

TEST(ViewingLight, ADirectionalLightIsTheSun) {
    assets::Scene scene = scene_of({glm::vec3{-1.0f}, glm::vec3{1.0f}}, {});
    scene.lights.push_back({.name = "sun",
                            .kind = assets::LightKind::directional,
                            .colour = {1.0f, 0.5f, 0.25f},
                            .intensity = 4.0f});
    scene.nodes[add_turned_node(scene)].light = 0;
    const assets::Environment light = viewing_light(scene, {}).environment;
    EXPECT_EQ(light.sun_illuminance, (glm::vec3{4.0f, 2.0f, 1.0f}));
    // It shines along −X, so the sun stands at +X.
    EXPECT_LT(glm::distance(light.direction_to_sun, glm::vec3{1.0f, 0.0f, 0.0f}), 1e-5f);
    // A node without extent has no direction: there, no sun.
    scene.nodes.back().local.scale = glm::vec3{0.0f};
    EXPECT_EQ(viewing_light(scene, {}).environment.sun_illuminance, glm::vec3{0.0f});
}

TEST(ViewingLight, ASceneThatKnowsItsTimeStandsUnderItsSky) {
    assets::Scene scene = scene_of({glm::vec3{-1.0f}, glm::vec3{1.0f}}, {});
    scene.time = assets::k_dusk;
    scene.lights.push_back({.name = "lamp", .kind = assets::LightKind::point});
    scene.nodes[add_turned_node(scene)].light = 0;
    const ViewingLight dusk = viewing_light(scene, {});
    const assets::Environment expected = assets::daylight(assets::k_dusk);
    EXPECT_EQ(dusk.environment.sky_zenith_radiance, expected.sky_zenith_radiance);
    EXPECT_EQ(dusk.environment.sun_illuminance, glm::vec3{0.0f});
    EXPECT_EQ(dusk.exposure_ev, assets::daylight_exposure_ev(assets::k_dusk));
    // A sun of its own stands where it says, and what is asked for comes first.
    scene.lights.push_back({.name = "sun", .kind = assets::LightKind::directional, .intensity = 4.0f});
    scene.nodes[add_turned_node(scene)].light = 1;
    EXPECT_EQ(viewing_light(scene, {}).environment.sun_illuminance, glm::vec3{4.0f});
    EXPECT_EQ(viewing_light(scene, {}).environment.sky_zenith_radiance, expected.sky_zenith_radiance);
    EXPECT_EQ(viewing_light(scene, assets::TimeOfDay{}).environment.sky_zenith_radiance,
              assets::noon().sky_zenith_radiance);
}

TEST(ViewingLight, AnAskedForTimeReplacesTheFilesSunAndSky) {
    assets::Scene scene = scene_of({glm::vec3{-1.0f}, glm::vec3{1.0f}}, {});
    scene.lights.push_back({.name = "sun", .kind = assets::LightKind::directional, .intensity = 4.0f});
    scene.nodes[add_turned_node(scene)].light = 0;
    for (const assets::TimeOfDay time : {assets::TimeOfDay{}, assets::k_dusk, assets::TimeOfDay{360}}) {
        const ViewingLight light = viewing_light(scene, time);
        const assets::Environment expected = assets::daylight(time);
        EXPECT_EQ(light.environment.sun_illuminance, expected.sun_illuminance);
        EXPECT_EQ(light.environment.direction_to_sun, expected.direction_to_sun);
        EXPECT_EQ(light.environment.sky_zenith_radiance, expected.sky_zenith_radiance);
        EXPECT_EQ(light.exposure_ev, assets::daylight_exposure_ev(time));
    }
    // Also on stage, where the first directional light becomes the sun, and others shine beside it.
    scene.lights.push_back({.name = "second", .kind = assets::LightKind::directional});
    scene.nodes[add_turned_node(scene)].light = 1;
    scene.lights.push_back({.name = "lamp", .kind = assets::LightKind::point});
    scene.nodes[add_turned_node(scene)].light = 2;
    remove_suns(scene);
    const Stage stage = make_stage(scene, viewing_light(scene, assets::k_dusk).environment, {});
    EXPECT_EQ(stage.world->resource<systems::Sunlight>().environment.sun_illuminance, glm::vec3{0.0f});
    EXPECT_EQ((ecs::Query<const systems::DirectionalLight>{}.count(*stage.world)), 0u);
    EXPECT_EQ((ecs::Query<const systems::LocalLight>{}.count(*stage.world)), 1u);
}

}  // namespace
}  // namespace rambla::game
