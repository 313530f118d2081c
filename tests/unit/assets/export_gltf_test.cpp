#include "assets/export/gltf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assets/library.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

using ::testing::ElementsAre;

Image checker() {
    Image image{.name = "checker", .width = 2, .height = 2, .format = PixelFormat::rgba8, .texels = {}};
    for (const int value : {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 9, 8, 7, 255})
        image.texels.push_back(static_cast<std::byte>(value));
    return image;
}

/// One of everything that a scene can hold.
Scene rich_scene() {
    Scene scene;
    scene.name = "all";
    scene.images = {checker()};
    scene.textures = {{.name = "c", .image = 0, .colour_space = ColourSpace::srgb, .sampler = {}},
                      {.name = "n",
                       .image = 0,
                       .colour_space = ColourSpace::linear,
                       .sampler = {.wrap_u = WrapMode::mirrored_repeat,
                                   .wrap_v = WrapMode::clamp_to_edge,
                                   .magnify = Filter::nearest,
                                   .minify = Filter::nearest,
                                   .mip = MipFilter::linear}}};
    Material material;
    material.name = "brick";
    material.base_colour = {0.1f, 0.2f, 0.3f, 0.4f};
    material.metalness = 0.7f;
    material.roughness = 0.6f;
    material.emissive = {8.0f, 2.0f, 0.0f};
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = 0.3f;
    material.double_sided = true;
    material.base_colour_texture = {
        .texture = 0, .uv_set = 1, .offset = {0.5f, 0.25f}, .scale = {2, 3}, .rotation_rad = 0.5f};
    material.normal_texture.texture = 1;
    material.normal_scale = 0.5f;
    Material plain;
    plain.unlit = true;
    plain.alpha_mode = AlphaMode::blend;
    scene.materials = {material, plain};
    Mesh mesh;
    mesh.name = "house";
    mesh.positions = {{0, 0, 0.1f}, {1, 0, 0}, {0, 1, 1.0f / 3.0f}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, -1});
    mesh.uv0 = {{0, 0}, {1, 0}, {0, 1}};
    mesh.uv1 = {{0.5f, 0}, {1, 0.1f}, {0, 1}};
    mesh.colours.assign(3, {0.1f, 0.2f, 0.3f, 1.0f});
    mesh.indices = {0, 1, 2};
    Mesh lines;
    lines.name = "house";
    lines.topology = Topology::lines;
    lines.positions = {{0, 0, 0}, {1, 1, 1}};
    lines.indices = {0, 1};
    scene.meshes = {mesh, lines};
    scene.models = {{.name = "house", .parts = {{0, 0}, {1, 1}, {0, 1}}}};
    Camera ortho;
    ortho.kind = CameraKind::orthographic;
    ortho.far_m = 50.0f;
    scene.cameras = {Camera{}, ortho};
    scene.lights = {{.name = "sun", .kind = LightKind::directional, .intensity = 3.0f},
                    {.name = "lamp",
                     .kind = LightKind::spot,
                     .colour = {1, 0.5f, 0.25f},
                     .intensity = 40,
                     .range_m = 12,
                     .inner_cone_rad = 0.25f,
                     .outer_cone_rad = 0.5f}};
    scene.nodes.resize(4);
    scene.nodes[0].name = "root";
    scene.nodes[0].children = {1, 2};
    scene.nodes[0].local.translation_m = {1, 2, 3};
    scene.nodes[1] = {
        .name = "mirrored", .parent = 0, .children = {}, .local = {}, .model = 0, .camera = 0, .light = 0};
    scene.nodes[1].local.scale = {-1, 2, 1};
    scene.nodes[1].local.rotation = glm::normalize(glm::quat{0.5f, 0.1f, 0.7f, -0.2f});
    scene.nodes[2] = {
        .name = "lamp", .parent = 0, .children = {}, .local = {}, .model = k_none, .camera = 1, .light = 1};
    scene.nodes[3] = {.name = "prototype", .parent = k_none, .children = {}, .local = {}, .model = 0};
    scene.roots = {0};
    return scene;
}

void expect_equal(const TextureSlot& a, const TextureSlot& b) {
    EXPECT_EQ(a.texture, b.texture);
    EXPECT_EQ(a.uv_set, b.uv_set);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.rotation_rad, b.rotation_rad);
}

void expect_equal(const Material& a, const Material& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.base_colour, b.base_colour);
    EXPECT_EQ(a.metalness, b.metalness);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.normal_scale, b.normal_scale);
    for (int c = 0; c < 3; ++c)
        EXPECT_FLOAT_EQ(a.emissive[c], b.emissive[c]);  // factor times strength
    EXPECT_EQ(a.alpha_mode, b.alpha_mode);
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    EXPECT_EQ(a.double_sided, b.double_sided);
    EXPECT_EQ(a.unlit, b.unlit);
    expect_equal(a.base_colour_texture, b.base_colour_texture);
    expect_equal(a.metalness_roughness_texture, b.metalness_roughness_texture);
    expect_equal(a.normal_texture, b.normal_texture);
    expect_equal(a.occlusion_texture, b.occlusion_texture);
    expect_equal(a.emissive_texture, b.emissive_texture);
}

