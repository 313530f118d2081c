#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A one-mesh document: `accessors`, `views` and the primitive's inside are given, the buffer is "data.bin".
Scene import_primitive(const std::string& data, const std::string& views, const std::string& accessors,
                       const std::string& primitive) {
    const ScratchFolder folder;
    folder.write("data.bin", data);
    return import_gltf(
        folder.write("mesh.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"uri":"data.bin","byteLength":)" +
                                      std::to_string(data.size()) + R"(}],"bufferViews":[)" + views +
                                      R"(],"accessors":[)" + accessors + R"(],"meshes":[{"primitives":[{)" +
                                      primitive + R"(}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})"));
}

const std::string k_triangle = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
const std::string k_whole_view = R"({"buffer":0,"byteLength":36})";
const std::string k_positions = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";

Scene import_node(const std::string& node, const std::string& more = {}) {
    const ScratchFolder folder;
    return import_gltf(
        folder.write("node.gltf", R"({"asset":{"version":"2.0"},"nodes":[{)" + node + "}]" + more + "}"));
}

TEST(GltfImport, SparseAccessorReplacesTheNamedElements) {
    const std::string data = k_triangle + bytes_of<std::uint16_t>({2, 0}) + bytes_of<float>({7, 8, 9});
    const Scene scene = import_primitive(
        data,
        k_whole_view +
            R"(,{"buffer":0,"byteOffset":36,"byteLength":2},{"buffer":0,"byteOffset":40,"byteLength":12})",
        R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
        R"("indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}}})",
        R"("attributes":{"POSITION":0})");
    EXPECT_THAT(scene.meshes[0].positions,
                ElementsAre(glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{7, 8, 9}));
}

TEST(GltfImport, AccessorWithoutBufferViewIsZeroExceptWhereItIsSparse) {
    const std::string data = bytes_of<std::uint8_t>({1, 0, 0, 0}) + bytes_of<float>({4, 5, 6});
    const Scene scene =
        import_primitive(data, R"({"buffer":0,"byteLength":1},{"buffer":0,"byteOffset":4,"byteLength":12})",
                         R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
                         R"("indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":1}}})",
                         R"("attributes":{"POSITION":0})");
    EXPECT_THAT(scene.meshes[0].positions, ElementsAre(glm::vec3{0}, glm::vec3{4, 5, 6}, glm::vec3{0}));
}

TEST(GltfImport, InterleavedAndQuantisedAttributesAreRead) {
    // Stride 12: position as 3 × i16 normalised, padding, texture coordinate as 2 × u16 normalised.
    const std::string data = bytes_of<std::uint16_t>({0, 0, 0, 0, 0, 65535,      //
                                                      32767, 0, 0, 0, 32768, 0,  //
                                                      0, 0x8000, 0x8001, 0, 65535, 65535});
    const Scene scene = import_primitive(
        data, R"({"buffer":0,"byteLength":36,"byteStride":12})",
        R"({"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"},)"
        R"({"bufferView":0,"byteOffset":8,"componentType":5123,"normalized":true,"count":3,"type":"VEC2"})",
        R"("attributes":{"POSITION":0,"TEXCOORD_0":1})");
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, -1, -1));  // −32768 and −32767 are both −1
    EXPECT_EQ(mesh.uv0[0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.uv0[1].x, 32768.0f / 65535.0f);
    EXPECT_EQ(mesh.uv0[2], glm::vec2(1, 1));
}

