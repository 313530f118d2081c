#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "assets/process/tangents.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<fs::path> gltf_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        if (const fs::path extension = entry.path().extension(); extension == ".gltf" || extension == ".glb")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == std::string::npos;
}

void expect_consistent(const Scene& scene, const std::string& file) {
    const auto below = [](std::uint32_t index, std::size_t size) {
        return index == k_none || index < size;
    };
    for (const Mesh& mesh : scene.meshes) {
        const std::size_t n = mesh.positions.size();
        for (const std::uint32_t index : mesh.indices)
            ASSERT_LT(index, n) << file;
        for (const std::size_t size : {mesh.normals.size(), mesh.tangents.size(), mesh.uv0.size(),
                                       mesh.uv1.size(), mesh.colours.size()})
            ASSERT_TRUE(size == 0 || size == n) << file;
        for (const glm::vec3& p : mesh.positions)
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << file;
        // Computed and given normals alike; 1e-3 is what files store.
        for (const glm::vec3& normal : mesh.normals)
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-3f) << file;
        for (const glm::vec4& t : mesh.tangents)
            ASSERT_NEAR(glm::length(glm::vec3{t}), 1.0f, 1e-3f) << file;
    }
    for (const Model& model : scene.models)
        for (const ModelPart& part : model.parts) {
            ASSERT_LT(part.mesh, scene.meshes.size()) << file;
            ASSERT_TRUE(below(part.material, scene.materials.size())) << file;
        }
    for (const Texture& texture : scene.textures)
        ASSERT_LT(texture.image, scene.images.size()) << file;
    for (const Image& image : scene.images)
        ASSERT_EQ(image.texels.size(),
                  std::size_t{image.width} * image.height * bytes_per_texel(image.format))
            << file;
    for (const Node& node : scene.nodes) {
        ASSERT_TRUE(below(node.parent, scene.nodes.size())) << file;
        ASSERT_TRUE(below(node.model, scene.models.size())) << file;
        ASSERT_TRUE(below(node.camera, scene.cameras.size())) << file;
        ASSERT_TRUE(below(node.light, scene.lights.size())) << file;
    }
    for (const std::uint32_t root : scene.roots)
        ASSERT_LT(root, scene.nodes.size()) << file;
}

TEST(GltfCorpus, EveryFileLoadsOrIsRefusedInOneLine) {
    const fs::path folder = corpus("GltfCorpus.EveryFileLoadsOrIsRefusedInOneLine: 306 files");
    if (folder.empty()) return;
    const LogCapture log;
    std::map<std::string, int> total;
    std::map<std::string, int> loaded;
    std::string refused;
    for (const fs::path& file : gltf_files(folder)) {
        const std::string group = fs::relative(file, folder).begin()->string();
        ++total[group];
        try {
            expect_consistent(import_gltf(file), file.string());
            ++loaded[group];
        } catch (const Error& error) {
            EXPECT_TRUE(is_one_line(error.what())) << error.what();
            EXPECT_THAT(error.what(), HasSubstr(file.filename().string()));
            refused.append(group).append(": ").append(error.what()).append("\n");
        }
    }
    // The corpus' README: 306 files; all models, characters, scenes and odd but valid files must load.
    const std::map<std::string, int> expected{{"characters", 2}, {"edge-valid", 69}, {"malformed", 131},
                                              {"models", 47},    {"scenes", 45},     {"unsupported", 12}};
    EXPECT_EQ(total, expected);
    for (const char* group : {"characters", "models", "scenes"})
        EXPECT_EQ(loaded[group], expected.at(group)) << refused;
    // One of them asks for glTF 2.1 and is refused by its version.
    EXPECT_EQ(loaded["edge-valid"], expected.at("edge-valid") - 1) << refused;
    // Quantised data and pictures with a PNG fallback are all of this group that can be shown.
    EXPECT_EQ(loaded["unsupported"], 3) << refused;
    EXPECT_GT(total["malformed"], loaded["malformed"]);
}

TEST(GltfCorpus, UnsupportedFilesAreRefusedByTheNameOfWhatTheyNeed) {
    const fs::path folder = corpus("GltfCorpus.UnsupportedFilesAreRefusedByTheNameOfWhatTheyNeed: 10 files");
    if (folder.empty()) return;
    const std::map<std::string, std::string> expected{
        {"Box-draco/Box.gltf", "KHR_draco_mesh_compression"},
        {"RiggedFigure-draco/RiggedFigure.gltf", "KHR_draco_mesh_compression"},
        {"LittlestTokyo-draco.glb", "KHR_draco_mesh_compression"},
        {"BoxMeshopt.glb", "EXT_meshopt_compression"},
        {"meshopt-no-fallback/meshopt-no-fallback.gltf", "EXT_meshopt_compression"},
        {"BoxTexturedKtx2Basis.glb", "KHR_texture_basisu"},
        {"webp-required/box-textured-separate.gltf", "EXT_texture_webp"},
        {"../edge-valid/gltf-validator/base/asset/min_version_valid.gltf", "asset.minVersion: \"2.1\""},
        {"glTF-1.0/Box.gltf", "asset.version: \"1.0\""},
        {"glTF-1.0/Box.glb", "GLB version 1"}};
    for (const auto& [file, reason] : expected)
        EXPECT_THAT(import_error(folder / "unsupported" / file), HasSubstr(reason)) << file;
}

