#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "game/inspect_json.h"
#include "game/inspect_text.h"

namespace rambla::game {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

assets::Mesh skinned_triangle() {
    assets::Mesh mesh;
    mesh.name = "skin";
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.joints.assign(3, {0, 1, 0, 0});
    mesh.weights.assign(3, {0.5f, 0.5f, 0, 0});
    mesh.morphs.resize(1);
    mesh.morphs[0].name = "smile";
    mesh.morphs[0].positions.assign(3, glm::vec3{0.1f});
    mesh.indices = {0, 1, 2};
    for (const glm::vec3& position : mesh.positions)
        mesh.bounds.expand(position);
    return mesh;
}

/// A figure of two joints that two nodes show, with a clip, lights and cameras of each kind.
assets::GltfWithFacts figure() {
    assets::GltfWithFacts out;
    assets::Scene& scene = out.scene;
    scene.images = {{.name = "coat", .width = 4, .height = 2, .texels = std::vector<std::byte>(32)}};
    scene.textures = {{.name = "a", .image = 0, .colour_space = assets::ColourSpace::srgb, .sampler = {}},
                      {.name = "b", .image = 0, .colour_space = assets::ColourSpace::linear, .sampler = {}}};
    scene.materials.resize(1);
    scene.materials[0].name = "cloth";
    scene.materials[0].transmission = 0.25f;
    scene.materials[0].light_map_strength = 2.5f;
    scene.materials[0].light_map_texture = {.texture = 0, .uv_set = 1};
    scene.materials[0].base_colour_texture.texture = 0;
    scene.meshes = {skinned_triangle()};
    scene.models = {{.name = "figure", .parts = {{0, 0}}, .morph_weights = {0.5f}}};
    scene.cameras.resize(2);
    scene.cameras[0].vertical_fov_rad = 0.5f;
    scene.cameras[1].kind = assets::CameraKind::orthographic;
    scene.lights = {{.name = "lamp", .kind = assets::LightKind::spot, .range_m = 7.0f}};
    scene.nodes.resize(4);
    scene.nodes[0].children = {2, 3};
    scene.nodes[0].model = 0;
    scene.nodes[0].skeleton = 0;
    scene.nodes[1].model = 0;
    scene.nodes[1].coarser = {0};
    scene.nodes[1].screen_coverage = {0.5f, 0.1f};
    scene.nodes[2].name = "hip";
    scene.nodes[3].name = "knee";
    scene.skeletons = {
        {.name = "bones", .joints = {2, 3}, .joint_from_mesh = std::vector<glm::mat4>(2, glm::mat4{1.0f})}};
    scene.clips = {{.name = "walk",
                    .duration_s = 1.5f,
                    .channels = {{.node = 2,
                                  .path = assets::AnimatedPath::rotation,
                                  .interpolation = assets::Interpolation::cubic_spline,
                                  .width = 4,
                                  .times_s = {0.0f, 1.5f},
                                  .values = std::vector<float>(24)},
                                 {.node = 3,
                                  .interpolation = assets::Interpolation::step,
                                  .times_s = {0.5f},
                                  .values = std::vector<float>(3)}}}};
    scene.roots = {0};
    out.facts.version = "2.0";
    out.facts.scenes = {{.name = "stage", .roots = {0}}};
    out.facts.material_extensions = {{"KHR_materials_transmission"}};
    out.facts.images = {{.source = "coat.png", .format = "png", .encoded_bytes = 99}};
    return out;
}

TEST(Inspection, TellsSkeletonsClipsAndMorphTargets) {
    const Json result = inspection("figure.glb", figure(), {"something was odd"});
    EXPECT_EQ(result["skeletons"][0]["joint_count"], 2);
    EXPECT_EQ(result["skeletons"][0]["joint_names"], Json::array({"hip", "knee"}));
    const Json& clip = result["clips"][0];
    EXPECT_EQ(clip["duration_s"], 1.5);
    EXPECT_EQ(clip["channels"], 2);
    EXPECT_EQ(clip["keys"], 3);
    EXPECT_EQ(clip["nodes"], Json::array({2, 3}));
    EXPECT_EQ(clip["paths"], Json::array({"rotation", "translation"}));
    EXPECT_EQ(clip["interpolations"], Json::array({"cubic spline", "step"}));
    EXPECT_EQ(result["meshes"][0]["morph_targets"], Json::array({"smile"}));
    EXPECT_EQ(result["models"][0]["morph_weights"], Json::array({0.5}));
    EXPECT_EQ(result["nodes"][0]["skeleton"], 0);
    EXPECT_EQ(result["nodes"][1]["coarser"], Json::array({0}));
    EXPECT_EQ(result["warnings"], Json::array({"something was odd"}));
}

TEST(Inspection, CountsTrianglesByNodeAndMemoryOnce) {
    const Json result = inspection("figure.glb", figure(), {});
    EXPECT_EQ(result["totals"]["triangles_of_all_nodes"], 2);
    // Three vertices of position, normal, joints, weights and one morph target, and three indices.
    constexpr int k_mesh_bytes = 3 * (12 + 12 + 8 + 16 + 12) + 3 * 4;
    constexpr int k_clip_bytes = (2 + 24 + 1 + 3) * 4;
    EXPECT_EQ(result["meshes"][0]["bytes"], k_mesh_bytes);
    EXPECT_EQ(result["totals"]["mesh_bytes"], k_mesh_bytes);
    EXPECT_EQ(result["totals"]["clip_bytes"], k_clip_bytes);
    EXPECT_EQ(result["totals"]["memory_bytes"], k_mesh_bytes + k_clip_bytes + 32);
    EXPECT_EQ(result["totals"]["encoded_image_bytes"], 99);
    EXPECT_EQ(result["meshes"][0]["attributes"], Json::array({"position", "normal", "joints", "weights"}));
    EXPECT_EQ(result["meshes"][0]["bounds_m"]["max"], Json::array({2.0, 3.0, 0.0}));
}

TEST(Inspection, TellsMaterialsImagesCamerasAndLights) {
    const Json result = inspection("figure.glb", figure(), {});
    EXPECT_EQ(result["materials"][0]["extensions"], Json::array({"KHR_materials_transmission"}));
    EXPECT_EQ(result["materials"][0]["transmission"], 0.25);
    EXPECT_EQ(result["materials"][0]["textures"]["base_colour"]["texture"], 0);
    EXPECT_EQ(result["materials"][0]["textures"]["light_map"]["uv_set"], 1);
    EXPECT_EQ(result["materials"][0]["light_map_strength"], 2.5);
    EXPECT_EQ(result["images"][0]["colour_spaces"], Json::array({"linear", "sRGB"}));
    EXPECT_EQ(result["images"][0]["width_px"], 4);
    EXPECT_EQ(result["images"][0]["encoding"], "png");
    EXPECT_EQ(result["cameras"][0]["kind"], "perspective");
    EXPECT_NEAR(result["cameras"][0]["vertical_fov_deg"].get<double>(), 28.6479, 1e-4);
    EXPECT_EQ(result["cameras"][1]["kind"], "orthographic");
    EXPECT_EQ(result["lights"][0]["range_m"], 7.0);
    EXPECT_EQ(result["nodes"][2]["parent"], nullptr);
}

TEST(InspectionText, HasATableForEachKindOfThingThatThereIs) {
    const std::string text = inspection_text(inspection("figure.glb", figure(), {"something was odd"}));
    for (const char* const title : {"scenes (1)", "nodes (4)", "models (1)", "meshes (1)", "materials (1)",
                                    "textures (2)", "images (1)", "skeletons (1)", "clips (1)", "cameras (2)",
                                    "lights (1)", "warnings (1)\n  something was odd"})
        EXPECT_THAT(text, HasSubstr(title));
    assets::GltfWithFacts bare = figure();
    bare.scene.clips.clear();
    EXPECT_THAT(inspection_text(inspection("bare.glb", bare, {})),
                AllOf(Not(HasSubstr("clips (")), Not(HasSubstr("warnings"))));
}

TEST(InspectionText, LongTablesAreCutAndNamesCannotPlayWithTheTerminal) {
    assets::GltfWithFacts many = figure();
    many.scene.nodes.resize(1000);
    many.scene.nodes[1].name = "\x1b[31mred";
    many.scene.nodes[2].name = std::string(100, 'x');
    many.scene.nodes[3].name.clear();
    for (int i = 0; i < 60; ++i)
        many.scene.nodes[3].name += "é";
    const std::string text = inspection_text(inspection("many.glb", many, {}));
    EXPECT_THAT(text, HasSubstr("nodes (1000)"));
    EXPECT_THAT(text, HasSubstr("... and 960 more"));
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_THAT(text, AllOf(HasSubstr("xxx..."), Not(HasSubstr(std::string(50, 'x')))));
    EXPECT_THAT(text, HasSubstr("éé... "));
}

}  // namespace
}  // namespace rambla::game