TEST(GltfImport, VertexColoursOfAnyFormBecomeFloatsWithAlpha) {
    const std::string views = k_whole_view + R"(,{"buffer":0,"byteOffset":36,"byteLength":24})";
    const auto colours = [&](const std::string& bytes, const std::string& accessor) {
        std::string data = k_triangle + bytes;
        data.resize(60);
        return import_primitive(data, views, k_positions + "," + accessor,
                                R"("attributes":{"POSITION":0,"COLOR_0":1})")
            .meshes[0]
            .colours;
    };
    const auto bytes =
        colours(bytes_of<std::uint8_t>({255, 0, 51, 102, 0, 255, 0, 255, 0, 0, 255, 0}),
                R"({"bufferView":1,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"})");
    EXPECT_EQ(bytes[0], glm::vec4(1.0f, 0.0f, 51.0f / 255.0f, 102.0f / 255.0f));
    const auto shorts =
        colours(bytes_of<std::uint16_t>({65535, 0, 13107, 0, 0, 0, 0, 0, 0}),
                R"({"bufferView":1,"componentType":5123,"normalized":true,"count":3,"type":"VEC3"})");
    EXPECT_EQ(shorts[0], glm::vec4(1.0f, 0.0f, 0.2f, 1.0f));
}

TEST(GltfImport, StripsFansAndLoopsBecomeLists) {
    const std::string data = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const auto indices = [&](int mode) {
        return import_primitive(data, R"({"buffer":0,"byteLength":60})",
                                R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})",
                                R"("attributes":{"POSITION":0},"mode":)" + std::to_string(mode))
            .meshes[0];
    };
    EXPECT_EQ(indices(0).topology, Topology::points);
    EXPECT_THAT(indices(0).indices, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(indices(2).indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4, 4, 0));
    EXPECT_THAT(indices(3).indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4));
    EXPECT_EQ(indices(3).topology, Topology::lines);
    // Vertices are split for flat normals: the order of the list shows in the positions. All of this strip
    // face +Z.
    const Mesh strip = indices(5);
    ASSERT_EQ(strip.positions.size(), 9u);
    EXPECT_EQ(strip.positions[3], glm::vec3(1, 0, 0));
    EXPECT_EQ(strip.positions[4], glm::vec3(1, 1, 0));
    EXPECT_EQ(strip.positions[5], glm::vec3(0, 1, 0));
    for (const glm::vec3& normal : strip.normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    const Mesh fan = indices(6);
    ASSERT_EQ(fan.positions.size(), 9u);
    EXPECT_EQ(fan.positions[0], glm::vec3(1, 0, 0));  // {1, 2, 0} comes first
    EXPECT_EQ(fan.positions[2], glm::vec3(0, 0, 0));
}

TEST(GltfImport, PrimitivesTakeOnlyTheVerticesTheyShow) {
    std::string data = bytes_of<std::uint16_t>({7, 9, 8, 0});
    for (int i = 0; i < 20; ++i)
        data += bytes_of<float>({static_cast<float>(i % 3), static_cast<float>(i), 0.0f});
    const Scene scene =
        import_primitive(data, R"({"buffer":0,"byteLength":6},{"buffer":0,"byteOffset":8,"byteLength":240})",
                         R"({"bufferView":0,"componentType":5123,"count":3,"type":"SCALAR"},)"
                         R"({"bufferView":1,"componentType":5126,"count":20,"type":"VEC3"},)"
                         R"({"bufferView":1,"componentType":5126,"count":20,"type":"VEC3"})",
                         R"("attributes":{"POSITION":1,"NORMAL":2},"indices":0)");
    EXPECT_THAT(scene.meshes[0].positions,
                ElementsAre(glm::vec3{1, 7, 0}, glm::vec3{2, 8, 0}, glm::vec3{0, 9, 0}));
    EXPECT_THAT(scene.meshes[0].indices, ElementsAre(0, 2, 1));
}

TEST(GltfImport, NonFinitePositionsBecomeZeroWithOneWarning) {
    std::string data = k_triangle;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(data.data() + 4, &nan, sizeof nan);
    const LogCapture log;
    const Scene scene = import_primitive(data, k_whole_view, k_positions, R"("attributes":{"POSITION":0})");
    EXPECT_EQ(scene.meshes[0].positions[0], glm::vec3{0});
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(),
                HasSubstr("meshes[0].primitives[0].attributes.POSITION: 1 values were not finite"));
}

