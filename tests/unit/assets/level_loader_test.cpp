#include "assets/cache/level_loader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "assets/cache/processed_payload.h"
#include "import_support.h"
#include "support/texture_levels.h"

namespace rambla::assets::test {
namespace {

namespace fs = std::filesystem;
using tests::noise_texture;

constexpr std::uint64_t k_plenty = std::uint64_t{1} << 30;

std::vector<std::byte> expected(const TextureData& texture, std::uint32_t first, std::uint32_t end) {
    const auto bytes = bytes_of(texture, first, end);
    return {bytes.begin(), bytes.end()};
}

/// The answer to one request; an image that cannot be had gives no bytes.
std::vector<std::byte> bytes_from(LevelLoader& loader, const LevelRange& range) {
    loader.request(range);
    EXPECT_TRUE(loader.wait());
    const std::optional<LoadedLevels> levels = loader.take();
    EXPECT_TRUE(levels.has_value());
    EXPECT_EQ(levels->range, range);
    return levels->bytes;
}

/// A cache with the texture under a key.
struct Kept {
    explicit Kept(const TextureData& texture) {
        key = content_hash(texture.bytes);
        cache->store(key, to_payload(texture));
        origin = {key, texture};
        drop_levels(origin.image, static_cast<std::uint32_t>(texture.levels.size()));
    }
    ScratchFolder scratch;
    std::shared_ptr<Cache> cache = std::make_shared<Cache>(scratch.path(), k_plenty);
    ContentHash key;
    LevelOrigin origin;
};

TEST(TextureLevels, AreDroppedWithTheirBytesAlone) {
    const TextureData whole = noise_texture(300, 70, 1);
    TextureData texture = whole;
    EXPECT_EQ(floor_level(texture), 3u) << "37 texels";
    drop_levels(texture, 2);
    EXPECT_EQ(texture.first_stored, 2u);
    EXPECT_EQ(texture.levels.size(), whole.levels.size());
    EXPECT_EQ(texture.bytes.size(), whole.bytes.size() - whole.levels[2].offset);
    EXPECT_EQ(expected(texture, 3, 6), expected(whole, 3, 6));
    drop_levels(texture, 4);
    EXPECT_EQ(expected(texture, 4, 9), expected(whole, 4, 9));
    drop_levels(texture, 1);
    EXPECT_EQ(texture.first_stored, 4u) << "what is gone does not come back";
    drop_levels(texture, 9);
    EXPECT_TRUE(texture.bytes.empty());
}

TEST(LevelLoader, ReadsLevelsFromTheCacheAndFromMemory) {
    const TextureData texture = noise_texture(256, 128, 1);
    const TextureData other = noise_texture(64, 256, 2);
    Kept kept{texture};
    LevelLoader loader{kept.cache, {kept.origin, {std::nullopt, other}}};
    EXPECT_EQ(bytes_from(loader, {0, 0, 2}), expected(texture, 0, 2));
    EXPECT_EQ(bytes_from(loader, {0, 1, 3}), expected(texture, 1, 3));
    EXPECT_EQ(bytes_from(loader, {1, 0, 1}), expected(other, 0, 1));
    EXPECT_FALSE(loader.take().has_value()) << "each answer comes once";
    EXPECT_FALSE(loader.wait()) << "nothing is to come";
}

TEST(LevelLoader, AnswersInTheOrderOfTheRequests) {
    Kept kept{noise_texture(256, 256, 1)};
    LevelLoader loader{kept.cache, {kept.origin}};
    for (std::uint32_t first = 0; first < 5; ++first)
        loader.request({0, first, 6});
    for (std::uint32_t first = 0; first < 5; ++first) {
        ASSERT_TRUE(loader.wait());
        EXPECT_EQ(loader.take()->range.first, first);
    }
}

TEST(LevelLoader, HasNothingOfAnEntryThatIsGoneDamagedOrAnotherPicture) {
    Kept kept{noise_texture(128, 128, 1)};
    LevelLoader loader{kept.cache, {kept.origin}};
    EXPECT_FALSE(bytes_from(loader, {0, 0, 1}).empty());

    kept.cache->store(kept.key, to_payload(noise_texture(64, 128, 1)));
    EXPECT_TRUE(bytes_from(loader, {0, 0, 1}).empty()) << "of another size";
    kept.cache->store(kept.key, std::vector<std::byte>(100));
    EXPECT_TRUE(bytes_from(loader, {0, 0, 1}).empty()) << "no texture at all";

    kept.cache->store(kept.key, to_payload(noise_texture(128, 128, 1)));
    EXPECT_FALSE(bytes_from(loader, {0, 0, 1}).empty());
    std::fstream file{kept.cache->file_of(kept.key), std::ios::in | std::ios::out | std::ios::binary};
    file.seekp(5000);
    file.put('x');
    file.close();
    EXPECT_TRUE(bytes_from(loader, {0, 0, 1}).empty()) << "a byte has changed";
    EXPECT_FALSE(fs::exists(kept.cache->file_of(kept.key)));
    EXPECT_TRUE(bytes_from(loader, {0, 0, 1}).empty()) << "it is gone";
}

TEST(LevelLoader, EndsWithRequestsUnanswered) {
    Kept kept{noise_texture(512, 512, 1)};
    LevelLoader loader{kept.cache, {kept.origin}};
    for (int i = 0; i < 1000; ++i)
        loader.request({0, 0, 1});
}

TEST(LevelLoader, LetsNobodyWaitOnceItIsClosed) {
    Kept kept{noise_texture(64, 64, 1)};
    LevelLoader loader{kept.cache, {kept.origin}};
    std::thread closer{[&] {
        loader.close();
    }};
    for (int i = 0; i < 1000 && loader.wait(); ++i)
        loader.request({0, 0, 1});
    closer.join();
    loader.request({0, 0, 1});
    EXPECT_FALSE(loader.wait());
}

// From a scene to its levels.

Scene scene_of(std::uint32_t images, std::uint32_t side) {
    Scene scene;
    scene.materials.resize(images);
    for (std::uint32_t i = 0; i < images; ++i) {
        TextureData noise = noise_texture(side, side, i);
        noise.bytes.resize(std::size_t{4} * side * side);
        scene.images.push_back({.name = noise.name, .width = side, .height = side, .texels = noise.bytes});
        scene.textures.push_back({.name = "", .image = i, .colour_space = ColourSpace::srgb, .sampler = {}});
        scene.materials[i].base_colour_texture.texture = i;
    }
    return scene;
}

/// Processes and takes all levels apart and together again.
void expect_all_levels(const Scene& scene, const std::shared_ptr<Cache>& cache, std::size_t entries) {
    const ProcessedScene whole = process(scene, {});
    CachedProcess processed = process_cached(scene, {}, *cache, {}, KeptLevels::floors);
    std::size_t with_entry = 0;
    for (const std::optional<ContentHash>& entry : processed.texture_entries)
        with_entry += entry.has_value() ? 1 : 0;
    EXPECT_EQ(with_entry, entries);
    const std::shared_ptr<LevelLoader> loader = make_level_loader(processed, cache);
    ASSERT_EQ(processed.scene.images.size(), whole.images.size());
    for (std::uint32_t i = 0; i < whole.images.size(); ++i) {
        const TextureData& image = processed.scene.images[i];
        const std::uint32_t floor = floor_level(whole.images[i]);
        EXPECT_EQ(image.first_stored, floor);
        const auto last = static_cast<std::uint32_t>(image.levels.size());
        EXPECT_EQ(expected(image, floor, last), expected(whole.images[i], floor, last));
        EXPECT_EQ(bytes_from(*loader, {i, 0, floor}), expected(whole.images[i], 0, floor)) << i;
    }
}

TEST(LevelLoader, HasEveryLevelOfASceneWhateverTheCacheCanHold) {
    const Scene scene = scene_of(4, 128);
    const ScratchFolder scratch;
    // What four pictures take; none, all, or two of them stay.
    const std::uint64_t all = [&] {
        Cache cache{scratch.path(), k_plenty};
        static_cast<void>(process_cached(scene, {}, cache));
        return cache.bytes();
    }();
    for (const bool warm : {false, true}) {
        SCOPED_TRACE(warm);
        const auto cache = std::make_shared<Cache>(scratch.path(), k_plenty);
        if (!warm) fs::remove_all(scratch.path()), fs::create_directories(scratch.path());
        expect_all_levels(scene, cache, 4);
    }
    const ScratchFolder other;
    expect_all_levels(scene, std::make_shared<Cache>(other.path(), 0), 0);
    expect_all_levels(scene, std::make_shared<Cache>(other.path(), all / 2 + all / 8), 2);
}

}  // namespace
}  // namespace rambla::assets::test
