#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assets/export/image.h"
#include "assets/import/gltf_facts.h"
#include "assets/import/image.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;

Image square() {
    return {.name = "square", .width = 2, .height = 2, .texels = std::vector<std::byte>(16, std::byte{200})};
}

TEST(GltfFacts, TellWhatTheDocumentSaysAndWhereItsPicturesAre) {
    const ScratchFolder folder;
    write_image(folder.path() / "wall.png", square());
    const std::uint64_t picture_bytes = std::filesystem::file_size(folder.path() / "wall.png");
    const auto file = folder.write("wall.gltf", R"({"asset":{"version":"2.0","generator":"by hand"},
"extensionsUsed":["KHR_texture_transform","VENDOR_b","VENDOR_a"],"extensionsRequired":["KHR_texture_transform"],
"scene":1,"scenes":[{},{"name":"shown","nodes":[1,0]}],"nodes":[{},{}],
"materials":[{"emissiveTexture":{"index":0},"pbrMetallicRoughness":{"baseColorTexture":{"index":1,
"extensions":{"KHR_texture_transform":{"scale":[2,2]}}}}},{"extensions":{"VENDOR_a":{}},"normalTexture":{"index":2}}],
"textures":[{"source":1},{"source":0},{}],"images":[{"uri":"wall.png"},{"uri":"lost.png"}],
"buffers":[{"byteLength":2,"uri":"data:application/octet-stream;base64,AAA="}]})");
    const LogCapture log;
    const auto [scene, facts] = import_gltf_with_facts(file);
    EXPECT_EQ(facts.generator, "by hand");
    EXPECT_EQ(facts.version, "2.0");
    EXPECT_EQ(facts.default_scene, 1u);
    ASSERT_EQ(facts.scenes.size(), 2u);
    EXPECT_EQ(facts.scenes[1].name, "shown");
    EXPECT_THAT(facts.scenes[1].roots, ElementsAre(1, 0));
    EXPECT_THAT(facts.extensions_used, ElementsAre("KHR_texture_transform", "VENDOR_a", "VENDOR_b"));
    EXPECT_THAT(facts.extensions_required, ElementsAre("KHR_texture_transform"));
    EXPECT_THAT(facts.extensions_ignored, ElementsAre("VENDOR_a", "VENDOR_b"));
    ASSERT_EQ(facts.material_extensions.size(), scene.materials.size());
    EXPECT_THAT(facts.material_extensions[0], ElementsAre("KHR_texture_transform"));
    EXPECT_THAT(facts.material_extensions[1], ElementsAre("VENDOR_a"));
    EXPECT_EQ(facts.buffer_bytes, 2u);
    EXPECT_EQ(facts.document_bytes, std::filesystem::file_size(file));
    // In the order of the textures: the lost picture, the wall, and the texture without an image.
    ASSERT_EQ(facts.images.size(), 3u);
    ASSERT_EQ(scene.images.size(), 3u);
    EXPECT_EQ(facts.images[0].source, "lost.png");
    EXPECT_EQ(facts.images[0].encoded_bytes, 0u);
    EXPECT_EQ(facts.images[1].source, "wall.png");
    EXPECT_EQ(facts.images[1].format, "png");
    EXPECT_EQ(facts.images[1].encoded_bytes, picture_bytes);
    EXPECT_EQ(scene.images[1].width, 2u);
    EXPECT_EQ(facts.images[2].source, "placeholder");
}

TEST(GltfCorpusFacts, ComeWithTheSceneThatTheImporterReturns) {
    const std::filesystem::path folder =
        corpus("GltfCorpusFacts.ComeWithTheSceneThatTheImporterReturns: 1 file");
    if (folder.empty()) return;
    const auto file = folder / "models/FlightHelmet/glTF-512px/FlightHelmet.gltf";
    const Scene plain = import_gltf(file);
    const auto [scene, facts] = import_gltf_with_facts(file);
    EXPECT_EQ(scene.name, plain.name);
    ASSERT_EQ(scene.meshes.size(), plain.meshes.size());
    EXPECT_EQ(scene.meshes[3].positions, plain.meshes[3].positions);
    EXPECT_EQ(facts.images.size(), 15u);
    EXPECT_EQ(facts.material_extensions.size(), 6u);
}

TEST(PictureFacts, TellFormatSizeAndChannels) {
    const ScratchFolder folder;
    Image light{.name = "light", .width = 3, .height = 1, .format = PixelFormat::rgba32f, .texels = {}};
    light.texels.resize(48);
    write_image(folder.path() / "light.exr", light);
    const auto [image, facts] = read_image_with_facts(folder.path() / "light.exr");
    EXPECT_EQ(facts.format, "openexr");
    EXPECT_EQ(facts.width, 3u);
    EXPECT_EQ(facts.height, 1u);
    EXPECT_THAT(facts.channels, ElementsAre("R", "G", "B", "A"));
    EXPECT_EQ(facts.sample, "half");
    EXPECT_EQ(facts.file_bytes, std::filesystem::file_size(folder.path() / "light.exr"));
    EXPECT_EQ(image.name, "light.exr");
    EXPECT_EQ(image.texels.size(), 48u);
    write_image(folder.path() / "square.png", square());
    EXPECT_EQ(read_image_with_facts(folder.path() / "square.png").facts.sample, "uint8");
}

}  // namespace
}  // namespace rambla::assets::test
