#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "assets/generate/lcg.h"
#include "unit/assets/generate_support.h"

namespace rambla::assets::test {
namespace {

std::vector<Node> named(const Scene& scene, const std::string& name) {
    std::vector<Node> found;
    std::copy_if(scene.nodes.begin(), scene.nodes.end(), std::back_inserter(found),
                 [&](const Node& node) { return node.name == name; });
    return found;
}

const Material& material_of(const Scene& scene, const Node& node) {
    return scene.materials[scene.models[node.model].parts.at(0).material];
}

std::size_t triangles(const Scene& scene, const Node& node) {
    std::size_t count = 0;
    for (const ModelPart& part : scene.models[node.model].parts)
        count += scene.meshes[part.mesh].indices.size() / 3;
    return count;
}

TEST(Lcg, GivesTheNumbersWorkedOutByHand) {
    // 12345 · 1664525 + 1013904223 = 21562465348 ≡ 87628868 (mod 2³²); 87628868 / 256 = 342300.
    generate::Lcg lcg{12345};
    EXPECT_EQ(lcg.next(), 342300.0f / 16777216.0f);
    EXPECT_EQ(lcg.next(), 277626.0f / 16777216.0f);
    EXPECT_EQ(lcg.next(), 9112642.0f / 16777216.0f);
    // 777 · 1664525 + 1013904223 = 2307240148, of which the upper 24 bits are 9012656.
    EXPECT_EQ(generate::Lcg{777}.next(), 9012656.0f / 16777216.0f);
}

TEST(Blocks, AreAsTheComparisonSays) {
    const Place place = generate_place("blocks", 1);
    const Scene& scene = place.scene;
    const std::vector<Node> boxes = named(scene, "box");
    ASSERT_EQ(boxes.size(), 400u);
    // 4 + 26 · the numbers above; box 20 is the first of the second row.
    EXPECT_NEAR(boxes[0].local.scale.y, 4.530469f, 1e-5f);
    EXPECT_NEAR(boxes[1].local.scale.y, 4.430243f, 1e-5f);
    EXPECT_NEAR(boxes[2].local.scale.y, 18.122051f, 1e-5f);
    EXPECT_NEAR(boxes[20].local.scale.y, 29.835637f, 1e-5f);
    EXPECT_NEAR(boxes[399].local.scale.y, 22.817881f, 1e-5f);
    EXPECT_EQ(boxes[0].local.translation_m, glm::vec3(-171, 0, -171));
    EXPECT_EQ(boxes[1].local.translation_m, glm::vec3(-171, 0, -153));
    EXPECT_EQ(boxes[20].local.translation_m, glm::vec3(-153, 0, -171));
    EXPECT_EQ(boxes[0].local.scale.x, 10.0f);
    EXPECT_EQ(boxes[0].local.scale.z, 10.0f);
    EXPECT_EQ(triangles(scene, boxes[0]), 12u);
    EXPECT_EQ(scene.meshes[scene.models[boxes[0].model].parts[0].mesh].bounds.min,
              glm::vec3(-0.5f, 0, -0.5f));
    EXPECT_EQ(scene.meshes[scene.models[boxes[0].model].parts[0].mesh].bounds.max, glm::vec3(0.5f, 1, 0.5f));
    EXPECT_EQ(material_of(scene, boxes[0]).base_colour, glm::vec4(0.70f, 0.66f, 0.60f, 1.0f));
    EXPECT_EQ(material_of(scene, boxes[0]).roughness, 0.8f);
    EXPECT_EQ(material_of(scene, boxes[0]).metalness, 0.0f);

    ASSERT_EQ(scene.lights.size(), 16u);
    const Node sixth = named(scene, "light-6").at(0);
    EXPECT_EQ(sixth.local.translation_m, glm::vec3(36, 14, -36));
    EXPECT_EQ(scene.lights[sixth.light].colour, glm::vec3(1.0f, 0.6f, 0.3f));
    EXPECT_EQ(scene.lights[7].colour, glm::vec3(0.3f, 0.6f, 1.0f));
    EXPECT_EQ(scene.lights[7].intensity, 300.0f);
    EXPECT_EQ(scene.lights[7].range_m, 20.0f);
}

TEST(Blocks, HaveTheComparisonsLightGroundAndCamera) {
    const Place place = generate_place("blocks", 1);
    const Node ground = named(place.scene, "ground").at(0);
    const Mesh& plane = place.scene.meshes[place.scene.models[ground.model].parts.at(0).mesh];
    EXPECT_EQ(plane.bounds.min, glm::vec3(-200, 0, -200));
    EXPECT_EQ(plane.bounds.max, glm::vec3(200, 0, 200));
    EXPECT_EQ(plane.normals.at(0), glm::vec3(0, 1, 0));
    EXPECT_EQ(material_of(place.scene, ground).base_colour, glm::vec4(0.35f, 0.35f, 0.35f, 1.0f));
    EXPECT_NEAR(
        glm::distance(place.environment.direction_to_sun, glm::normalize(glm::vec3(0.5f, 1.0f, 0.3f))), 0.0f,
        1e-6f);
    EXPECT_EQ(place.environment.sun_illuminance, glm::vec3(3.0f, 3.0f * 0.96f, 3.0f * 0.90f));
    EXPECT_EQ(place.environment.ground_radiance, glm::vec3(0.35f));
    EXPECT_EQ(place.environment.sky_visibility, 0.0f) << "all ambient light is ground_radiance";
    ASSERT_EQ(place.walk.size(), 100u);
    EXPECT_EQ(place.walk[0].eye_m, glm::vec3(130, 70, 0));
    EXPECT_NEAR(glm::distance(place.walk[50].eye_m, glm::vec3(0, 70, 130)), 0.0f, 1e-4f);
    EXPECT_NEAR(glm::distance(place.walk[25].eye_m, glm::vec3(91.9239f, 70, 91.9239f)), 0.0f, 1e-3f);
    EXPECT_EQ(place.walk[99].target_m, glm::vec3(0.0f));
    EXPECT_NEAR(place.walk[99].time_s, 1.65f, 1e-6f);
    EXPECT_NEAR(glm::degrees(place.walk_fov_rad), 60.0f, 1e-4f);
    EXPECT_EQ(place.walk_near_m, 0.5f);
}

TEST(Agents, AreAsTheComparisonSays) {
    const Place place = generate_place("agents", 1);
    ASSERT_EQ(place.movers.size(), 10'000u);
    EXPECT_EQ(place.mover_reach_m, 190.0f);
    EXPECT_TRUE(place.scene.lights.empty());
    // x = (9012656 / 2²⁴ − 0.5) · 380 and so on, in Python's doubles.
    const auto expect = [&](std::size_t n, double x, double z, double heading, double speed) {
        const MoverStart& mover = place.movers[n];
        const Node& node = place.scene.nodes[mover.node];
        EXPECT_NEAR(node.local.translation_m.x, x, 2e-5) << n;
        EXPECT_NEAR(node.local.translation_m.z, z, 2e-5) << n;
        EXPECT_NEAR(mover.heading_rad, heading, 1e-6) << n;
        EXPECT_NEAR(mover.speed_m_s, speed, 1e-6) << n;
    };
    expect(0, 14.134540557861328, 97.04912424087524, 5.264438181072629, 2.7183327674865723);
    expect(1, -103.22333693504333, 35.39746046066284, 1.630486380485223, 2.963547468185425);
    expect(9999, -22.8981876373291, -103.08274984359741, 2.8712663649348062, 3.4418489933013916);
    const Node& first = place.scene.nodes[place.movers[0].node];
    EXPECT_EQ(triangles(place.scene, first), 24u);
    EXPECT_EQ(material_of(place.scene, first).base_colour, glm::vec4(0.80f, 0.30f, 0.20f, 1.0f));
    const Mesh& mesh = place.scene.meshes[place.scene.models[first.model].parts.at(0).mesh];
    EXPECT_EQ(mesh.bounds.min, glm::vec3(-0.2f, 0.0f, -0.3f));
    EXPECT_EQ(mesh.bounds.max, glm::vec3(0.2f, 1.7f, 0.3f));
    const glm::vec3 ahead = first.local.rotation * glm::vec3{1, 0, 0};
    EXPECT_NEAR(ahead.x, std::cos(5.264438181), 1e-5);
    EXPECT_NEAR(ahead.z, std::sin(5.264438181), 1e-5);
}

TEST(FixedScenes, AreTheSameForEverySeedAndTakeNeitherParametersNorATime) {
    for (const char* const name : {"blocks", "agents"}) {
        EXPECT_EQ(node_hash(generate_place(name, 1).scene), node_hash(generate_place(name, 2).scene));
        EXPECT_THROW((void)generate_place(std::string{name} + ":n=1", 1), std::invalid_argument);
        EXPECT_THROW((void)generate_place(std::string{name} + ":", 1), std::invalid_argument);
        EXPECT_THROW((void)generate_place(name, 1, k_dusk), std::invalid_argument);
    }
}

}  // namespace
}  // namespace rambla::assets::test
