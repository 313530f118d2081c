#include "assets/export/gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assets/export/gltf_buffer.h"
#include "assets/export/gltf_geometry.h"
#include "assets/import/gltf_facts.h"
#include "import_support.h"
#include "scene_equality.h"
#include "support/sample_scenes.h"

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;

Scene written_and_read(const Scene& scene) {
    const ScratchFolder folder;
    export_gltf(folder.path() / "again.glb", scene);
    return import_gltf(folder.path() / "again.glb");
}

TEST(GltfExport, EverythingThatStandsComesBackEqual) {
    const LogCapture log;
    const Scene scene = standing_scene();
    expect_equal(scene, written_and_read(scene));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfExport, EverythingThatMovesComesBackEqual) {
    const LogCapture log;
    const Scene scene = moving_scene();
    expect_equal(scene, written_and_read(scene));
    EXPECT_EQ(log.text(), "");
}

/// @param expected  how many files there must be
void expect_all_come_back(const std::filesystem::path& folder, std::size_t expected) {
    const LogCapture log;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder}) {
        const std::filesystem::path& file = entry.path();
        if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
        SCOPED_TRACE(file.string());
        ++files;
        const Scene first = import_gltf(file);
        expect_equal(first, written_and_read(first));
    }
    EXPECT_EQ(files, expected);
}

TEST(GltfCorpusExport, ModelsComeBackEqual) {
    const std::filesystem::path folder = corpus("GltfCorpusExport.ModelsComeBackEqual: 47 files");
    if (!folder.empty()) expect_all_come_back(folder / "models", 47);
}

TEST(GltfCorpusExport, CharactersComeBackEqual) {
    const std::filesystem::path folder = corpus("GltfCorpusExport.CharactersComeBackEqual: 2 files");
    if (!folder.empty()) expect_all_come_back(folder / "characters", 2);
}

TEST(GltfCorpusExport, ScenesComeBackEqual) {
    const std::filesystem::path folder = corpus("GltfCorpusExport.ScenesComeBackEqual: 45 files");
    if (!folder.empty()) expect_all_come_back(folder / "scenes", 45);
}

TEST(GltfExport, ModelsOfDifferentMorphTargetsGetThoseThatTheyLack) {
    Scene scene = moving_scene();
    const std::size_t vertices = scene.meshes[1].positions.size();
    ASSERT_TRUE(scene.meshes[1].morphs.empty());
    scene.models[0].parts.push_back({1, k_none});
    const Scene back = written_and_read(scene);
    ASSERT_EQ(back.models[0].parts.size(), 2u);
    const Mesh& completed = back.meshes[back.models[0].parts[1].mesh];
    ASSERT_EQ(completed.morphs.size(), 2u);
    EXPECT_EQ(completed.morphs[1].positions, std::vector<glm::vec3>(vertices, glm::vec3{0.0f}));
    EXPECT_EQ(back.models[0].morph_weights, scene.models[0].morph_weights);
}

/// glTF 2.0, section 3.7.3.3; the importer would not tell.
TEST(GltfExport, JointsWithoutWeightAreZero) {
    Scene scene = moving_scene();
    scene.meshes[0].joints[0] = {1, 0, 1, 1};
    scene.meshes[0].weights[0] = {0.75f, 0.25f, 0.0f, 0.0f};
    GltfBuffer buffer;
    const nlohmann::json mesh = GltfGeometry{scene, buffer}.mesh_of(scene.models[0]);
    nlohmann::json document;
    buffer.finish(document);
    const nlohmann::json& accessor =
        document["accessors"][mesh["primitives"][0]["attributes"]["JOINTS_0"].get<std::size_t>()];
    const std::size_t offset =
        document["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"];
    glm::u16vec4 first{9};
    std::memcpy(&first, buffer.bytes().data() + offset, sizeof first);
    EXPECT_EQ(first, glm::u16vec4(1, 0, 0, 0));
}

TEST(GltfExport, ColoursAboveOneBecomeIntensity) {
    Scene scene;
    scene.lights = {{.name = "flare", .colour = {3.0f, 0.5f, 0.0f}, .intensity = 2.0f}};
    scene.nodes.resize(1);
    scene.nodes[0].light = 0;
    const Scene back = written_and_read(scene);
    EXPECT_EQ(back.lights[0].colour, glm::vec3(0.75f, 0.125f, 0.0f));
    EXPECT_EQ(back.lights[0].intensity, 8.0f);
}

TEST(GltfExport, WhatGltfDoesNotHaveIsLeftOut) {
    Scene scene = moving_scene();
    scene.meshes[0].indices.clear();
    scene.skeletons[0].joints.clear();
    scene.skeletons[0].joint_from_mesh.clear();
    for (Clip& clip : scene.clips)
        std::erase_if(clip.channels,
                      [](const Channel& channel) { return channel.path != AnimatedPath::weights; });
    const LogCapture log;
    const Scene back = written_and_read(scene);
    EXPECT_EQ(log.text(), "");
    EXPECT_TRUE(back.skeletons.empty());
    EXPECT_TRUE(back.clips.empty()) << "only weights of a model without triangles are left";
    EXPECT_EQ(back.nodes[0].model, k_none);
}

TEST(GltfExport, EmptySceneIsAValidFile) {
    const ScratchFolder folder;
    export_gltf(folder.path() / "empty.glb", Scene{});
    EXPECT_TRUE(import_gltf(folder.path() / "empty.glb").nodes.empty());
}

TEST(GltfExport, FloatImagesAndOtherExtensionsAreRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(export_gltf(folder.path() / "a.obj", Scene{}), Error);
    Scene scene;
    scene.images = {{.name = "sky", .width = 1, .height = 1, .format = PixelFormat::rgba32f, .texels = {}}};
    scene.images[0].texels.resize(16);
    EXPECT_THROW(export_gltf(folder.path() / "a.glb", scene), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(GltfExport, PrototypesStandInASceneOfTheirOwnAndCoarserLevelsInNone) {
    const ScratchFolder folder;
    Scene scene = moving_scene();
    scene.roots = {0, 1};
    export_gltf(folder.path() / "moving.glb", scene);
    const GltfFacts facts = import_gltf_with_facts(folder.path() / "moving.glb").facts;
    ASSERT_EQ(facts.scenes.size(), 2u);
    EXPECT_EQ(facts.default_scene, 0u);
    EXPECT_THAT(facts.scenes[0].roots, ElementsAre(0, 1));
    EXPECT_THAT(facts.scenes[1].roots, ElementsAre(3));
}

}  // namespace
}  // namespace rambla::assets::test
