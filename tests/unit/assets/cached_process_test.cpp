#include "assets/cache/cached_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <span>
#include <thread>

#include "assets/cache/processed_payload.h"
#include "assets/generate/places.h"
#include "assets/mesh_columns.h"
#include "import_support.h"
#include "support/sample_scenes.h"
#include "unit/assets/process_support.h"
#include "unit/assets/processed_equality.h"

namespace rambla::assets::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t k_plenty = std::uint64_t{1} << 30;

Image noise(std::uint32_t side, std::uint32_t seed) {
    std::mt19937 random{seed};
    Image image{.name = "noise", .width = side, .height = side, .texels = {}};
    for (std::uint32_t i = 0; i < 4 * side * side; ++i)
        image.texels.push_back(static_cast<std::byte>(random() & 0xff));
    return image;
}

/// Two meshes, one of them skinned and morphing, and a material whose textures are of three uses.
Scene small_scene() {
    std::mt19937 random{1};
    Scene scene;
    scene.meshes = {torus(12, 8, 3.0f), random_full_mesh(random, 12, 8)};
    scene.meshes[0].name = "torus";
    scene.images = {noise(16, 2), noise(16, 3)};
    scene.textures = {{.name = "colour", .image = 0, .colour_space = ColourSpace::srgb, .sampler = {}},
                      {.name = "normals", .image = 1, .colour_space = ColourSpace::linear, .sampler = {}}};
    scene.materials.resize(1);
    scene.materials[0].base_colour_texture.texture = 0;
    scene.materials[0].normal_texture.texture = 1;
    scene.models = {{.name = "both", .parts = {{0, 0}, {1, 0}}}};
    return scene;
}
constexpr std::uint32_t k_results = 2 + 3;  ///< of small_scene: meshes, and colour, normals, roughness

std::vector<fs::path> entries(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder})
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(CachedProcess, TheSecondStartProcessesNothingAndGivesTheSame) {
    const ScratchFolder scratch;
    const Scene scene = small_scene();
    Cache first{scratch.path(), k_plenty};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> told;
    const CachedProcess made =
        process_cached(scene, {}, first,
                       [&](std::uint32_t done, std::uint32_t missing) { told.emplace_back(done, missing); });
    EXPECT_EQ(made.processed, k_results);
    EXPECT_EQ(told.size(), k_results);
    EXPECT_EQ(told.back(), std::pair(k_results, k_results));
    EXPECT_EQ(made.loaded, 0u);
    EXPECT_EQ(first.counts().stored, k_results);
    expect_equal(made.scene, process(scene, {}));

    Cache second{scratch.path(), k_plenty};
    const CachedProcess loaded = process_cached(scene, {}, second, [](std::uint32_t, std::uint32_t) {
        ADD_FAILURE() << "there is nothing to wait for";
    });
    EXPECT_EQ(loaded.processed, 0u);
    EXPECT_EQ(loaded.loaded, k_results);
    EXPECT_EQ(second.counts().stored, 0u);
    expect_equal(loaded.scene, made.scene);
}

TEST(CachedProcess, SamplesAndGeneratedPlacesComeBackFromTheCache) {
    const ScratchFolder scratch;
    const Scene city = generate_place("city:blocks=1x1,walkers=2,cars=1", 3).scene;
    for (const Scene& scene : {standing_scene(), moving_scene(), city}) {
        Cache cache{scratch.path(), k_plenty};
        const ProcessParameters fast{.textures = {.compression = Compression::fast}};
        const CachedProcess made = process_cached(scene, fast, cache);
        const CachedProcess loaded = process_cached(scene, fast, cache);
        EXPECT_EQ(loaded.processed, 0u) << "what is made is sound to those who read it";
        expect_equal(loaded.scene, made.scene);
    }
}

/// How many results are made anew after a change, when everything was there before it.
std::uint32_t made_after(const std::function<void(Scene&, ProcessParameters&)>& change) {
    const ScratchFolder scratch;
    Scene scene = small_scene();
    ProcessParameters parameters;
    Cache cache{scratch.path(), k_plenty};
    static_cast<void>(process_cached(scene, parameters, cache));
    change(scene, parameters);
    const CachedProcess after = process_cached(scene, parameters, cache);
    expect_equal(after.scene, process(scene, parameters));
    return after.processed;
}

