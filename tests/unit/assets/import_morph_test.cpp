#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<float> k_corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> k_normals{0, 0, 1, 0, 0, 1, 0, 0, 1};

Draft corners_with_normals() {
    Draft draft;
    draft.add(k_corners, "VEC3");
    draft.add(k_normals, "VEC3");
    return draft;
}

std::string morphing(const std::string& attributes, const std::string& targets,
                     const std::string& more_of_mesh = {}, const std::string& more_of_node = {}) {
    return R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0)" + attributes + R"(},"targets":[)" +
           targets + "]}]" + more_of_mesh + R"(}],"nodes":[{"mesh":0)" + more_of_node + "}]";
}

TEST(GltfMorphs, TargetsWeightsAndNamesAreRead) {
    Draft draft = corners_with_normals();
    draft.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1}, "VEC4");
    draft.add<float>({0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3");
    draft.add<std::int8_t>({127, 0, 0, 0, 127, 0, 0, 0, -127}, "VEC3", R"(,"normalized":true)");
    draft.add<float>({0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
    const LogCapture log;
    const Scene scene = draft.load(morphing(R"(,"NORMAL":1)", R"({"POSITION":3,"NORMAL":4},{"POSITION":5})",
                                            R"(,"weights":[0.5,0.25],"extras":{"targetNames":["up","on"]})",
                                            R"(,"weights":[1,0])"));
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.morphs.size(), 2u);
    EXPECT_EQ(mesh.morphs[0].name, "up");
    EXPECT_EQ(mesh.morphs[1].name, "on");
    EXPECT_EQ(mesh.morphs[0].positions[2], glm::vec3(0, 0, 3));
    EXPECT_EQ(mesh.morphs[0].normals[2], glm::vec3(0, 0, -1));
    EXPECT_EQ(mesh.morphs[1].positions[0], glm::vec3(0, 1, 0));
    EXPECT_THAT(mesh.morphs[1].normals, IsEmpty());
    EXPECT_THAT(scene.models[0].morph_weights, ElementsAre(0.5f, 0.25f));
    EXPECT_THAT(scene.nodes[0].morph_weights, ElementsAre(1.0f, 0.0f));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfMorphs, SparseTargetsMoveOnlyTheNamedVertices) {
    Draft draft = corners_with_normals();
    draft.add<std::uint8_t>({2}, "SCALAR");
    draft.add<float>({7, 8, 9}, "VEC3");
    draft.add_text(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
                   R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}})");
    const Mesh mesh = draft.load(morphing(R"(,"NORMAL":1)", R"({"POSITION":4})")).meshes[0];
    EXPECT_THAT(mesh.morphs[0].positions, ElementsAre(glm::vec3{0}, glm::vec3{0}, glm::vec3{7, 8, 9}));
}

TEST(GltfMorphs, TangentsMoveWhereTheMeshHasThem) {
    Draft draft = corners_with_normals();
    draft.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    draft.add<float>({0, 1, 0, 0, 1, 0, 0, 1, 0}, "VEC3");
    const Mesh mesh = draft.load(morphing(R"(,"NORMAL":1,"TANGENT":2)", R"({"TANGENT":3})")).meshes[0];
    EXPECT_EQ(mesh.morphs[0].tangents.size(), 3u);
    EXPECT_THAT(mesh.morphs[0].positions, IsEmpty());
}

TEST(GltfMorphs, MissingNormalsAreComputedForTheTargetsToo) {
    Draft draft;
    draft.add(k_corners, "VEC3");
    draft.add<std::uint8_t>({0, 1, 2, 0, 1, 2}, "SCALAR");
    // The third corner moves from +Y to +Z: the normal turns from +Z to −Y.
    draft.add<float>({0, 0, 0, 0, 0, 0, 0, -1, 1}, "VEC3");
    const Scene scene = draft.load(
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":2}]}]}])");
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.morphs[0].positions.size(), 6u);
    ASSERT_EQ(mesh.morphs[0].normals.size(), 6u);
    EXPECT_EQ(mesh.normals[5] + mesh.morphs[0].normals[5], glm::vec3(0, -1, 0));
}

