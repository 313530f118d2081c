#include "game/scene_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

/// Sets variables, empty ones aside, and puts everything back as it was.
class Variables {
public:
    explicit Variables(const std::map<std::string, std::string>& values) {
        for (const auto& [name, value] : values) {
            const char* const before = std::getenv(name.c_str());
            before_[name] = before != nullptr ? std::optional<std::string>{before} : std::nullopt;
            set(name, value.empty() ? std::nullopt : std::optional{value});
        }
    }
    ~Variables() {
        for (const auto& [name, value] : before_)
            set(name, value);
    }
    Variables(const Variables&) = delete;
    Variables& operator=(const Variables&) = delete;

private:
    static void set(const std::string& name, const std::optional<std::string>& value) {
        if (value) {
            ::setenv(name.c_str(), value->c_str(), 1);
        } else {
            ::unsetenv(name.c_str());
        }
    }
    std::map<std::string, std::optional<std::string>> before_;
};

fs::path folder_with(const std::string& own, const std::string& caches, const std::string& home) {
    const Variables variables{{{"RAMBLA_CACHE_DIR", own}, {"XDG_CACHE_HOME", caches}, {"HOME", home}}};
    return cache_folder();
}

TEST(SceneCache, LiesWhereTheEnvironmentSays) {
    EXPECT_EQ(folder_with("/own", "/caches", "/home/me"), "/own");
    EXPECT_EQ(folder_with("relative", "/caches", "/home/me"), "relative");
    EXPECT_EQ(folder_with("", "/caches", "/home/me"), "/caches/rambla");
    EXPECT_EQ(folder_with("", "", "/home/me"), "/home/me/.cache/rambla");
    EXPECT_EQ(folder_with("", "caches", "/home/me"), "/home/me/.cache/rambla") << "relative ones are invalid";
    EXPECT_EQ(folder_with("", "", ""),
              fs::temp_directory_path() / ("rambla-cache-" + std::to_string(getuid())));
}

TEST(SceneCache, KeepsScenesForDevicesWithAndWithoutBlockCompressionApart) {
    const fs::path folder = fs::temp_directory_path() / ("rambla-scene-cache-" + std::to_string(getpid()));
    const Variables variables{{{"RAMBLA_CACHE_DIR", folder.string()}}};
    assets::Scene scene;
    scene.images = {{.name = "red", .width = 8, .height = 8, .texels = {}}};
    for (int i = 0; i < 8 * 8; ++i)
        for (const int byte : {200, 20, 10, 255})
            scene.images[0].texels.push_back(static_cast<std::byte>(byte));
    scene.textures = {{.name = "red", .image = 0, .colour_space = assets::ColourSpace::srgb, .sampler = {}}};
    scene.materials.resize(1);
    scene.materials[0].base_colour_texture.texture = 0;

    render::DeviceInfo plain;
    render::DeviceInfo blocks;
    blocks.block_compression = true;
    for (const std::uint32_t misses : {1u, 0u}) {
        const PreparedScene for_plain = prepare_scene(scene, plain, true);
        const PreparedScene for_blocks = prepare_scene(scene, blocks, true);
        EXPECT_EQ(for_plain.scene->images.at(0).format, assets::TexelFormat::rgba8);
        EXPECT_EQ(for_blocks.scene->images.at(0).format, assets::TexelFormat::bc1);
        EXPECT_EQ(for_plain.cache_misses, misses);
        EXPECT_EQ(for_blocks.cache_misses, misses);
        EXPECT_EQ(for_plain.cache_hits + for_plain.cache_misses, 1u);
    }
    fs::remove_all(folder);
}

}  // namespace
}  // namespace rambla::game