void expect_equal(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.roots, b.roots);
    ASSERT_EQ(a.images.size(), b.images.size());
    for (std::size_t i = 0; i < a.images.size(); ++i)
        EXPECT_TRUE(a.images[i].texels == b.images[i].texels);
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t i = 0; i < a.textures.size(); ++i) {
        EXPECT_EQ(a.textures[i].image, b.textures[i].image);
        EXPECT_EQ(a.textures[i].colour_space, b.textures[i].colour_space);
        EXPECT_EQ(a.textures[i].sampler, b.textures[i].sampler);
    }
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i)
        expect_equal(a.materials[i], b.materials[i]);
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_EQ(a.meshes[i].topology, b.meshes[i].topology);
        EXPECT_EQ(a.meshes[i].positions, b.meshes[i].positions);
        EXPECT_EQ(a.meshes[i].normals, b.meshes[i].normals);
        EXPECT_EQ(a.meshes[i].tangents, b.meshes[i].tangents);
        EXPECT_EQ(a.meshes[i].uv0, b.meshes[i].uv0);
        EXPECT_EQ(a.meshes[i].uv1, b.meshes[i].uv1);
        EXPECT_EQ(a.meshes[i].colours, b.meshes[i].colours);
        EXPECT_EQ(a.meshes[i].indices, b.meshes[i].indices);
    }
    ASSERT_EQ(a.models.size(), b.models.size());
    for (std::size_t i = 0; i < a.models.size(); ++i) {
        ASSERT_EQ(a.models[i].parts.size(), b.models[i].parts.size());
        for (std::size_t p = 0; p < a.models[i].parts.size(); ++p) {
            EXPECT_EQ(a.models[i].parts[p].mesh, b.models[i].parts[p].mesh);
            EXPECT_EQ(a.models[i].parts[p].material, b.models[i].parts[p].material);
        }
    }
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (std::size_t i = 0; i < a.cameras.size(); ++i) {
        EXPECT_EQ(a.cameras[i].kind, b.cameras[i].kind);
        EXPECT_EQ(a.cameras[i].vertical_fov_rad, b.cameras[i].vertical_fov_rad);
        EXPECT_EQ(a.cameras[i].near_m, b.cameras[i].near_m);
    }
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
        EXPECT_EQ(a.lights[i].kind, b.lights[i].kind);
        EXPECT_EQ(a.lights[i].colour, b.lights[i].colour);
        EXPECT_EQ(a.lights[i].intensity, b.lights[i].intensity);
        EXPECT_EQ(a.lights[i].range_m, b.lights[i].range_m);
        EXPECT_EQ(a.lights[i].inner_cone_rad, b.lights[i].inner_cone_rad);
        EXPECT_EQ(a.lights[i].outer_cone_rad, b.lights[i].outer_cone_rad);
    }
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(a.nodes[i].name, b.nodes[i].name);
        EXPECT_EQ(a.nodes[i].parent, b.nodes[i].parent);
        EXPECT_EQ(a.nodes[i].children, b.nodes[i].children);
        EXPECT_EQ(matrix(a.nodes[i].local), matrix(b.nodes[i].local));
        EXPECT_EQ(a.nodes[i].model, b.nodes[i].model);
        EXPECT_EQ(a.nodes[i].camera, b.nodes[i].camera);
        EXPECT_EQ(a.nodes[i].light, b.nodes[i].light);
    }
}

TEST(GltfExport, EverythingComesBackEqual) {
    const ScratchFolder folder;
    const Scene scene = rich_scene();
    export_gltf(folder.path() / "all.glb", scene);
    const LogCapture log;
    const Scene back = import_gltf(folder.path() / "all.glb");
    EXPECT_EQ(log.text(), "");
    EXPECT_EQ(back.name, "all");
    expect_equal(scene, back);
}

TEST(GltfExport, ImportedSceneComesBackEqual) {
    const std::filesystem::path models = corpus("GltfExport.ImportedSceneComesBackEqual: 4 files");
    if (models.empty()) return;
    const LogCapture log;
    for (const char* name :
         {"models/FlightHelmet/glTF-512px/FlightHelmet.gltf", "models/Cameras/glTF-Embedded/Cameras.gltf",
          "models/AlphaBlendModeTest/glTF-Binary/AlphaBlendModeTest.glb", "scenes/garage/garage.gltf"}) {
        SCOPED_TRACE(name);
        const ScratchFolder folder;
        const Scene first = import_gltf(models / name);
        export_gltf(folder.path() / "again.glb", first);
        expect_equal(first, import_gltf(folder.path() / "again.glb"));
    }
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

TEST(Library, AppendedIndicesPointBehindTheFirstScene) {
    Scene both = rich_scene();
    const SceneOffsets at = append(both, rich_scene());
    EXPECT_EQ(at.images, 1u);
    EXPECT_EQ(at.textures, 2u);
    EXPECT_EQ(at.materials, 2u);
    EXPECT_EQ(at.meshes, 2u);
    EXPECT_EQ(at.models, 1u);
    EXPECT_EQ(at.cameras, 2u);
    EXPECT_EQ(at.lights, 2u);
    EXPECT_EQ(at.nodes, 4u);
    EXPECT_THAT(both.roots, ElementsAre(0, 4));
    EXPECT_EQ(both.textures[3].image, 1u);
    EXPECT_EQ(both.materials[2].base_colour_texture.texture, 2u);
    EXPECT_EQ(both.materials[2].normal_texture.texture, 3u);
    EXPECT_EQ(both.materials[2].emissive_texture.texture, k_none);
    EXPECT_EQ(both.models[1].parts[1].mesh, 3u);
    EXPECT_EQ(both.models[1].parts[1].material, 3u);
    EXPECT_THAT(both.nodes[4].children, ElementsAre(5, 6));
    EXPECT_EQ(both.nodes[4].parent, k_none);
    EXPECT_EQ(both.nodes[5].parent, 4u);
    EXPECT_EQ(both.nodes[5].model, 1u);
    EXPECT_EQ(both.nodes[5].camera, 2u);
    EXPECT_EQ(both.nodes[6].light, 3u);
    EXPECT_EQ(both.nodes[6].model, k_none);
}

}  // namespace
}  // namespace rambla::assets::test
