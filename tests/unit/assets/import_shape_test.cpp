// Values of another type or size than glTF has: tinygltf would take them for absent, or cut them to 32 bits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A triangle, in which `part` of the text is replaced.
std::string triangle_with(const std::string& part, const std::string& replacement) {
    Draft draft;
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    draft.add<std::uint16_t>({0, 1, 2}, "SCALAR");
    std::string json =
        draft.json(R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4}]}],)"
                   R"("nodes":[{"mesh":0,"scale":[1,1,1]}],"scenes":[{"nodes":[0]}],"scene":0)");
    const std::size_t at = json.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    json.replace(at, part.size(), replacement);
    return draft.glb_of(json);
}

std::string error_with(const std::string& part, const std::string& replacement) {
    const ScratchFolder folder;
    return import_error(folder.write("a.glb", triangle_with(part, replacement)));
}

TEST(GltfShape, TheTriangleItselfLoads) {
    EXPECT_EQ(error_with("\"mesh\":0", "\"mesh\":0"), "");
    EXPECT_EQ(error_with("\"mesh\":0", "\"mesh\":0.0"), "");
    EXPECT_EQ(error_with("\"mesh\":0", "\"mesh\":0e0"), "");
}

TEST(GltfShape, ReferencesAreNotCutTo32Bits) {
    struct Row {
        const char* part;
        const char* key;
        const char* element;
    };
    constexpr Row k_rows[] = {
        {"\"mesh\":0", "\"mesh\":", "nodes[0].mesh"},
        {"\"POSITION\":0", "\"POSITION\":", "meshes[0].primitives[0].attributes.POSITION"},
        {"\"indices\":1", "\"indices\":", "meshes[0].primitives[0].indices"},
        {"\"mode\":4", "\"mode\":", "meshes[0].primitives[0].mode"},
        {"\"bufferView\":1", "\"bufferView\":", "accessors[1].bufferView"},
        {"\"buffer\":0", "\"buffer\":", "bufferViews[0].buffer"},
        {"\"scene\":0", "\"scene\":", "scene"},
        {"\"nodes\":[0]", "\"nodes\":[", "scenes[0].nodes[0]"}};
    for (const Row& row : k_rows)
        for (const char* const value :
             {"-0.0", "-0e0", "1e-400", "4294967296", "1099511627776", "18446744073709551616", "-1",
              "-4294967296", "0.5", "1e300", "\"0\"", "null", "true", "{}", "[]"}) {
            const std::string closing = std::string{row.key}.ends_with('[') ? "]" : "";
            EXPECT_THAT(error_with(row.part, row.key + (value + closing)),
                        AllOf(HasSubstr(std::string{"a.glb: "} + row.element + ": "),
                              HasSubstr("expected a whole number from 0 to ")))
                << row.element << " = " << value;
        }
}

TEST(GltfShape, OffsetsAndLengthsAreWholeNumbers) {
    for (const char* const value :
         {"-1", "\"0\"", "0.5", "-0.0", "9007199254740992.0", "9223372036854775808", "[0]"}) {
        const std::string text = value;
        EXPECT_THAT(error_with("\"byteOffset\":0", "\"byteOffset\":" + text),
                    HasSubstr("bufferViews[0].byteOffset: "))
            << value;
        EXPECT_THAT(error_with("\"count\":3", "\"count\":" + text), HasSubstr("accessors[0].count: "))
            << value;
        EXPECT_THAT(
            error_with("\"count\":3",
                       "\"count\":3,\"sparse\":{\"count\":1,\"values\":{\"byteOffset\":" + text + "}}"),
            HasSubstr("accessors[0].sparse.values.byteOffset: "))
            << value;
    }
    // tinygltf keeps these in 32 bits.
    for (const char* const member :
         {"\"count\":4294967298", "\"count\":1,\"values\":{\"byteOffset\":4294967296}",
          "\"count\":1,\"indices\":{\"byteOffset\":4294967296}"})
        EXPECT_THAT(error_with("\"count\":3", std::string{"\"count\":3,\"sparse\":{"} + member + "}"),
                    AllOf(HasSubstr("accessors[0].sparse."),
                          HasSubstr("expected a whole number from 0 to 2147483646")));
    EXPECT_THAT(error_with("\"byteOffset\":0", "\"byteStride\":256,\"byteOffset\":0"),
                HasSubstr("bufferViews[0].byteStride: 256, expected a whole number from 0 to 252"));
}

