#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string k_mesh = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";

Draft corners() {
    Draft draft;
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    return draft;
}

std::string instanced(const std::string& attributes, const std::string& mesh = R"("mesh":0,)") {
    return k_mesh + R"(,"nodes":[{)" + mesh + R"("name":"tree","extensions":{"EXT_mesh_gpu_instancing":{)" +
           attributes + R"(}}},{"name":"other"}],"scenes":[{"nodes":[0]}])";
}

TEST(GltfInstancing, EachInstanceIsAChildBehindAllOtherNodes) {
    Draft draft = corners();
    draft.add<float>({1, 2, 3, 4, 5, 6}, "VEC3");
    draft.add<std::int8_t>({0, 0, 0, 127, 127, 0, 0, 0}, "VEC4", R"(,"normalized":true)");
    draft.add<float>({1, 1, 1, 2, 2, 2}, "VEC3");
    const LogCapture log;
    const Scene scene = draft.load(
        instanced(R"("attributes":{"TRANSLATION":1,"ROTATION":2,"SCALE":3,"_ID":99})") +
        R"(,"extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["EXT_mesh_gpu_instancing"])");
    ASSERT_EQ(scene.nodes.size(), 4u);
    EXPECT_EQ(scene.nodes[0].model, k_none);
    EXPECT_THAT(scene.nodes[0].children, ElementsAre(2, 3));
    EXPECT_EQ(scene.nodes[1].name, "other");
    EXPECT_EQ(scene.nodes[3].parent, 0u);
    EXPECT_EQ(scene.nodes[3].model, 0u);
    EXPECT_EQ(scene.nodes[3].local.translation_m, glm::vec3(4, 5, 6));
    EXPECT_EQ(scene.nodes[3].local.rotation.x, 1.0f);
    EXPECT_EQ(scene.nodes[3].local.scale, glm::vec3(2));
    EXPECT_THAT(scene.roots, ElementsAre(0));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfInstancing, InstancesKeepTheSkeletonAndTheMorphWeights) {
    Draft draft = corners();
    draft.add<std::uint8_t>(std::vector<std::uint8_t>(12, 0), "VEC4");
    draft.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const Scene scene = draft.load(
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},)"
        R"("targets":[{"POSITION":0}]}]}],"skins":[{"joints":[1]}],"nodes":[{"mesh":0,"skin":0,"weights":[0.5],)"
        R"("extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}},{}])");
    ASSERT_EQ(scene.nodes.size(), 5u);
    EXPECT_EQ(scene.nodes[0].skeleton, k_none);
    EXPECT_THAT(scene.nodes[0].morph_weights, IsEmpty());
    EXPECT_EQ(scene.nodes[4].skeleton, 0u);
    EXPECT_THAT(scene.nodes[4].morph_weights, ElementsAre(0.5f));
}

TEST(GltfInstancing, InstancesWithoutAPlaceAreLeftOut) {
    Draft draft = corners();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    draft.add<float>({1, 2, 3, nan, 5, 6, 0, 0, 0}, "VEC3");
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}, "VEC4");
    const LogCapture log;
    const Scene scene = draft.load(instanced(R"("attributes":{"TRANSLATION":1,"ROTATION":2})"));
    EXPECT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("2 instances have no finite place"));
}

TEST(GltfInstancing, NothingToRepeatLeavesTheNodeAsItIs) {
    const LogCapture log;
    EXPECT_EQ(corners().load(instanced(R"("attributes":{})")).nodes[0].model, 0u);
    EXPECT_EQ(corners().load(instanced("")).nodes[0].model, 0u);
    EXPECT_EQ(corners().load(instanced(R"("attributes":{"TRANSLATION":0})", "")).nodes.size(), 2u);
    EXPECT_EQ(log.lines(), 3);
}

