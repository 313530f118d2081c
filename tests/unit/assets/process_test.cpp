#include "assets/process/process.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "assets/mesh_columns.h"
#include "assets/process/blocks.h"
#include "unit/assets/generate_support.h"
#include "unit/assets/process_support.h"

namespace rambla::assets::test {
namespace {

Image checks(std::uint32_t width, std::uint32_t height, std::array<int, 4> dark, std::array<int, 4> light) {
    Image image{.name = {}, .width = width, .height = height, .texels = {}};
    for (std::uint32_t i = 0; i < width * height; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            image.texels.push_back(static_cast<std::byte>((i / 3 % 2 == 0 ? dark : light)[c]));
    return image;
}

/// Image 0 colours with alpha, 1 numbers, 2 normals, 3 float light, 4 a single texel; a texture for each, and
/// a second one of image 0 that repeats otherwise.
Scene pictures() {
    Scene scene;
    scene.images = {checks(16, 12, {10, 90, 30, 0}, {200, 180, 90, 255}),
                    checks(16, 16, {90, 120, 7, 255}, {200, 60, 255, 255}),
                    checks(16, 16, {90, 128, 250, 255}, {165, 128, 250, 255}),
                    {.name = {},
                     .width = 4,
                     .height = 4,
                     .format = PixelFormat::rgba32f,
                     .texels = std::vector<std::byte>(256)},
                    checks(1, 1, {1, 2, 3, 255}, {})};
    const auto texture = [](std::uint32_t image, ColourSpace space) {
        return Texture{.name = {}, .image = image, .colour_space = space, .sampler = {}};
    };
    scene.textures = {texture(0, ColourSpace::srgb),   texture(1, ColourSpace::linear),
                      texture(2, ColourSpace::linear), texture(3, ColourSpace::linear),
                      texture(4, ColourSpace::srgb),   texture(0, ColourSpace::srgb)};
    scene.textures[5].sampler.wrap_u = WrapMode::clamp_to_edge;
    return scene;
}

TextureSlot slot(std::uint32_t texture) {
    return {.texture = texture};
}

const TextureData& shown(const ProcessedScene& scene, const TextureSlot& used) {
    return scene.images[scene.textures[used.texture].image];
}

TEST(ProcessTextures, EachUseOfAPictureIsProcessedOnce) {
    Scene scene = pictures();
    scene.materials.resize(4);
    scene.materials[0].base_colour_texture = slot(0);
    scene.materials[1].base_colour_texture = slot(5);
    scene.materials[2].base_colour_texture = slot(0);
    scene.materials[2].emissive_texture = slot(5);
    const ProcessedScene same = process(scene, {});
    EXPECT_EQ(same.images.size(), 1u);
    EXPECT_EQ(same.textures.size(), 2u);  // two samplers
    EXPECT_EQ(same.materials[2].base_colour_texture.texture, same.materials[0].base_colour_texture.texture);
    EXPECT_EQ(same.textures[same.materials[1].base_colour_texture.texture].sampler.wrap_u,
              WrapMode::clamp_to_edge);
    EXPECT_EQ(same.textures[same.materials[2].base_colour_texture.texture].sampler.wrap_u, WrapMode::repeat);
    EXPECT_EQ(same.materials[3].base_colour_texture.texture, k_none);
    // Alpha tests of their own are uses of their own; opaque textures have no alpha.
    scene.materials[1].alpha_mode = AlphaMode::mask;
    scene.materials[2].alpha_mode = AlphaMode::mask;
    scene.materials[2].alpha_cutoff = 0.3f;
    const ProcessedScene tested = process(scene, {});
    EXPECT_EQ(tested.images.size(), 3u);
    EXPECT_EQ(shown(tested, tested.materials[0].base_colour_texture).format, TexelFormat::bc1);
    EXPECT_EQ(shown(tested, tested.materials[1].base_colour_texture).format, TexelFormat::bc3);
    EXPECT_EQ(shown(tested, tested.materials[1].base_colour_texture).colour_space, ColourSpace::srgb);
}

TEST(ProcessTextures, FormatsFollowTheChannelsThatAreRead) {
    Scene scene = pictures();
    scene.materials.resize(4);
    scene.materials[0].metalness_roughness_texture = slot(1);
    scene.materials[1].transmission_texture = slot(2);
    scene.materials[1].transmission = 1.0f;
    scene.materials[1].metalness = 0.0f;
    scene.materials[1].occlusion_texture = slot(0);
    scene.materials[2].emissive_texture = slot(3);
    scene.materials[2].base_colour_texture = slot(4);
    scene.materials[3].normal_texture = slot(2);
    scene.materials[3].metalness_roughness_texture = slot(4);
    const ProcessedScene out = process(scene, {});
    const TextureData& two = shown(out, out.materials[0].metalness_roughness_texture);
    EXPECT_EQ(two.format, TexelFormat::bc5);
    EXPECT_EQ(two.swizzle,
              (Swizzle{ChannelSource::one, ChannelSource::red, ChannelSource::green, ChannelSource::one}));
    ASSERT_EQ(two.levels.size(), 5u);
    const TextureLevel& finest = two.levels[0];
    const Image back = decompressed(std::span{two.bytes}.subspan(finest.offset, finest.size), two.format,
                                    finest.width, finest.height);
    EXPECT_EQ(std::to_integer<int>(back.texels[0]), 120);
    EXPECT_EQ(std::to_integer<int>(back.texels[1]), 7);
    EXPECT_EQ(finest.rms_error, 0.0f);  // two values a block
    EXPECT_EQ(shown(out, out.materials[1].transmission_texture).format, TexelFormat::bc4);
    EXPECT_EQ(shown(out, out.materials[1].occlusion_texture).format, TexelFormat::bc1)
        << "one channel, but sRGB, which bc4 cannot be";
    scene.materials[1].metalness = 1.0f;
    EXPECT_EQ(process(scene, {}).materials[1].transmission_texture.texture, k_none)
        << "metals let nothing through";
    EXPECT_EQ(shown(out, out.materials[2].emissive_texture).format, TexelFormat::rgba32f);
    EXPECT_EQ(shown(out, out.materials[2].base_colour_texture).format, TexelFormat::rgba8);
    const TextureData& normals = shown(out, out.materials[3].normal_texture);
    EXPECT_EQ(normals.format, TexelFormat::bc5);
    EXPECT_TRUE(normals.normal_map);
    // Occlusion beside them makes it three channels.
    scene.materials[0].occlusion_texture = slot(1);
    const ProcessedScene packed = process(scene, {});
    EXPECT_EQ(shown(packed, packed.materials[0].occlusion_texture).format, TexelFormat::bc1);
    EXPECT_EQ(packed.materials[0].occlusion_texture.texture,
              packed.materials[0].metalness_roughness_texture.texture);
    for (const TextureData& image : process(scene, {.textures = {.compression = Compression::off}}).images)
        EXPECT_TRUE(image.format == TexelFormat::rgba8 || image.format == TexelFormat::rgba32f);
}

TEST(ProcessTextures, LightMapsAreNotCompressed) {
    Scene scene = pictures();
    scene.materials.resize(2);
    scene.materials[0].light_map_texture = slot(0);
    scene.materials[0].emissive_texture = slot(0);
    scene.materials[1].light_map_texture = slot(3);
    const ProcessedScene out = process(scene, {});
    const TextureData& bytes = shown(out, out.materials[0].light_map_texture);
    EXPECT_EQ(bytes.format, TexelFormat::rgba8);
    EXPECT_EQ(bytes.colour_space, ColourSpace::srgb);
    EXPECT_EQ(shown(out, out.materials[0].emissive_texture).format, TexelFormat::bc1);
    EXPECT_EQ(shown(out, out.materials[1].light_map_texture).format, TexelFormat::rgba32f);
}

TEST(ProcessTextures, LevelsLieOneBehindTheOther) {
    Scene scene = pictures();
    scene.materials.resize(1);
    scene.materials[0].base_colour_texture = slot(0);
    scene.materials[0].alpha_mode = AlphaMode::mask;
    for (const Compression compression : {Compression::off, Compression::fast, Compression::good}) {
        const TextureData image = process(scene, {.textures = {.compression = compression}}).images[0];
        std::size_t end = 0;
        for (const TextureLevel& level : image.levels) {
            EXPECT_EQ(level.offset, end);
            EXPECT_EQ(level.size, stored_size(image.format, level.width, level.height));
            end += level.size;
        }
        EXPECT_EQ(image.bytes.size(), end);
        EXPECT_EQ(image.levels.size(), 5u);
        EXPECT_EQ(image.levels[4].width * image.levels[4].height, 1u);
    }
}

TEST(ProcessTextures, RoughnessTakesInWhatNormalMapsLose) {
    Scene scene = pictures();
    scene.materials.resize(4);
    for (Material& material : scene.materials) {
        material.roughness = 0.5f;
        material.normal_texture = slot(2);
    }
    scene.materials[0].metalness_roughness_texture = slot(1);
    scene.materials[0].occlusion_texture = slot(1);
    scene.materials[1].metalness_roughness_texture = slot(1);
    scene.materials[1].metalness_roughness_texture.scale = {2, 2};  // not the normal map's coordinates
    scene.materials[3].metalness_roughness_texture = slot(1);
    scene.materials[3].normal_texture = {};
    const ProcessedScene out = process(scene, {.textures = {.compression = Compression::off}});
    const auto green = [&](const Material& material, std::size_t level) {
        const TextureData& image = shown(out, material.metalness_roughness_texture);
        return std::to_integer<int>(image.bytes[image.levels[level].offset + 1]);
    };
    EXPECT_EQ(out.materials[0].roughness, 1.0f);
    EXPECT_EQ(green(out.materials[0], 0), 60);
    EXPECT_GT(green(out.materials[0], 4), 100);
    EXPECT_EQ(out.materials[0].occlusion_texture.texture,
              out.materials[0].metalness_roughness_texture.texture);
    EXPECT_EQ(out.materials[1].roughness, 0.5f);
    EXPECT_EQ(green(out.materials[1], 0), 120);
    EXPECT_EQ(out.materials[2].roughness, 1.0f);
    EXPECT_EQ(green(out.materials[2], 0), 128);
    EXPECT_GT(green(out.materials[2], 4), 128);
    EXPECT_EQ(out.materials[3].roughness, 0.5f);
    EXPECT_EQ(out.materials[3].metalness_roughness_texture.texture,
              out.materials[1].metalness_roughness_texture.texture);
    EXPECT_EQ(out.images.size(), 4u);  // normals, widened, made, plain
}

TEST(ProcessTextures, TheMaterialsFactorTakesPartInTheAlphaTest) {
    Scene scene = pictures();
    scene.materials.resize(2);
    for (Material& material : scene.materials) {
        material.alpha_mode = AlphaMode::mask;
        material.base_colour_texture = slot(0);
    }
    scene.materials[1].alpha_cutoff = 0.25f;
    scene.materials[1].base_colour.w = 0.5f;
    EXPECT_EQ(process(scene, {}).images.size(), 1u);
    EXPECT_FLOAT_EQ(plan_textures(scene).jobs[0].cutoff, 0.5f);
    scene.materials[1].base_colour.w = 0.0f;  // nothing passes
    EXPECT_EQ(plan_textures(scene).jobs[1].alpha, AlphaUse::blended);
}

TEST(ProcessMeshes, SceneSaysWhatMeshesAreFor) {
    Scene scene;
    scene.meshes = {box({0, 0, 0}, {9, 9, 9}), box({0, 0, 0}, {9, 9, 9}), box({0, 0, 0}, {9, 9, 9}),
                    grid(24, [](float x, float z) { return 0.1f * x * z; })};
    scene.meshes[2].joints.assign(24, {0, 0, 0, 0});
    scene.meshes[2].weights.assign(24, {1, 0, 0, 0});
    scene.materials.resize(2);
    scene.materials[1].alpha_mode = AlphaMode::blend;
    scene.models.resize(2);
    scene.models[0].parts = {{0, 0}, {3, 0}};
    scene.models[1].parts = {{1, 1}};
    const auto uses = mesh_uses(scene);
    EXPECT_TRUE(uses[0].meets_others);
    EXPECT_FALSE(uses[1].meets_others);
    const ProcessedScene out = process(scene, {});
    ASSERT_EQ(out.meshes.size(), 4u);
    EXPECT_EQ(out.meshes[0].occluder.boxes.size(), 1u);
    EXPECT_TRUE(out.meshes[1].occluder.boxes.empty());  // seen through
    EXPECT_TRUE(out.meshes[2].occluder.boxes.empty());  // moves
    const auto last_level = [](const ProcessedScene& processed) {
        return processed.meshes[3].lods.levels.back().range.count;
    };
    const ProcessedScene free = process(scene, {.meshes = {.lock_borders = BorderLock::never}});
    EXPECT_GT(last_level(out), 2 * last_level(free));
    EXPECT_EQ(last_level(process(scene, {.meshes = {.lock_borders = BorderLock::always}})), last_level(out));
}

TEST(ProcessMeshes, EverythingFitsTogether) {
    std::mt19937 random{31};
    Mesh mesh = torus(24, 12, 10.0f, 3.0f);
    mesh.positions.emplace_back(500, 500, 500);  // nothing uses it
    mesh.normals.emplace_back(0, 1, 0);
    mesh.uv0.emplace_back(0, 0);
    const ProcessedMesh out = process_mesh(mesh, {}, {});
    EXPECT_EQ(out.mesh.positions.size(), mesh.positions.size() - 1);
    EXPECT_EQ(out.mesh.indices.size(), mesh.indices.size());
    EXPECT_NEAR(out.mesh.bounds.max.x, 13.0f, 1e-4f);
    EXPECT_NEAR(out.sphere.radius, 13.0f, 0.2f);
    EXPECT_GE(out.lods.levels.size(), 2u);
    EXPECT_EQ(out.shadow.levels.size(), out.lods.levels.size() + 1);
    EXPECT_EQ(out.shadow.positions.size(), 24u * 12u);
    EXPECT_FALSE(out.occluder.boxes.empty());
    EXPECT_TRUE(process_mesh({}, {}, {}).lods.levels.empty());
}

std::uint64_t hash_of(const ProcessedScene& scene) {
    Hash hash;
    for (const ProcessedMesh& mesh : scene.meshes) {
        for_each_column(mesh.mesh, [&](const auto& column) { hash.add_all(column); });
        hash.add_all(mesh.mesh.indices);
        hash.add_all(mesh.lods.indices);
        for (const LodLevel& level : mesh.lods.levels)
            hash.add_all(std::vector{level.error_m, level.normal_error_deg, level.uv_error,
                                     static_cast<float>(level.range.first)});
        hash.add_all(mesh.shadow.positions);
        hash.add_all(mesh.shadow.indices);
        hash.add_all(std::vector{mesh.sphere.radius, mesh.occluder.gap_m, mesh.occluder.volume_share});
        hash.add_all(mesh.occluder.boxes);
    }
    for (const TextureData& image : scene.images) {
        hash.add_all(image.bytes);
        for (const TextureLevel& level : image.levels)
            hash.add_all(std::vector{level.rms_error, static_cast<float>(level.offset)});
    }
    for (const Material& material : scene.materials)
        hash.add_all(
            std::vector{material.base_colour_texture.texture, material.metalness_roughness_texture.texture});
    return hash.value();
}

TEST(Process, ResultsDoNotDependOnTheNumberOfThreads) {
    Scene scene = pictures();
    scene.images[0] = checks(80, 60, {10, 90, 30, 0}, {200, 180, 90, 255});
    scene.materials.resize(2);
    scene.materials[0].base_colour_texture = slot(0);
    scene.materials[0].alpha_mode = AlphaMode::mask;
    scene.materials[0].normal_texture = slot(2);
    scene.materials[1].base_colour_texture = slot(5);
    scene.meshes = {torus(32, 16, 5.0f, 2.0f),
                    box({0, 0, 0}, {9, 9, 9}),
                    flat_grid(16),
                    grid(24, [](float x, float z) { return 0.1f * std::sin(9 * x) * z; }),
                    {}};
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 8}) {
        const tbb::global_control limit{tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads)};
        tbb::task_arena arena{threads};
        for (int run = 0; run < 2; ++run)
            hashes.push_back(arena.execute([&] { return hash_of(process(scene, {})); }));
    }
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes[0]), 6);
    scene.meshes[0].positions[0].x += 0.01f;
    EXPECT_NE(hash_of(process(scene, {})), hashes[0]) << "the hash must see what changes";
}

template <class Table>
void expect_defaults_in_range(const Table& table) {
    for (const auto& entry : table) {
        const double value = entry.get({});
        EXPECT_GE(value, entry.minimum) << entry.name;
        EXPECT_LE(value, entry.maximum) << entry.name;
    }
}

TEST(Process, ParametersDefaultsLieInTheirRanges) {
    expect_defaults_in_range(k_mesh_parameters);
    expect_defaults_in_range(k_lod_parameters);
    expect_defaults_in_range(k_occluder_parameters);
    expect_defaults_in_range(k_texture_parameters);
}

}  // namespace
}  // namespace rambla::assets::test