TEST(GltfShape, ContainersAreWhatTheyMustBe) {
    EXPECT_THAT(error_with("\"primitives\":[", "\"primitives\":{},\"other\":["),
                HasSubstr("meshes[0].primitives: an object, expected an array"));
    EXPECT_THAT(error_with("\"nodes\":[{", "\"nodes\":\"abc\",\"other\":[{"),
                HasSubstr("nodes: the string \"abc\", expected an array"));
    EXPECT_THAT(error_with("\"attributes\":{", "\"attributes\":[],\"other\":{"),
                HasSubstr("meshes[0].primitives[0].attributes: an array, expected an object"));
    EXPECT_THAT(error_with("\"mode\":4", "\"targets\":[[]]"),
                HasSubstr("meshes[0].primitives[0].targets[0]: an array, expected an object"));
    EXPECT_THAT(error_with("\"scale\":[1,1,1]", "\"scale\":[1,\"x\",1]"),
                HasSubstr("nodes[0].scale[1]: the string \"x\", expected a number"));
    EXPECT_THAT(error_with("\"scene\":0", "\"extensionsRequired\":[1,null,{}]"),
                HasSubstr("extensionsRequired[0]: 1, expected a string"));
    EXPECT_THAT(error_with("\"scene\":0", "\"materials\":[{\"emissiveFactor\":[1,1]}]"),
                HasSubstr("materials[0].emissiveFactor: an array of 2, expected an array of 3"));
    EXPECT_THAT(error_with("\"scene\":0", "\"materials\":[{\"doubleSided\":1}]"),
                HasSubstr("materials[0].doubleSided: 1, expected true or false"));
    EXPECT_THAT(error_with("\"scene\":0", "\"images\":[{\"uri\":7}]"),
                HasSubstr("images[0].uri: 7, expected a string"));
}

TEST(GltfShape, WhatTheImporterDoesNotReadMayBeAnything) {
    EXPECT_EQ(
        error_with("\"scene\":0", R"("scene":0,"extras":{"scene":-1,"nodes":"x"},"other":[[{"mesh":-1}]])"),
        "");
    EXPECT_EQ(error_with("\"mesh\":0", R"("mesh":0,"extras":[{"mesh":"x"}],"name":7)"), "");
}

TEST(GltfShape, InstancesWithoutTheWrapperAreLookedAtToo) {
    EXPECT_THAT(
        error_with("\"mesh\":0",
                   R"("mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"TRANSLATION":4294967296}})"),
        HasSubstr("nodes[0].extensions.EXT_mesh_gpu_instancing.TRANSLATION: 4294967296, expected a whole"));
}

TEST(GltfShape, TheVersionComesFirstWhereThereIsOne) {
    EXPECT_THAT(error_with("\"2.0\"", "\"1.0\",\"x\":[]},\"nodes\":{},\"other\":{\"x\":0"),
                HasSubstr("asset.version: \"1.0\""));
    EXPECT_THAT(error_with("\"2.0\"", "2.0"), HasSubstr("asset.version: 2.0, expected a string"));
    const ScratchFolder folder;
    EXPECT_THAT(import_error(folder.write("a.gltf", "[1]")), HasSubstr("JSON: an array, expected an object"));
    EXPECT_THAT(import_error(folder.write("a.gltf", "5")), HasSubstr("JSON: 5, expected an object"));
}