TEST(GltfInstancing, AttributesThatDoNotFitAreRefused) {
    Draft draft = corners();
    draft.add<float>({1, 2, 3}, "VEC3");
    EXPECT_THAT(draft.error(instanced(R"("attributes":{"TRANSLATION":0,"SCALE":1})")),
                HasSubstr("nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE: 1 elements"));
    EXPECT_THAT(draft.error(instanced(R"("attributes":{"ROTATION":1})")),
                HasSubstr("attributes.ROTATION: 3 components, expected 4"));
    EXPECT_THAT(draft.error(instanced(R"("attributes":{"TRANSLATION":"0"})")),
                HasSubstr("attributes.TRANSLATION: the string \"0\", expected a whole number"));
}

TEST(GltfInstancing, InstancesCannotFillTheMemory) {
    Draft draft = corners();
    draft.add_text(R"({"componentType":5126,"count":900000,"type":"VEC3"})");
    EXPECT_THAT(draft.error(instanced(R"("attributes":{"TRANSLATION":1})")),
                HasSubstr("more vertices, indices or particles"));
}

std::string levels(const std::string& ids, const std::string& more = {}) {
    return R"("extensions":{"MSFT_lod":{"ids":[)" + ids + "]}}" + more;
}

TEST(GltfLevels, CoarserNodesAndTheirCoverageAreRead) {
    const LogCapture log;
    const Scene scene = Draft{}.load(
        R"(,"nodes":[{)" + levels("2,3", R"(,"extras":{"MSFT_screencoverage":[0.5,0.25,0.01]})") +
        R"(},{},{"children":[4]},{},{}],"extensionsUsed":["MSFT_lod"],"extensionsRequired":["MSFT_lod"])");
    EXPECT_THAT(scene.nodes[0].coarser, ElementsAre(2, 3));
    EXPECT_THAT(scene.nodes[0].screen_coverage, ElementsAre(0.5f, 0.25f, 0.01f));
    EXPECT_THAT(scene.roots, ElementsAre(0, 1));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfLevels, CoverageOfAnotherLengthIsNoCoverage) {
    const Scene scene =
        Draft{}.load(R"(,"nodes":[{)" + levels("1", R"(,"extras":{"MSFT_screencoverage":[0.5]})") + "},{}]");
    EXPECT_THAT(scene.nodes[0].screen_coverage, IsEmpty());
}

TEST(GltfLevels, LoopsOfLevelsAreRefused) {
    EXPECT_THAT(Draft{}.error(R"(,"nodes":[{)" + levels("1") + "},{" + levels("0") + "}]"),
                HasSubstr("nodes[0]: a loop of children or levels of detail"));
    // A level above the node that it serves.
    EXPECT_THAT(Draft{}.error(R"(,"nodes":[{"children":[1]},{)" + levels("0") + "}]"),
                HasSubstr("nodes[0]: a loop"));
    EXPECT_THAT(Draft{}.error(R"(,"nodes":[{)" + levels("7") + "}]"),
                HasSubstr("nodes[0].extensions.MSFT_lod.ids[0]: node 7"));
}