TEST(GltfMorphs, TargetsOfWhatThePrimitiveLacksAreLeftOutWithAWarning) {
    Draft draft = corners_with_normals();
    const LogCapture log;
    const Mesh mesh = draft.load(morphing("", R"({"POSITION":1,"NORMAL":1,"TANGENT":1})")).meshes[0];
    EXPECT_THAT(mesh.morphs[0].tangents, IsEmpty());
    EXPECT_EQ(log.lines(), 2);
    EXPECT_THAT(log.text(), HasSubstr("meshes[0].primitives[0].targets[0].TANGENT"));
}

TEST(GltfMorphs, WrongNumbersOfWeightsAreFilledUp) {
    Draft draft = corners_with_normals();
    const LogCapture log;
    const Scene scene = draft.load(morphing(R"(,"NORMAL":1)", R"({"POSITION":1},{"POSITION":1})",
                                            R"(,"weights":[0.5])", R"(,"weights":[1,2,3])"));
    EXPECT_THAT(scene.models[0].morph_weights, ElementsAre(0.5f, 0.0f));
    EXPECT_THAT(scene.nodes[0].morph_weights, ElementsAre(1.0f, 2.0f));
    EXPECT_EQ(log.lines(), 2);
}

TEST(GltfMorphs, SparseIndicesBehindTheLastVertexAreRefused) {
    Draft draft = corners_with_normals();
    draft.add<std::uint8_t>({3}, "SCALAR");
    draft.add<float>({7, 8, 9}, "VEC3");
    const auto error = [&](const std::string& sparse) {
        Draft broken = draft;
        broken.add_text(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{)" + sparse + "}}");
        return broken.error(morphing(R"(,"NORMAL":1)", R"({"POSITION":4})"));
    };
    const std::string indices =
        R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3})";
    EXPECT_THAT(error(R"("count":1,)" + indices), HasSubstr("sparse index 3, expected below 3"));
    EXPECT_THAT(error(R"("count":2,)" + indices), HasSubstr("accessors[4].sparse.indices: 2 elements"));
    EXPECT_THAT(error(R"("count":-1,)" + indices), HasSubstr("accessors[4].sparse.count: -1"));
    EXPECT_THAT(error(R"("count":4,)" + indices), HasSubstr("accessors[4].sparse.count: 4"));
}

TEST(GltfMorphs, TargetsOfOtherLengthsAndNumbersAreRefused) {
    Draft draft = corners_with_normals();
    draft.add<float>({0, 0, 1}, "VEC3");
    EXPECT_THAT(draft.error(morphing(R"(,"NORMAL":1)", R"({"POSITION":2})")),
                HasSubstr("meshes[0].primitives[0].targets[0].POSITION: 1 elements, expected 3"));
    EXPECT_THAT(draft.error(morphing(R"(,"NORMAL":1)", R"({"POSITION":9})")),
                HasSubstr("targets[0].POSITION: accessor 9"));
    EXPECT_THAT(draft.error(R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"targets":[{}]},)"
                            R"({"attributes":{"POSITION":0}}]}])"),
                HasSubstr("meshes[0].primitives[1].targets: 0 morph targets, expected 1"));
}

TEST(GltfMorphs, ManyTargetsCannotFillTheMemory) {
    Draft draft;
    draft.add_text(R"({"componentType":5126,"count":300000,"type":"VEC3"})");
    std::string targets = R"({"POSITION":0})";
    for (int i = 0; i < 4; ++i)
        targets += R"(,{"POSITION":0})";
    EXPECT_THAT(draft.error(morphing(R"(,"NORMAL":0)", targets)), HasSubstr("for a file of this size"));
}

}  // namespace
}  // namespace rambla::assets::test
