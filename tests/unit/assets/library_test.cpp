#include "assets/library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;

/// Two of everything, where each index points at the second.
Scene scene_of_two() {
    Scene scene;
    scene.images.resize(2);
    scene.textures.resize(2);
    for (Texture& texture : scene.textures)
        texture.image = 1;
    scene.materials.resize(2);
    for (Material& material : scene.materials)
        for_each_texture_slot(material, [](TextureSlot& slot) { slot.texture = 1; });
    scene.meshes.resize(2);
    scene.models.resize(2);
    for (Model& model : scene.models)
        model.parts = {{1, 1}, {0, k_none}};
    scene.cameras.resize(2);
    scene.lights.resize(2);
    scene.emitters.resize(2);
    for (Emitter& emitter : scene.emitters)
        emitter.material = 1;
    scene.nodes.resize(2);
    scene.nodes[0].children = {1};
    scene.nodes[1].parent = 0;
    for (Node& node : scene.nodes) {
        node.model = node.camera = node.light = node.emitter = node.skeleton = 1;
        node.coarser = {1, 0};
    }
    scene.skeletons.resize(2);
    scene.clips.resize(2);
    for (Skeleton& skeleton : scene.skeletons)
        skeleton.joints = {0, 1};
    for (Clip& clip : scene.clips)
        clip.channels = {{.node = 1, .times_s = {0.0f}, .values = {0.0f, 0.0f, 0.0f}}};
    scene.roots = {0};
    return scene;
}

TEST(Library, AppendShiftsEveryIndex) {
    Scene world = scene_of_two();
    const SceneOffsets at = append(world, scene_of_two());
    for (const std::uint32_t offset : {at.images, at.textures, at.materials, at.meshes, at.models, at.cameras,
                                       at.lights, at.emitters, at.nodes, at.skeletons, at.clips})
        EXPECT_EQ(offset, 2u);
    EXPECT_EQ(world.textures[3].image, 3u);
    for_each_texture_slot(world.materials[3], [](const TextureSlot& slot) { EXPECT_EQ(slot.texture, 3u); });
    EXPECT_EQ(world.models[3].parts[0].mesh, 3u);
    EXPECT_EQ(world.models[3].parts[0].material, 3u);
    EXPECT_EQ(world.models[3].parts[1].material, k_none);
    const Node& node = world.nodes[3];
    EXPECT_EQ(node.parent, 2u);
    EXPECT_THAT(world.nodes[2].children, ElementsAre(3));
    EXPECT_EQ(world.nodes[2].parent, k_none);
    EXPECT_EQ(world.emitters[3].material, 3u);
    EXPECT_EQ(node.emitter, 3u);
    EXPECT_EQ(node.model, 3u);
    EXPECT_EQ(node.camera, 3u);
    EXPECT_EQ(node.light, 3u);
    EXPECT_EQ(node.skeleton, 3u);
    EXPECT_THAT(node.coarser, ElementsAre(3, 2));
    EXPECT_THAT(world.skeletons[3].joints, ElementsAre(2, 3));
    EXPECT_EQ(world.clips[3].channels[0].node, 3u);
    EXPECT_THAT(world.roots, ElementsAre(0, 2));
}

TEST(Library, AppendLeavesWhatWasThere) {
    Scene world = scene_of_two();
    append(world, scene_of_two());
    EXPECT_EQ(world.textures[1].image, 1u);
    EXPECT_EQ(world.models[1].parts[0].mesh, 1u);
    EXPECT_THAT(world.nodes[0].children, ElementsAre(1));
    EXPECT_THAT(world.nodes[1].coarser, ElementsAre(1, 0));
    EXPECT_THAT(world.skeletons[1].joints, ElementsAre(0, 1));
    EXPECT_EQ(world.clips[1].channels[0].node, 1u);
}

}  // namespace
}  // namespace rambla::assets::test