TEST(GltfCorpus, TheFormsOfTheBoxAreEqualToTheBit) {
    const fs::path folder = corpus("GltfCorpus.TheFormsOfTheBoxAreEqualToTheBit: 4 files");
    if (folder.empty()) return;
    const fs::path models = folder / "models";
    const Scene box = import_gltf(models / "Box/glTF/Box.gltf");
    ASSERT_EQ(box.meshes.size(), 1u);
    ASSERT_EQ(box.meshes[0].positions.size(), 24u);
    ASSERT_EQ(box.meshes[0].indices.size(), 36u);
    for (const char* form : {"Box/glTF-Binary/Box.glb", "Box/glTF-Embedded/Box.gltf"}) {
        const Scene other = import_gltf(models / form);
        EXPECT_EQ(other.meshes[0].positions, box.meshes[0].positions) << form;
        EXPECT_EQ(other.meshes[0].normals, box.meshes[0].normals) << form;
        EXPECT_EQ(other.meshes[0].indices, box.meshes[0].indices) << form;
        ASSERT_EQ(other.nodes.size(), box.nodes.size()) << form;
        EXPECT_EQ(matrix(other.nodes[0].local), matrix(box.nodes[0].local)) << form;
        EXPECT_EQ(other.materials[0].base_colour, box.materials[0].base_colour) << form;
    }
    // The interleaved box lists its vertices in the same order.
    const Scene interleaved = import_gltf(models / "BoxInterleaved/glTF/BoxInterleaved.gltf");
    EXPECT_EQ(interleaved.meshes[0].positions, box.meshes[0].positions);
    EXPECT_EQ(interleaved.meshes[0].normals, box.meshes[0].normals);
    EXPECT_EQ(interleaved.meshes[0].indices, box.meshes[0].indices);
}

TEST(GltfCorpus, NumbersOfTheManifestAreMet) {
    const fs::path folder = corpus("GltfCorpus.NumbersOfTheManifestAreMet: 4 files");
    if (folder.empty()) return;
    const auto triangles = [](const Scene& scene) {
        std::size_t count = 0;
        for (const Model& model : scene.models)
            for (const ModelPart& part : model.parts)
                if (scene.meshes[part.mesh].topology == Topology::triangles)
                    count += scene.meshes[part.mesh].indices.size() / 3;
        return count;
    };
    // Values of the corpus' README and MANIFEST.csv.
    const Scene helmet = import_gltf(folder / "models/FlightHelmet/glTF-512px/FlightHelmet.gltf");
    EXPECT_EQ(triangles(helmet), 94'722u);
    EXPECT_EQ(helmet.materials.size(), 6u);
    EXPECT_EQ(helmet.images.size(), 15u);
    const Scene scenes = import_gltf(folder / "models/MultipleScenes/glTF/MultipleScenes.gltf");
    EXPECT_EQ(scenes.roots, std::vector<std::uint32_t>{1});
    const Scene modes = import_gltf(folder / "models/MeshPrimitiveModes/glTF/MeshPrimitiveModes.gltf");
    EXPECT_GE(modes.meshes.size(), 7u);
    const LogCapture log;
    const Scene spheres = import_gltf(
        folder / "models/MetalRoughSpheresNoTextures/glTF-Binary/MetalRoughSpheresNoTextures.glb");
    EXPECT_EQ(spheres.materials.size(), 98u);
    // The spheres of one shape share accessors and thus their geometry.
    EXPECT_LT(spheres.meshes.size(), spheres.models.size());
}

/// The file's tangents come from another program: they say which way w points in glTF.
TEST(GltfCorpus, ComputedTangentsAgreeWithThoseInTheFile) {
    const fs::path folder = corpus("GltfCorpus.ComputedTangentsAgreeWithThoseInTheFile: 1 file");
    if (folder.empty()) return;
    const Scene scene = import_gltf(folder / "models/FlightHelmet/glTF-512px/FlightHelmet.gltf");
    std::size_t same_direction = 0;
    std::size_t same_sign = 0;
    std::size_t total = 0;
    for (const Mesh& mesh : scene.meshes) {
        Mesh computed = mesh;
        compute_tangents(computed);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const glm::vec4 theirs = mesh.tangents[mesh.indices[i]];
            const glm::vec4 ours = computed.tangents[computed.indices[i]];
            constexpr float k_cos_15_degrees = 0.966f;
            same_direction += glm::dot(glm::vec3{ours}, glm::vec3{theirs}) > k_cos_15_degrees ? 1 : 0;
            same_sign += ours.w == theirs.w ? 1 : 0;
            ++total;
        }
    }
    // The weights differ where many triangles meet, and seams were merged by the exporter.
    EXPECT_GT(static_cast<double>(same_direction), 0.95 * static_cast<double>(total));
    EXPECT_GT(static_cast<double>(same_sign), 0.99 * static_cast<double>(total));
}

}  // namespace
}  // namespace rambla::assets::test
