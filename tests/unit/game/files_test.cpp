#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "assets/error.h"
#include "game/controls.h"
#include "game/picture_writer.h"
#include "game/shader_folder.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Folder : testing::Test {
    fs::path path =
        fs::temp_directory_path() / ("rambla-" + std::to_string(getpid()) +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    void SetUp() override { fs::create_directories(path / "shared"); }
    void TearDown() override { fs::remove_all(path); }
    void write(const char* name, const char* text) { std::ofstream{path / name} << text; }
};

TEST_F(Folder, ShadersAreReadFromIt) {
    write("shared/a.h", "// a\n");
    const render::ShaderSource source = ShaderFolder{path}.source();
    EXPECT_EQ(source("shared/a.h"), "// a\n");
    EXPECT_THROW(static_cast<void>(source("b.glsl")), std::out_of_range);
}

TEST_F(Folder, ASavedAddedOrRemovedShaderIsNoticedOnce) {
    write("a.glsl", "// a\n");
    ShaderFolder folder{path};
    Clock::time_point now = Clock::now();
    const auto changed = [&] {
        return folder.changed(now += std::chrono::seconds{2});
    };
    EXPECT_FALSE(changed());
    fs::last_write_time(path / "a.glsl", fs::last_write_time(path / "a.glsl") + std::chrono::seconds{5});
    EXPECT_TRUE(changed());
    EXPECT_FALSE(changed());
    write("shared/b.h", "// b\n");
    EXPECT_TRUE(changed());
    fs::remove(path / "shared/b.h");
    EXPECT_TRUE(changed());
    EXPECT_FALSE(changed());
}

TEST_F(Folder, LooksOnceASecondAtMost) {
    ShaderFolder folder{path};
    const Clock::time_point now = Clock::now();
    EXPECT_FALSE(folder.changed(now));
    write("a.glsl", "// a\n");
    EXPECT_FALSE(folder.changed(now + std::chrono::milliseconds{500}));
    EXPECT_TRUE(folder.changed(now + std::chrono::milliseconds{1500}));
}

TEST(ShaderFolder, WithoutAFolderTheEmbeddedTextsServe) {
    const ShaderFolder folder{"/nowhere/at/all"};
    EXPECT_FALSE(folder.exists());
    EXPECT_FALSE(static_cast<bool>(folder.source()));
}

assets::Image grey_picture() {
    return {.name = "grey",
            .width = 64,
            .height = 48,
            .format = assets::PixelFormat::rgba8,
            .texels = std::vector<std::byte>(64 * 48 * 4, std::byte{128})};
}

TEST_F(Folder, EveryPictureIsWrittenOnce) {
    PictureWriter writer;
    for (int i = 0; i < 40; ++i)
        writer.write(path / ("picture" + std::to_string(i) + ".png"), grey_picture());
    writer.finish();
    for (int i = 0; i < 40; ++i)
        EXPECT_GT(fs::file_size(path / ("picture" + std::to_string(i) + ".png")), 0u);
}

TEST_F(Folder, AnUnwritablePictureIsAnErrorThatNamesIt) {
    write("file", "not a folder");
    PictureWriter writer;
    writer.write(path / "file" / "a.png", grey_picture());
    try {
        writer.finish();
        FAIL() << "no error";
    } catch (const assets::Error& error) {
        EXPECT_NE(std::string{error.what()}.find("file/a.png"), std::string::npos);
    }
}

TEST(Controls, StandInTheOrderOfTheActionsAndShareNoKey) {
    std::set<int> keys;
    for (std::size_t i = 0; i < k_actions; ++i) {
        const Control& control = controls()[i];
        EXPECT_EQ(static_cast<std::size_t>(control.action), i);
        EXPECT_FALSE(control.help.empty());
        for (const int key : control.keys) {
            EXPECT_TRUE(key == 0 || keys.insert(key).second) << control.help;
        }
    }
}

}  // namespace
}  // namespace rambla::game