TEST(GltfShape, QuotedTextStaysOnOneLine) {
    const std::string error = error_with("\"VEC3\"", "\"VE\\nC3\"");
    EXPECT_THAT(error, HasSubstr("VE?C3"));
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(GltfShape, SamplerConstantsThatDoNotExistAreNamed) {
    const LogCapture log;
    const ScratchFolder folder;
    static_cast<void>(import_gltf(folder.write(
        "a.glb", triangle_with("\"scene\":0",
                               R"("samplers":[{"wrapS":7,"wrapT":9729,"magFilter":9987,"minFilter":33071},)"
                               R"({"wrapS":33648,"wrapT":33071,"magFilter":9728,"minFilter":9984},{}])"))));
    EXPECT_EQ(log.lines(), 4);
    EXPECT_THAT(log.text(), HasSubstr("samplers[0].wrapS: 7 is unknown, 10497 (repeat) is used"));
    EXPECT_THAT(log.text(), HasSubstr("samplers[0].wrapT: 9729 is unknown"));
    EXPECT_THAT(log.text(), HasSubstr("samplers[0].magFilter: 9987 is unknown"));
    EXPECT_THAT(log.text(), HasSubstr("samplers[0].minFilter: 33071 is unknown"));
}

TEST(GltfShape, LongNumbersAreShortened) {
    EXPECT_LT(error_with("\"scale\":[1,1,1]", "\"scale\":[1,1e300,1]").size(), 200u);
    EXPECT_THAT(error_with("\"scale\":[1,1,1]", "\"scale\":[1,1e300,1]"),
                HasSubstr("nodes[0].scale[1]: 1e+300"));
    const std::string error = error_with("\"mesh\":0", "\"mesh\":1" + std::string(300, '0'));
    EXPECT_THAT(error, HasSubstr("nodes[0].mesh: 1000"));
    EXPECT_LT(error.size(), 200u);
}

TEST(GltfShape, NumbersOutOfRangeAreClampedWithAWarning) {
    const std::string lights =
        R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":-1e300,"range":-2,)"
        R"("color":[-1,1,1],"spot":{"innerConeAngle":7,"outerConeAngle":9}},{"type":"spot",)"
        R"("spot":{"innerConeAngle":1,"outerConeAngle":0.5}}]}},"materials":[{"pbrMetallicRoughness":{)"
        R"("metallicFactor":5}}])";
    const LogCapture log;
    const ScratchFolder folder;
    const Scene scene = import_gltf(folder.write("a.glb", triangle_with("\"scene\":0", lights)));
    const std::string element = "extensions.KHR_lights_punctual.lights[0].";
    for (const std::string& line :
         {element + "intensity: -1e300 is not in 0 to 3.40282e+38 and is clamped",
          element + "range: -2 is not in 0 to 3.40282e+38 and is clamped",
          element + "color[0]: -1 is not in 0 to 3.40282e+38 and is clamped",
          element + "spot.innerConeAngle: 7 is not in 0 to 1.5708 and is clamped",
          element + "spot.outerConeAngle: 9 is not in 0 to 1.5708 and is clamped",
          std::string{"lights[1].spot.innerConeAngle: 1 is not below outerConeAngle, 0.5"},
          std::string{"materials[0].pbrMetallicRoughness.metallicFactor: 5 is not in 0 to 1 and is clamped"}})
        EXPECT_THAT(log.text(), HasSubstr(line));
    EXPECT_EQ(log.lines(), 7);
    EXPECT_EQ(scene.lights[0].intensity, 0.0f);
    EXPECT_EQ(scene.lights[0].range_m, 0.0f);
    EXPECT_EQ(scene.lights[0].colour.x, 0.0f);
    EXPECT_LE(scene.lights[0].inner_cone_rad, scene.lights[0].outer_cone_rad);
    EXPECT_EQ(scene.lights[1].inner_cone_rad, 0.5f);
    EXPECT_EQ(scene.materials[0].metalness, 1.0f);
}

TEST(GltfShape, TheLargestFloatsAreNotOutOfRange) {
    const LogCapture log;
    const ScratchFolder folder;
    static_cast<void>(import_gltf(folder.write(
        "a.glb",
        triangle_with("\"scene\":0",
                      R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","range":3.4028235e38,)"
                      R"("spot":{"outerConeAngle":1.5707963705062866}}]}})"))));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfShape, ManyNumbersOutOfRangeAreCounted) {
    std::string materials = "\"materials\":[{\"alphaCutoff\":-1}";
    for (int i = 1; i < 100; ++i)
        materials += ",{\"alphaCutoff\":-1}";
    const LogCapture log;
    const ScratchFolder folder;
    static_cast<void>(import_gltf(folder.write("a.glb", triangle_with("\"scene\":0", materials + "]"))));
    EXPECT_EQ(log.lines(), 9);
    EXPECT_THAT(log.text(), HasSubstr("92 more numbers are not in their range and are clamped"));
}

}  // namespace
}  // namespace rambla::assets::test