TEST(GltfLevels, ManyLevelsCostTheirOwnTimeOnly) {
    // Looking each of them up in a list of all of them would take minutes.
    std::string ids;
    std::string nodes;
    for (int i = 1; i <= 100'000; ++i) {
        ids.append(i > 1 ? "," : "").append(std::to_string(i));
        nodes.append(",{}");
    }
    EXPECT_EQ(Draft{}.load(R"(,"nodes":[{)" + levels(ids) + "}" + nodes + "]").nodes[0].coarser.size(),
              100'000u);
}

TEST(GltfLevels, NodesOfTheSceneAndSharedOnesAreNoLevels) {
    for (const std::string& nodes :
         {"{" + levels("0") + "}", "{" + levels("1,1") + "},{}",
          "{" + levels("2") + R"(},{"children":[2]},{})", "{" + levels("2") + "},{" + levels("2") + "},{}",
          "{" + levels("2,3") + R"(},{"children":[3]},{},{})"}) {
        const LogCapture log;
        const Scene scene = Draft{}.load(R"(,"nodes":[)" + nodes + "]");
        EXPECT_EQ(log.lines(), 1) << nodes;
        EXPECT_THAT(log.text(), HasSubstr("extensions.MSFT_lod: levels of detail are left out"));
    }
    const LogCapture log;
    const Scene scene = Draft{}.load(R"(,"nodes":[{)" + levels("1") + R"(},{}],"scenes":[{"nodes":[0,1]}])");
    EXPECT_THAT(scene.nodes[0].coarser, IsEmpty());
    EXPECT_THAT(scene.roots, ElementsAre(0, 1));
    EXPECT_EQ(log.lines(), 1);
}

Scene import_material(const std::string& extensions) {
    return Draft{}.load(
        R"(,"images":[{"uri":"data:image/png;base64,AA=="}],"textures":[{"source":0},{"source":0}],)"
        R"("materials":[{"extensions":{)" +
        extensions + "}}]");
}

TEST(GltfMaterials, DielectricsAreReadWithTheirTextures) {
    const Material material =
        import_material(
            R"("KHR_materials_ior":{"ior":1.33},"KHR_materials_specular":{"specularFactor":0.5,)"
            R"("specularColorFactor":[2,0.5,-1],"specularTexture":{"index":0,"texCoord":1,"extensions":)"
            R"({"KHR_texture_transform":{"offset":[0.5,0.25],"scale":[2,3]}}},"specularColorTexture":{"index":1}},)"
            R"("KHR_materials_transmission":{"transmissionFactor":0.75,"transmissionTexture":{"index":0}})")
            .materials[0];
    EXPECT_FLOAT_EQ(material.ior, 1.33f);
    EXPECT_EQ(material.specular, 0.5f);
    EXPECT_EQ(material.specular_colour, glm::vec3(2, 0.5f, 0));
    EXPECT_EQ(material.transmission, 0.75f);
    EXPECT_EQ(material.specular_texture.uv_set, 1u);
    EXPECT_EQ(material.specular_texture.offset, glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(material.specular_texture.scale, glm::vec2(2, 3));
    const Scene scene = import_material(
        R"("KHR_materials_specular":{"specularTexture":{"index":0},"specularColorTexture":{"index":0}})");
    EXPECT_EQ(scene.textures[scene.materials[0].specular_texture.texture].colour_space, ColourSpace::linear);
    EXPECT_EQ(scene.textures[scene.materials[0].specular_colour_texture.texture].colour_space,
              ColourSpace::srgb);
}

TEST(GltfMaterials, DefaultsAndStrangeNumbersStayInRange) {
    const auto ior = [](const std::string& value) {
        return import_material(R"("KHR_materials_ior":{)" + value + "}").materials[0].ior;
    };
    EXPECT_EQ(ior(""), 1.5f);
    EXPECT_EQ(ior(R"("ior":0)"), 0.0f);
    EXPECT_EQ(ior(R"("ior":0.5)"), 1.0f);
    EXPECT_EQ(ior(R"("ior":-1)"), 1.0f);
    const Material material = import_material(R"("KHR_materials_specular":{"specularFactor":7},)"
                                              R"("KHR_materials_transmission":{})")
                                  .materials[0];
    EXPECT_EQ(material.specular, 1.0f);
    EXPECT_EQ(material.specular_colour, glm::vec3(1));
    EXPECT_EQ(material.transmission, 0.0f);
    const Draft draft;
    EXPECT_THAT(draft.error(R"(,"materials":[{"extensions":{"KHR_materials_specular":{"specularTexture":)"
                            R"({"index":3}}}}])"),
                HasSubstr("materials[0].extensions.KHR_materials_specular.specularTexture.index: texture 3"));
}

TEST(GltfMaterials, HeightsAreReadFromExtras) {
    const auto import = [](const std::string& height) {
        Draft draft;
        return draft.load(R"(,"images":[{"uri":"data:image/png;base64,AA=="}],"textures":[{"source":0}],)"
                          R"("materials":[{"extras":{"ramblaHeight":)" +
                          height + "}}]");
    };
    const Scene scene = import(R"({"index":0,"texCoord":1,"depth":0.125})");
    const Material& material = scene.materials[0];
    ASSERT_EQ(material.height_texture.texture, 0u);
    EXPECT_EQ(scene.textures[0].colour_space, ColourSpace::linear);
    EXPECT_EQ(material.height_texture.uv_set, 1u);
    EXPECT_EQ(material.height_depth, 0.125f);
    for (const auto& [depth, used] : {std::pair{"9", k_max_height_depth}, {"-9", 0.0f}, {"\"deep\"", 0.0f}}) {
        const LogCapture log;
        EXPECT_EQ(import(std::string{R"({"index":0,"depth":)"} + depth + "}").materials[0].height_depth,
                  used);
        EXPECT_THAT(log.text(), HasSubstr("materials[0].extras.ramblaHeight.depth")) << depth;
    }
    for (const char* const other :
         {R"({"index":1,"depth":0.1})", R"({"depth":0.1})", "7", "[0]", R"("rough")"}) {
        const LogCapture log;
        EXPECT_EQ(import(other).materials[0].height_texture.texture, k_none) << other;
        EXPECT_THAT(log.text(), HasSubstr("materials[0].extras.ramblaHeight")) << other;
    }
}

TEST(GltfMaterials, LightMapsAreReadFromExtras) {
    const auto import = [](const std::string& light_map) {
        Draft draft;
        return draft.load(R"(,"images":[{"uri":"data:image/png;base64,AA=="}],"textures":[{"source":0}],)"
                          R"("materials":[{"extras":{"ramblaLightMap":)" +
                          light_map + "}}]");
    };
    const Scene scene = import(
        R"({"index":0,"texCoord":1,"strength":12.5,"extensions":{"KHR_texture_transform":{"scale":[2,3]}}})");
    const Material& material = scene.materials[0];
    ASSERT_EQ(material.light_map_texture.texture, 0u);
    EXPECT_EQ(scene.textures[0].colour_space, ColourSpace::srgb);
    EXPECT_EQ(material.light_map_texture.uv_set, 1u);
    EXPECT_EQ(material.light_map_texture.scale, glm::vec2(2, 3));
    EXPECT_EQ(material.light_map_strength, 12.5f);
    {
        const LogCapture log;
        EXPECT_EQ(import(R"({"index":0})").materials[0].light_map_strength, 1.0f);
        EXPECT_THAT(log.text(), Not(HasSubstr("ramblaLightMap"))) << "a strength is not called for";
    }
    EXPECT_TRUE(std::isfinite(import(R"({"index":0,"strength":1e300})").materials[0].light_map_strength));
    for (const char* const strength : {"-0.5", "\"bright\"", "[1]", "true"}) {
        const LogCapture log;
        const Scene dark = import(std::string{R"({"index":0,"strength":)"} + strength + "}");
        EXPECT_EQ(dark.materials[0].light_map_strength, 0.0f) << strength;
        EXPECT_THAT(log.text(), HasSubstr("materials[0].extras.ramblaLightMap.strength")) << strength;
    }
    for (const char* const other : {R"({"index":1})", R"({"index":-1})", R"({"strength":2})",
                                    R"({"index":"0"})", "7", "[0]", R"("rough")"}) {
        const LogCapture log;
        const Material without = import(other).materials[0];
        EXPECT_EQ(without.light_map_texture.texture, k_none) << other;
        EXPECT_EQ(without.light_map_strength, 1.0f) << other;
        EXPECT_THAT(log.text(), HasSubstr("materials[0].extras.ramblaLightMap")) << other;
    }
}

TEST(LightMaps, MatterOnlyToWhatScattersTheirLight) {
    Material material;
    material.metalness = 0.0f;
    EXPECT_FALSE(is_light_mapped(material));
    material.light_map_texture.texture = 0;
    EXPECT_TRUE(is_light_mapped(material));
    material.metalness = 1.0f;
    EXPECT_FALSE(is_light_mapped(material));
    // A texture may say that it is no metal everywhere.
    material.metalness_roughness_texture.texture = 0;
    EXPECT_TRUE(is_light_mapped(material));
    material.light_map_strength = 0.0f;
    EXPECT_FALSE(is_light_mapped(material));
    material.light_map_strength = 1.0f;
    material.unlit = true;
    EXPECT_FALSE(is_light_mapped(material));
}

TEST(GltfMaterials, HeightsNeedTangentsToo) {
    Draft draft;
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    draft.add<float>({0, 0, 1, 0, 0, 1}, "VEC2");
    const auto import = [&](const std::string& material) {
        return draft.load(
            R"(,"images":[{"uri":"data:image/png;base64,AA=="}],"textures":[{"source":0}],"materials":[{)" +
            material +
            R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":1},)"
            R"("material":0}]}])");
    };
    EXPECT_THAT(import(R"("name":"flat")").meshes[0].tangents, IsEmpty());
    const Scene alone = import(R"("extras":{"ramblaHeight":{"index":0,"texCoord":1,"depth":0.1}})");
    EXPECT_EQ(alone.meshes[0].tangents.size(), 3u);
    // With a normal texture, tangents are those of its coordinates; heights along others would go astray.
    const std::string normal = R"("normalTexture":{"index":0,"texCoord":0},)";
    const LogCapture log;
    const Scene apart = import(normal + R"("extras":{"ramblaHeight":{"index":0,"texCoord":1,"depth":0.1}})");
    EXPECT_EQ(apart.materials[0].height_texture.texture, k_none);
    EXPECT_THAT(log.text(), HasSubstr("ramblaHeight: its coordinates are not those of the normal texture"));
    EXPECT_NE(import(normal + R"("extras":{"ramblaHeight":{"index":0,"depth":0.1}})")
                  .materials[0]
                  .height_texture.texture,
              k_none);
}

TEST(GltfScenes, TheTimeOfDayIsReadFromExtras) {
    const auto import = [](const std::string& time) {
        return Draft{}.load(R"(,"scenes":[{"extras":{"ramblaTime":)" + time + "}}]");
    };
    EXPECT_EQ(import(R"("19:55")").time, k_dusk);
    EXPECT_EQ(import(R"("noon")").time, TimeOfDay{});
    EXPECT_EQ(Draft{}.load("").time, std::nullopt);
    for (const char* const other : {R"("25:00")", "7", "true"}) {
        const LogCapture log;
        EXPECT_EQ(import(other).time, std::nullopt) << other;
        EXPECT_THAT(log.text(), HasSubstr("scenes[0].extras.ramblaTime: is neither \"noon\" nor HH:MM"))
            << other;
    }
}

TEST(Transmission, OnlyDielectricsLetLightThrough) {
    Material material;
    material.metalness = 0.0f;
    EXPECT_EQ(drawn_as(material), AlphaMode::opaque);
    material.transmission = 0.5f;
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
        material.alpha_mode = mode;
        EXPECT_EQ(drawn_as(material), AlphaMode::blend);
    }
    material.alpha_mode = AlphaMode::mask;
    material.metalness = 1.0f;
    EXPECT_EQ(drawn_as(material), AlphaMode::mask);
    // A texture may say that it is no metal everywhere.
    material.metalness_roughness_texture.texture = 0;
    EXPECT_EQ(drawn_as(material), AlphaMode::blend);
    material.unlit = true;
    EXPECT_EQ(drawn_as(material), AlphaMode::mask);
}

}  // namespace
}  // namespace rambla::assets::test
