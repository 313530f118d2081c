#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string k_asset = R"({"asset":{"version":"2.0"})";

std::string error_of(const std::string& name, const std::string& bytes, const ImportLimits& limits = {}) {
    const ScratchFolder folder;
    return import_error(folder.write(name, bytes), limits);
}

TEST(GltfErrors, MissingFileIsNamed) {
    EXPECT_THAT(import_error("/nowhere/at-all.glb"),
                AllOf(HasSubstr("/nowhere/at-all.glb"), HasSubstr("no such file")));
    EXPECT_THAT(import_error("/tmp"), HasSubstr("not a regular file"));
}

TEST(GltfErrors, TextNamedGlbIsToldApart) {
    EXPECT_THAT(error_of("notes.glb", "shopping list: milk, eggs"),
                AllOf(HasSubstr("notes.glb: header.magic"), HasSubstr("expected \"glTF\"")));
    EXPECT_THAT(error_of("notes.gltf", "shopping list"),
                AllOf(HasSubstr("notes.gltf: JSON"), HasSubstr("parse error")));
}

TEST(GltfErrors, GlbCutAnywhereIsRefused) {
    const std::string whole = glb(k_asset + R"(,"buffers":[{"byteLength":8}]})", "12345678");
    ASSERT_EQ(error_of("whole.glb", whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THAT(error_of("cut.glb", whole.substr(0, size)), HasSubstr("cut.glb: ")) << size;
}

TEST(GltfErrors, MissingBufferIsNamed) {
    EXPECT_THAT(error_of("a.gltf", k_asset + R"(,"buffers":[{"uri":"gone.bin","byteLength":4}]})"),
                AllOf(HasSubstr("a.gltf: buffers[0].uri: \"gone.bin\" is missing")));
}

TEST(GltfErrors, ShortBufferIsNamedWithBothSizes) {
    const ScratchFolder folder;
    folder.write("short.bin", "12");
    const auto file = folder.write("a.gltf", k_asset + R"(,"buffers":[{"uri":"short.bin","byteLength":4}]})");
    EXPECT_THAT(import_error(file), HasSubstr("buffers[0].uri: \"short.bin\" holds 2 bytes, expected 4"));
}

TEST(GltfErrors, LongerBufferThanClaimedIsFine) {
    const ScratchFolder folder;
    folder.write("long.bin", "12345678");
    EXPECT_EQ(
        import_error(folder.write("a.gltf", k_asset + R"(,"buffers":[{"uri":"long.bin","byteLength":4}]})")),
        "");
}

TEST(GltfErrors, UrisCannotLeaveTheFolder) {
    const ScratchFolder folder;
    folder.write("secret.bin", "1234");
    std::filesystem::create_directories(folder.path() / "in");
    std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "in/link.bin");
    folder.write("in/a b.bin", "1234");
    std::filesystem::create_symlink("a b.bin", folder.path() / "in/inside.bin");
    const auto error = [&](const std::string& uri) {
        return import_error(
            folder.write("in/a.gltf", k_asset + R"(,"buffers":[{"uri":")" + uri + R"(","byteLength":4}]})"));
    };
    for (const std::string& uri : {std::string{"../secret.bin"}, std::string{"%2e%2e/secret.bin"},
                                   std::string{"x/../../secret.bin"}, (folder.path() / "secret.bin").string(),
                                   std::string{"file:secret.bin"}, std::string{"http://host/secret.bin"}})
        EXPECT_THAT(error(uri), AllOf(HasSubstr("buffers[0].uri: "), HasSubstr("inside its folder"))) << uri;
    EXPECT_THAT(error("link.bin"), HasSubstr("is a link out of the folder"));
    EXPECT_EQ(error("inside.bin"), "");
    EXPECT_EQ(error("a%20b.bin"), "");
    EXPECT_EQ(error("a b.bin"), "");
    EXPECT_EQ(error("./a%20b.bin"), "");
}

TEST(GltfErrors, AccessorsOutsideTheirBufferNameTheElement) {
    const auto error = [](const std::string& view, const std::string& accessor) {
        return error_of("a.glb",
                        glb(k_asset + R"(,"buffers":[{"byteLength":36}],"bufferViews":[{"buffer":0,)" + view +
                                R"(}],"accessors":[{"bufferView":0,"type":"VEC3",)" + accessor +
                                R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})",
                            std::string(36, '\0')));
    };
    EXPECT_EQ(error(R"("byteLength":36)", R"("componentType":5126,"count":3)"), "");
    EXPECT_THAT(error(R"("byteLength":36)", R"("componentType":5126,"count":4)"),
                HasSubstr("accessors[0]: 4 elements"));
    EXPECT_THAT(error(R"("byteLength":36)", R"("componentType":5126,"count":3,"byteOffset":4)"),
                HasSubstr("accessors[0]: 3 elements from byte 4"));
    EXPECT_THAT(error(R"("byteLength":40)", R"("componentType":5126,"count":3)"),
                HasSubstr("bufferViews[0]: bytes"));
    // 2⁶⁴ − 4 as offset or stride · count would wrap around in 64 bits.
    EXPECT_THAT(
        error(R"("byteLength":36,"byteOffset":18446744073709551612)", R"("componentType":5126,"count":3)"),
        HasSubstr("bufferViews[0]"));
    EXPECT_THAT(
        error(R"("byteLength":36)", R"("componentType":5126,"count":3,"byteOffset":18446744073709551612)"),
        HasSubstr("accessors[0].byteOffset"));
    EXPECT_THAT(error(R"("byteLength":36)", R"("componentType":5126,"count":1537228672809129302)"),
                HasSubstr("accessors[0].count"));
    EXPECT_THAT(error(R"("byteLength":36,"byteStride":8)", R"("componentType":5126,"count":3)"),
                HasSubstr("bufferViews[0].byteStride: 8"));
    EXPECT_THAT(error(R"("byteLength":36)", R"("componentType":5130,"count":1)"),
                HasSubstr("componentType: 5130"));
}