TEST(GltfImport, MatrixOfANodeIsSplitAndKeepsItsMirroring) {
    // Column-major: rotation by 90° about Y times scale (−2, 3, 4), translation (5, 6, 7).
    const Scene scene = import_node(R"("matrix":[0,0,2,0, 0,3,0,0, 4,0,0,0, 5,6,7,1])");
    const Transform& local = scene.nodes[0].local;
    EXPECT_LT(local.scale.x * local.scale.y * local.scale.z, 0.0f);
    const glm::mat4 expected{0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 5, 6, 7, 1};
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            EXPECT_NEAR(matrix(local)[c][r], expected[c][r], 1e-6f);  // rounding of a quaternion
}

TEST(GltfImport, RotationIsXyzwAndFlatMatricesStayFinite) {
    const Scene turned = import_node(R"("rotation":[0,0,0.7071068,0.7071068])");
    const glm::vec3 x = glm::vec3{matrix(turned.nodes[0].local) * glm::vec4{1, 0, 0, 0}};
    EXPECT_NEAR(x.y, 1.0f, 1e-6f);  // a quarter turn about Z; 7 digits were given
    const Scene flat = import_node(R"("matrix":[1,0,0,0, 0,0,0,0, 0,0,1,0, 0,0,0,1])");
    EXPECT_EQ(flat.nodes[0].local.scale, glm::vec3(1, 0, 1));
    EXPECT_NEAR(glm::length(flat.nodes[0].local.rotation), 1.0f, 1e-6f);
}

TEST(GltfImport, MaterialExtensionsAndLightsAreRead) {
    const LogCapture log;
    const Scene scene = import_node(
        R"("extensions":{"KHR_lights_punctual":{"light":1}})",
        R"(,"extensionsUsed":["KHR_lights_punctual","KHR_materials_unlit","KHR_materials_transmission",)"
        R"("KHR_materials_emissive_strength","VENDOR_something"],"extensions":{"KHR_lights_punctual":{"lights":[)"
        R"({"type":"directional","intensity":3},{"type":"spot","color":[1,0.5,0],"intensity":40,"range":9,)"
        R"("spot":{"innerConeAngle":0.25,"outerConeAngle":0.5}}]}},"materials":[)"
        R"({"emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}}},)"
        R"({"pbrMetallicRoughness":{"roughnessFactor":0.05},)"
        R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5}}},)"
        R"({"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,"extensions":{"KHR_materials_unlit":{}}}])");
    EXPECT_EQ(scene.nodes[0].light, 1u);
    EXPECT_EQ(scene.lights[0].intensity, 3.0f);
    EXPECT_EQ(scene.lights[1].kind, LightKind::spot);
    EXPECT_EQ(scene.lights[1].inner_cone_rad, 0.25f);
    EXPECT_EQ(scene.lights[1].range_m, 9.0f);
    EXPECT_EQ(scene.materials[0].emissive, glm::vec3(8, 4, 0));
    EXPECT_EQ(scene.materials[1].transmission, 0.5f);
    EXPECT_EQ(scene.materials[1].alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(scene.materials[1].base_colour.w, 1.0f);
    EXPECT_FLOAT_EQ(scene.materials[1].roughness, 0.05f);
    EXPECT_TRUE(scene.materials[2].unlit && scene.materials[2].double_sided);
    EXPECT_EQ(scene.materials[2].alpha_mode, AlphaMode::mask);
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("VENDOR_something"));
}

TEST(GltfImport, DefaultSceneGivesTheRootsAndOthersStayPrototypes) {
    const ScratchFolder folder;
    const Scene scene = import_gltf(folder.write(
        "s.gltf",
        R"({"asset":{"version":"2.0"},"scene":1,"scenes":[{"nodes":[0]},{"name":"main","nodes":[2]}],)"
        R"("nodes":[{},{"name":"child"},{"children":[1]}]})"));
    EXPECT_THAT(scene.roots, ElementsAre(2));
    EXPECT_EQ(scene.name, "main");
    EXPECT_EQ(scene.nodes[1].parent, 2u);
    EXPECT_EQ(scene.nodes.size(), 3u);
}

}  // namespace
}  // namespace rambla::assets::test