TEST(CachedProcess, WhatAResultDependsOnIsInItsKeyAndNothingElse) {
    EXPECT_EQ(made_after([](Scene&, ProcessParameters&) {}), 0u);
    // Meshes: each column and what the scene says of them.
    for_each_column(small_scene().meshes[1], [number = 0](const auto&) mutable {
        EXPECT_EQ(made_after([number](Scene& scene, ProcessParameters&) {
                      int at = 0;
                      for_each_column(scene.meshes[1], [&](auto& column) {
                          if (at++ == number) std::swap(column[0], column[1]);
                      });
                  }),
                  1u)
            << "column " << number;
        ++number;
    });
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) {
                  std::swap(s.meshes[0].indices[0], s.meshes[0].indices[2]);
              }),
              1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.meshes[0].name = "ring"; }), 1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.meshes[1].morphs[0].name = "smile"; }), 1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.models[0].parts.pop_back(); }), 2u)
        << "the torus no longer meets others, and the other mesh is not shown";
    // Textures: texels, and how materials use them.
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.images[0].texels[77] ^= std::byte{1}; }), 1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.images[1].texels[77] ^= std::byte{1}; }), 2u)
        << "normals, and the roughness that they widen";
    EXPECT_EQ(
        made_after([](Scene& s, ProcessParameters&) { s.textures[0].colour_space = ColourSpace::linear; }),
        1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.materials[0].roughness = 0.5f; }), 1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.materials[0].normal_scale = 0.5f; }), 1u);
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.materials[0].emissive_texture.texture = 1; }),
              1u);
    // An alpha that is tested: the colours are of another use, and the meshes may be seen through.
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) { s.materials[0].alpha_mode = AlphaMode::mask; }),
              3u);
    // The same pictures at other places in the scene, and names of what is not kept.
    EXPECT_EQ(made_after([](Scene& s, ProcessParameters&) {
                  std::swap(s.images[0], s.images[1]);
                  std::swap(s.textures[0].image, s.textures[1].image);
                  std::swap(s.meshes[0], s.meshes[1]);
                  s.textures[0].name = "paint";
                  s.materials[0].name = "wall";
                  s.materials[0].metalness = 0.0f;
                  s.textures[0].sampler.wrap_u = WrapMode::clamp_to_edge;
              }),
              0u);
}

TEST(CachedProcess, EveryParameterIsInTheKey) {
    const auto expect_all_count = [](const auto& table, auto member, std::uint32_t results) {
        for (const auto& parameter : table) {
            EXPECT_EQ(made_after([&](Scene&, ProcessParameters& parameters) {
                          auto& group = parameters.*member;
                          const double before = parameter.get(group);
                          parameter.set(group,
                                        before == parameter.minimum ? parameter.maximum : parameter.minimum);
                          ASSERT_NE(parameter.get(group), before);
                      }),
                      results)
                << parameter.name;
        }
    };
    expect_all_count(k_mesh_parameters, &ProcessParameters::meshes, 2);
    expect_all_count(k_lod_parameters, &ProcessParameters::lods, 2);
    expect_all_count(k_occluder_parameters, &ProcessParameters::occluders, 2);
    expect_all_count(k_texture_parameters, &ProcessParameters::textures, 3);
}

TEST(CachedProcess, DamagedAndMissingEntriesAreMadeAnew) {
    const ScratchFolder scratch;
    const Scene scene = small_scene();
    Cache cache{scratch.path(), k_plenty};
    const CachedProcess made = process_cached(scene, {}, cache);
    const std::vector<fs::path> files = entries(scratch.path());
    ASSERT_EQ(files.size(), k_results);
    fs::remove(files[0]);
    fs::resize_file(files[1], fs::file_size(files[1]) / 2);
    std::fstream damaged{files[2], std::ios::binary | std::ios::in | std::ios::out};
    damaged.seekp(-1, std::ios::end);
    damaged.put('!');
    damaged.close();
    const CachedProcess healed = process_cached(scene, {}, cache);
    EXPECT_EQ(healed.processed, 3u);
    EXPECT_EQ(healed.loaded, k_results - 3);
    expect_equal(healed.scene, made.scene);
    EXPECT_EQ(process_cached(scene, {}, cache).processed, 0u);
}

