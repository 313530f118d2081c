#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<float> k_corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> k_normals{0, 0, 1, 0, 0, 1, 0, 0, 1};

/// One triangle, skinned by nodes 1 to `joints`; attributes beside POSITION are given.
std::string skinned(const std::string& attributes, int joints, const std::string& more_of_skin = {}) {
    std::string nodes = R"({"mesh":0,"skin":0})";
    std::string list;
    for (int j = 1; j <= joints; ++j) {
        nodes += R"(,{"name":"bone"})";
        list.append(j > 1 ? "," : "").append(std::to_string(j));
    }
    return R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,)" + attributes +
           R"(}}]}],"skins":[{"joints":[)" + list + "]" + more_of_skin + R"(}],"nodes":[)" + nodes + "]";
}

Draft corners_with_normals() {
    Draft draft;
    draft.add(k_corners, "VEC3");
    draft.add(k_normals, "VEC3");
    return draft;
}

const std::string k_four = R"("NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3)";
const std::vector<std::uint8_t> k_first_joints(12, 0);
const std::vector<float> k_rigid{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

TEST(GltfSkins, JointsAndWeightsAreReadStrongestFirst) {
    Draft draft = corners_with_normals();
    draft.add<std::uint16_t>({0, 1, 2, 3, 2, 0, 0, 0, 1, 3, 0, 0}, "VEC4");
    draft.add<std::uint8_t>({51, 0, 204, 0, 255, 0, 0, 0, 102, 153, 0, 0}, "VEC4", R"(,"normalized":true)");
    const LogCapture log;
    const Scene scene = draft.load(skinned(k_four, 4));
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.joints.size(), 3u);
    EXPECT_EQ(mesh.joints[0].x, 2);
    EXPECT_EQ(mesh.joints[0].y, 0);
    EXPECT_FLOAT_EQ(mesh.weights[0].x, 0.8f);
    EXPECT_FLOAT_EQ(mesh.weights[0].y, 0.2f);
    EXPECT_EQ(mesh.joints[1].x, 2);
    EXPECT_EQ(mesh.weights[1], glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(mesh.joints[2].x, 3);
    EXPECT_EQ(scene.nodes[0].skeleton, 0u);
    EXPECT_THAT(scene.skeletons[0].joints, ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(log.text(), "");
}

TEST(GltfSkins, OfMoreThanFourJointsTheStrongestStayAndSumUpToOne) {
    Draft draft = corners_with_normals();
    draft.add<std::uint8_t>({0, 1, 2, 3, 0, 1, 2, 3, 0, 0, 0, 0}, "VEC4");
    draft.add<float>({.1f, .2f, .05f, .15f, .25f, .25f, .25f, .25f, 1, 0, 0, 0}, "VEC4");
    draft.add<std::uint8_t>({4, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    draft.add<float>({.4f, .1f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    const LogCapture log;
    const Scene scene = draft.load(skinned(k_four + R"(,"JOINTS_1":4,"WEIGHTS_1":5)", 6));
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.joints[0], glm::u16vec4(4, 1, 3, 0));
    constexpr float k_kept = 0.4f + 0.2f + 0.15f + 0.1f;
    EXPECT_FLOAT_EQ(mesh.weights[0].x, 0.4f / k_kept);
    EXPECT_FLOAT_EQ(mesh.weights[0].w, 0.1f / k_kept);
    EXPECT_EQ(mesh.weights[1], glm::vec4(0.25f));
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("2 influences beyond the strongest four"));
}

TEST(GltfSkins, WeightsThatCannotBeAreMended) {
    Draft draft = corners_with_normals();
    draft.add<std::uint8_t>({1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    draft.add<float>({0, 0, 0, 0, nan, 2, 0, 0, -1, 3, 0, 0}, "VEC4");
    const LogCapture log;
    const Mesh mesh = draft.load(skinned(k_four, 2)).meshes[0];
    EXPECT_EQ(mesh.joints[0].x, 1);
    for (const glm::vec4& weights : mesh.weights)
        EXPECT_EQ(weights, glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(mesh.joints[1].x, 0);
    EXPECT_EQ(mesh.joints[2].x, 1);
    EXPECT_EQ(log.lines(), 3);
    EXPECT_THAT(log.text(), AllOf(HasSubstr("1 values were not finite"), HasSubstr("1 weights were negative"),
                                  HasSubstr("1 vertices have no weights")));
}

TEST(GltfSkins, JointsOutsideTheSkinOrOfNoNodeAreRefused) {
    Draft draft = corners_with_normals();
    draft.add<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0}, "VEC4");
    draft.add(k_rigid, "VEC4");
    EXPECT_THAT(draft.error(skinned(k_four, 2)),
                AllOf(HasSubstr("nodes[0].skin"), HasSubstr("joint 2 of a skin with 2 joints")));
    EXPECT_EQ(draft.error(skinned(k_four, 3)), "");
    EXPECT_THAT(draft.error(R"(,"skins":[{"joints":[0,7]}],"nodes":[{}])"),
                HasSubstr("skins[0].joints[1]: node 7"));
    EXPECT_THAT(draft.error(R"(,"skins":[{"joints":[-1]}],"nodes":[{}])"),
                HasSubstr("skins[0].joints[0]: -1, expected a whole number"));
    EXPECT_THAT(draft.error(R"(,"skins":[{"joints":[0],"skeleton":3}],"nodes":[{}])"),
                HasSubstr("skins[0].skeleton: node 3"));
    EXPECT_THAT(draft.error(R"(,"nodes":[{"mesh":0,"skin":1}],"meshes":[{"primitives":[]}])"),
                HasSubstr("nodes[0].skin: skin 1"));
}

TEST(GltfSkins, JointsThatAreNoWholeNumbersOrHaveNoWeightsAreRefused) {
    Draft draft = corners_with_normals();
    draft.add<std::uint32_t>({70000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    draft.add(k_rigid, "VEC4");
    EXPECT_THAT(draft.error(skinned(k_four, 1)),
                AllOf(HasSubstr("attributes.JOINTS_0: joint 70000"), HasSubstr("up to 65535")));
    EXPECT_THAT(draft.error(skinned(R"("NORMAL":1,"JOINTS_0":2)", 1)), HasSubstr("no WEIGHTS_0"));
    EXPECT_THAT(draft.error(skinned(R"("NORMAL":1,"JOINTS_0":0,"WEIGHTS_0":3)", 1)),
                HasSubstr("attributes.JOINTS_0: 3 components, expected 4"));
    Draft half = corners_with_normals();
    half.add<float>({.5f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    half.add(k_rigid, "VEC4");
    EXPECT_THAT(half.error(skinned(k_four, 1)), HasSubstr("joint 0.5"));
}

TEST(GltfSkins, MissingBindMatricesAreIdentityAndBrokenOnesAreMended) {
    Draft draft = corners_with_normals();
    draft.add(k_first_joints, "VEC4");
    draft.add(k_rigid, "VEC4");
    EXPECT_EQ(draft.load(skinned(k_four, 1)).skeletons[0].joint_from_mesh[0], glm::mat4{1.0f});

    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> matrices{1, 0, 0, 0,    0, 1,   0, 0, 0, 0, 1, 0, 5, 6, 7, 1,  //
                                1, 0, 0, 0.5f, 0, 2,   0, 0, 0, 0, 1, 0, 5, 6, 7, 3,  //
                                1, 0, 0, 0,    0, nan, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1,  //
                                1, 0, 0, 0,    0, 1,   0, 0, 0, 0, 1, 0, 0, 0, 0, .9999f};
    draft.add(matrices, "MAT4");
    const LogCapture log;
    const Scene scene = draft.load(skinned(k_four, 4, R"(,"inverseBindMatrices":4)"));
    const std::vector<glm::mat4>& bind = scene.skeletons[0].joint_from_mesh;
    EXPECT_EQ(bind[0][3], glm::vec4(5, 6, 7, 1));
    EXPECT_EQ(bind[1][0], glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(bind[1][3], glm::vec4(5, 6, 7, 1));
    EXPECT_EQ(bind[2], glm::mat4{1.0f});
    EXPECT_EQ(bind[3], glm::mat4{1.0f});
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("skins[0].inverseBindMatrices: 2 matrices were not affine"));

    EXPECT_THAT(draft.error(skinned(k_four, 5, R"(,"inverseBindMatrices":4)")),
                HasSubstr("skins[0].inverseBindMatrices: 4 matrices, expected 5"));
    EXPECT_THAT(draft.error(skinned(k_four, 1, R"(,"inverseBindMatrices":3)")),
                HasSubstr("4 components, expected 16 floats"));
    EXPECT_THAT(draft.error(skinned(k_four, 1, R"(,"inverseBindMatrices":99)")),
                HasSubstr("skins[0].inverseBindMatrices: accessor 99"));
}

TEST(GltfSkins, BindMatricesOutsideTheirBufferAreRefused) {
    Draft draft = corners_with_normals();
    draft.add(k_first_joints, "VEC4");
    draft.add(k_rigid, "VEC4");
    const auto error = [&](const std::string& accessor) {
        Draft broken = draft;
        broken.add_text(R"({"bufferView":0,"componentType":5126,"type":"MAT4",)" + accessor + "}");
        return broken.error(skinned(k_four, 1, R"(,"inverseBindMatrices":4)"));
    };
    EXPECT_THAT(error(R"("count":1)"), HasSubstr("accessors[4]: 1 elements from byte 0"));
    EXPECT_THAT(error(R"("count":1,"byteOffset":18446744073709551615)"),
                HasSubstr("accessors[4].byteOffset"));
    // 64 · 2⁵⁸ is 0 in 64 bits.
    EXPECT_THAT(error(R"("count":288230376151711744)"), HasSubstr("accessors[4].count"));
    EXPECT_THAT(error(R"("count":100000000)"), HasSubstr("accessors[4]: 100000000 elements"));
}

TEST(GltfSkins, MissingNormalsSplitJointsAndWeightsToo) {
    Draft draft;
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
    draft.add<std::uint8_t>({0, 1, 2, 0, 1, 3}, "SCALAR");
    draft.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0}, "VEC4");
    draft.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const Scene scene = draft.load(
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}])"
        R"(,"skins":[{"joints":[1,2,3,4]}],"nodes":[{"mesh":0,"skin":0},{},{},{},{}])");
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.normals.size(), 6u);
    ASSERT_EQ(mesh.joints.size(), 6u);
    ASSERT_EQ(mesh.weights.size(), 6u);
    EXPECT_EQ(mesh.joints[4].x, 1);
    EXPECT_EQ(mesh.joints[5].x, 3);
}

TEST(GltfSkins, SkinsWithoutMeshAreIgnoredWithAWarning) {
    const LogCapture log;
    const Scene scene = Draft{}.load(R"(,"skins":[{"joints":[0]}],"nodes":[{"skin":0}])");
    EXPECT_EQ(scene.nodes[0].skeleton, k_none);
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("nodes[0].skin: moves nothing"));
}

TEST(GltfSkins, ManySetsOfJointsCannotBuyTimeWithoutBytes) {
    Draft draft;
    draft.add_text(R"({"componentType":5126,"count":900000,"type":"VEC3"})");
    draft.add_text(R"({"componentType":5121,"count":900000,"type":"VEC4"})");
    std::string attributes = R"("NORMAL":0)";
    for (int set = 0; set < 3; ++set)
        for (const char* name : {"JOINTS_", "WEIGHTS_"})
            attributes.append(",\"").append(name).append(std::to_string(set)).append("\":1");
    EXPECT_THAT(draft.error(skinned(attributes, 1)), HasSubstr("more vertices, indices or particles"));
}

}  // namespace
}  // namespace rambla::assets::test
