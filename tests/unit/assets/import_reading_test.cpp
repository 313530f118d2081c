#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "assets/import/gltf_document.h"
#include "assets/import/gltf_unit.h"
#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::HasSubstr;

TEST(GltfReading, DirectionsBecomeUnitLengthAndKeepTheirBitsWhereTheyAre) {
    // More than one block, of which only the second needs work.
    std::vector<glm::vec3> normals(100, glm::vec3{0.6f, 0.0f, 0.80001f});
    normals[70] = {0.0f, 3.0f, 4.0f};
    normals[71] = {0.0f, 0.0f, 0.0f};
    normals[72] = {3e38f, 3e38f, 0.0f};
    normals[99] = {0.0f, 0.5f, 0.0f};
    std::vector<std::size_t> without;
    gltf::make_unit(std::span{normals}, [&](std::size_t i) { without.push_back(i); });
    EXPECT_EQ(normals[0], glm::vec3(0.6f, 0.0f, 0.80001f));
    EXPECT_EQ(normals[69], glm::vec3(0.6f, 0.0f, 0.80001f));
    EXPECT_FLOAT_EQ(normals[70].y, 0.6f);
    EXPECT_FLOAT_EQ(normals[70].z, 0.8f);
    EXPECT_EQ(normals[99], glm::vec3(0, 1, 0));
    EXPECT_EQ(without, (std::vector<std::size_t>{71, 72}));
}

TEST(GltfReading, NormalsWithoutADirectionPointUp) {
    Draft draft;
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    draft.add<float>({0, 0, 0, 0, 0, 2, 0, 0, 1}, "VEC3");
    draft.add<float>({0, 0, 0, 1, 5, 0, 0, -2, 1, 0, 0, 0}, "VEC4");
    const Mesh mesh =
        draft.load(R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2}}]}])")
            .meshes[0];
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
    EXPECT_NEAR(glm::dot(glm::vec3{mesh.tangents[0]}, mesh.normals[0]), 0.0f, 1e-6f);  // one rounding
    EXPECT_NEAR(glm::length(glm::vec3{mesh.tangents[0]}), 1.0f, 1e-6f);
    EXPECT_EQ(mesh.tangents[1], glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(mesh.tangents[2].w, 1.0f);
}

/// "3.0" is written over in its place, "1e3" needs more room than it has.
TEST(GltfReading, IntegersMayBeWrittenAsFloats) {
    const std::string json =
        R"({"asset":{"version":"2.0","extras":"1e3 in a \"string\""},"buffers":[{"byteLength":12000.0}],)"
        R"("bufferViews":[{"buffer":0.0,"byteLength":12e3}],"accessors":[{"bufferView":0,"componentType":5126.0,)"
        R"("count":1e3,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0e0},"mode":0}]}]})";
    const ScratchFolder folder;
    const std::filesystem::path file = folder.write("a.glb", glb(json, std::string(12'000, '\0')));
    EXPECT_EQ(import_gltf(file).meshes.at(0).positions.size(), 1000u);
}

TEST(GltfReading, HeldWarningsAreNotLogged) {
    gltf::Document document;
    document.path = "a.gltf";
    const LogCapture log;
    std::vector<std::string> lines;
    {
        const gltf::WarningHold hold{lines};
        document.warn("nodes[0]", "is held");
    }
    EXPECT_EQ(log.text(), "");
    EXPECT_EQ(lines, std::vector<std::string>{"a.gltf: nodes[0]: is held"});
    document.warn("nodes[0]", "is not");
    EXPECT_THAT(log.text(), HasSubstr("a.gltf: nodes[0]: is not"));
    EXPECT_EQ(lines.size(), 1u);
}

void expect_the_order_of_the_document(std::size_t more_bytes) {
    Draft draft;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    draft.add<float>({nan, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    std::string primitives;
    constexpr int k_count = 40;
    for (int i = 0; i < k_count; ++i) {
        // Accessors of their own, so that no two primitives are the same geometry.
        draft.add_text(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})");
        primitives.append(i > 0 ? "," : "").append(R"({"attributes":{"POSITION":)");
        primitives.append(std::to_string(i + 1)).append("}}");
    }
    draft.add(std::vector<std::uint8_t>(more_bytes), "SCALAR");
    const auto meshes = [](const std::string& inside) {
        return R"(,"meshes":[{"primitives":[)" + inside + "]}]";
    };
    const LogCapture log;
    static_cast<void>(draft.load(meshes(primitives)));
    EXPECT_EQ(log.lines(), k_count);
    std::size_t last = 0;
    for (int i = 0; i < k_count; ++i) {
        const std::size_t at = log.text().find("primitives[" + std::to_string(i) + "]");
        ASSERT_NE(at, std::string::npos);
        EXPECT_GE(at, last);
        last = at;
    }
    const std::string broken = R"({"attributes":{"POSITION":99}},)";
    EXPECT_THAT(draft.error(meshes(broken + primitives + "," + broken + R"({"attributes":{"POSITION":98}})")),
                HasSubstr("primitives[0].attributes.POSITION: accessor 99"));
}

TEST(GltfReading, PrimitivesWarnAndFailInTheOrderOfTheDocument) {
    expect_the_order_of_the_document(1);
}

/// Files of more than 8 MiB are read on all threads.
TEST(GltfReading, PrimitivesWarnAndFailInTheOrderOfTheDocumentOnAllThreads) {
    expect_the_order_of_the_document(9 << 20);
}

}  // namespace
}  // namespace rambla::assets::test