TEST(GltfErrors, SmallFilesCannotFillTheMemory) {
    const std::string zeros = R"(,"accessors":[{"componentType":5126,"count":100000000,"type":"VEC3"}],)"
                              R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
    EXPECT_THAT(error_of("a.gltf", k_asset + zeros), HasSubstr("accessors[0].count: 100000000 elements"));

    // The same bytes again and again, each time as another accessor.
    std::string accessors;
    std::string primitives;
    for (int i = 0; i < 60; ++i) {
        accessors += std::string(i > 0 ? "," : "") +
                     R"({"bufferView":0,"componentType":5126,"count":30000,"type":"VEC3"})";
        primitives +=
            std::string(i > 0 ? "," : "") + R"({"attributes":{"POSITION":)" + std::to_string(i) + "}}";
    }
    EXPECT_THAT(error_of("a.glb", glb(k_asset +
                                          R"(,"buffers":[{"byteLength":360000}],"bufferViews":[{"buffer":0,)"
                                          R"("byteLength":360000}],"accessors":[)" +
                                          accessors + R"(],"meshes":[{"primitives":[)" + primitives + "]}]}",
                                      std::string(360000, '\1'))),
                HasSubstr("more vertices, indices or particles"));
}

TEST(GltfErrors, DeepNestingIsRefusedBeforeAnythingRecurses) {
    const std::string deep =
        k_asset + R"(,"extras":)" + std::string(100000, '[') + std::string(100000, ']') + "}";
    EXPECT_THAT(error_of("deep.gltf", deep), HasSubstr("nested more than 256 deep"));
}

TEST(GltfErrors, LimitsAreParameters) {
    const std::string small = k_asset + R"(,"extras":[1,2,3,4,5,6,7,8,9]})";
    EXPECT_EQ(error_of("a.gltf", small), "");
    EXPECT_THAT(error_of("a.gltf", small, {.file_bytes = 10}), HasSubstr("expected at most 10"));
    EXPECT_THAT(error_of("a.gltf", small, {.json_bytes = 10}), HasSubstr("expected at most 10"));
    EXPECT_THAT(error_of("a.gltf", small, {.json_values = 8}), HasSubstr("more than 8 values"));
}

TEST(GltfErrors, ImagesOutsideTheirBufferBecomePlaceholders) {
    const LogCapture log;
    const ScratchFolder folder;
    const Scene scene = import_gltf(folder.write(
        "a.glb",
        glb(k_asset +
                R"(,"buffers":[{"byteLength":4}],"bufferViews":[{"buffer":0,"byteOffset":1000000000,)"
                R"("byteLength":1000}],"images":[{"bufferView":0,"mimeType":"image/png"},{"uri":"no.png"}],)"
                R"("textures":[{"source":0},{"source":1}],"materials":[{"emissiveTexture":{"index":0},)"
                R"("normalTexture":{"index":1}}]})",
            "1234")));
    ASSERT_EQ(scene.images.size(), 2u);
    EXPECT_EQ(scene.images[0].width, 64u);
    EXPECT_EQ(log.lines(), 2);
    EXPECT_THAT(log.text(),
                AllOf(HasSubstr("images[0]"), HasSubstr("images[1]"), HasSubstr("\"no.png\" is missing")));
}

TEST(GltfErrors, LoopsAndDanglingReferencesNameTheElement) {
    EXPECT_THAT(error_of("a.gltf", k_asset + R"(,"nodes":[{"children":[1]},{"children":[0]}]})"),
                HasSubstr("a.gltf: nodes[0]: a loop of children"));
    EXPECT_THAT(error_of("a.gltf", k_asset + R"(,"nodes":[{"mesh":3}]})"),
                HasSubstr("nodes[0].mesh: mesh 3"));
    EXPECT_THAT(error_of("a.gltf", k_asset + R"(,"nodes":[{"translation":[1,2]}]})"),
                HasSubstr("nodes[0].translation: 2 numbers, expected 3"));
    EXPECT_THAT(error_of("a.gltf", k_asset + R"(,"scene":2,"scenes":[{}]})"), HasSubstr("scene: scene 2"));
    EXPECT_THAT(
        error_of("a.gltf", k_asset + R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":4}}]}]})"),
        HasSubstr("meshes[0].primitives[0].attributes.POSITION: accessor 4"));
}

}  // namespace
}  // namespace rambla::assets::test