TEST(CachedProcess, WhatIsWellStoredButDoesNotFitIsMadeAnew) {
    const Scene scene = small_scene();
    const ProcessedMesh ring = process_mesh(scene.meshes[0], {}, {});
    ProcessedMesh more_joints = process_mesh(scene.meshes[1], {.meets_others = true}, {});
    more_joints.mesh.joints[0].x = 500;
    Mesh bones = scene.meshes[1];
    bones.morphs.pop_back();
    Mesh bare = scene.meshes[1];
    bare.joints.clear();
    bare.weights.clear();
    Mesh lines = scene.meshes[1];
    lines.topology = Topology::lines;
    const std::vector<std::vector<std::byte>> strangers{{},
                                                        std::vector<std::byte>(100, std::byte{0xff}),
                                                        to_payload(ring),
                                                        to_payload(more_joints),
                                                        to_payload(process_mesh(bones, {}, {})),
                                                        to_payload(process_mesh(bare, {}, {})),
                                                        to_payload(process_mesh(lines, {}, {}))};
    for (std::size_t i = 0; i < strangers.size(); ++i) {
        SCOPED_TRACE(i);
        const ScratchFolder scratch;
        Scene one = small_scene();
        one.meshes.erase(one.meshes.begin());
        one.models[0].parts = {{0, k_none}};
        one.materials.clear();
        Cache cache{scratch.path(), k_plenty};
        const CachedProcess made = process_cached(one, {}, cache);
        ASSERT_EQ(made.processed, 1u);
        // The entry's own name is its key.
        const std::string name = entries(scratch.path()).at(0).stem().string();
        const ContentHash key{std::stoull(name.substr(0, 16), nullptr, 16),
                              std::stoull(name.substr(16), nullptr, 16)};
        ASSERT_EQ(cache.file_of(key), entries(scratch.path()).at(0));
        cache.store(key, strangers[i]);
        const CachedProcess after = process_cached(one, {}, cache);
        EXPECT_EQ(after.processed, 1u);
        expect_equal(after.scene, made.scene);
        EXPECT_EQ(process_cached(one, {}, cache).processed, 0u);
    }
}

TEST(CachedProcess, AFolderThatCannotBeWrittenToCostsOneWarning) {
    const ScratchFolder scratch;
    // Not a folder at all, which stops even those who may write everywhere.
    const fs::path file = scratch.write("occupied", "");
    const LogCapture log;
    Cache cache{file, k_plenty};
    const Scene scene = small_scene();
    expect_equal(process_cached(scene, {}, cache).scene, process(scene, {}));
    EXPECT_EQ(process_cached(scene, {}, cache).processed, k_results);
    EXPECT_EQ(log.lines(), 1) << log.text();
    EXPECT_THAT(log.text(), ::testing::HasSubstr(file.string()));
}

TEST(CachedProcess, ALimitThatTheSceneExceedsIsKept) {
    const ScratchFolder scratch;
    const Scene scene = small_scene();
    constexpr std::uint64_t k_limit = 4096;
    for (int start = 0; start < 3; ++start) {
        Cache cache{scratch.path(), k_limit};
        expect_equal(process_cached(scene, {}, cache).scene, process(scene, {}));
        std::uintmax_t bytes = 0;
        for (const fs::path& file : entries(scratch.path()))
            bytes += fs::file_size(file);
        EXPECT_LE(bytes, k_limit);
        EXPECT_GT(bytes, 0u);
    }
}

TEST(CachedProcess, ManyMayFillAndEmptyOneFolderAtOnce) {
    const ScratchFolder scratch;
    const Scene scene = small_scene();
    const ProcessedScene expected = process(scene, {});
    // A Cache each, as two programs have: they share nothing but the folder.
    const auto start_often = [&] {
        for (int round = 0; round < 20; ++round) {
            Cache cache{scratch.path(), k_plenty};
            expect_equal(process_cached(scene, {}, cache).scene, expected);
            EXPECT_EQ(cache.counts().failed, 0u);
            std::error_code gone;
            const std::vector<fs::path> files = entries(scratch.path());
            ASSERT_FALSE(files.empty());
            const fs::path& file = files[static_cast<std::size_t>(round) % files.size()];
            if (file.extension() == ".rambla") fs::remove(file, gone);
        }
    };
    std::thread other{start_often};
    start_often();
    other.join();
    Cache cache{scratch.path(), k_plenty};
    static_cast<void>(process_cached(scene, {}, cache));
    EXPECT_EQ(process_cached(scene, {}, cache).processed, 0u);
    EXPECT_EQ(entries(scratch.path()).size(), k_results) << "nothing unfinished stays";
}

TEST(ProcessingVersion, IsThatOfTheseResults) {
    Mesh mesh = box({0, 0, 0}, {4, 8, 2});
    add_box(mesh, {4, 0, 0}, {8, 2, 2});
    ContentHasher hasher;
    hasher.add(std::span<const std::byte>{to_payload(process_mesh(mesh, {}, {}))});
    Scene scene = small_scene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].alpha_mode = AlphaMode::mask;
    const TexturePlan plan = plan_textures(scene);
    for (std::size_t i = 0; i < plan.jobs.size(); ++i)
        hasher.add(std::span<const std::byte>{
            to_payload(process_texture(plan.jobs[i], plan.channels[i], scene.images, {}))});
    EXPECT_EQ(to_string(hasher.hash()), "c73e01e1614632d3bf6f357742c992e5")
        << "Processing makes something else than it did, or payloads are laid out anew: raise "
           "k_processing_version, then put the new hash here.";
    EXPECT_EQ(k_processing_version, 2u);
}

}  // namespace
}  // namespace rambla::assets::test
