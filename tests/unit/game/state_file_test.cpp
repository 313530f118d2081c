#include "game/state_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "assets/error.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

struct StateFile : testing::Test {
    fs::path folder =
        fs::temp_directory_path() / ("rambla-" + std::to_string(getpid()) +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::path file = folder / "a.state";
    Stage stage;
    Options options;

    void SetUp() override {
        fs::create_directories(folder);
        options.scene = "city:blocks=2x2";
        options.seed = 7;
        stage.world = std::make_unique<ecs::World>();
        stage.world->create(systems::Cell{{1, 2, 3}});
    }
    void TearDown() override { fs::remove_all(folder); }

    static std::string text_of(const fs::path& path) {
        std::ifstream in{path, std::ios::binary};
        return {std::istreambuf_iterator<char>{in}, {}};
    }
    void write(const std::string& bytes) const { std::ofstream{file, std::ios::binary} << bytes; }
    std::string saved() {
        save_state_file(file, stage, options);
        return text_of(file);
    }

    /// What loading complains about; the stage must keep its world.
    std::string complaint() {
        const ecs::World* const before = stage.world.get();
        try {
            load_state_file(file, stage, options);
        } catch (const assets::Error& error) {
            EXPECT_EQ(stage.world.get(), before);
            return error.what();
        }
        ADD_FAILURE() << "it was loaded";
        return {};
    }
    std::string saving_complaint(const fs::path& path) {
        try {
            save_state_file(path, stage, options);
        } catch (const assets::Error& error) {
            return error.what();
        }
        ADD_FAILURE() << "it was saved";
        return {};
    }
};

TEST_F(StateFile, IsLoadedAsItWasSaved) {
    (void)saved();
    const ecs::World* const before = stage.world.get();
    load_state_file(file, stage, options);
    EXPECT_NE(stage.world.get(), before);
    EXPECT_EQ(stage.world->entity_count(), 1u);
}

TEST_F(StateFile, ThatIsNotThereOrAFolderIsNamed) {
    EXPECT_EQ(complaint(), file.string() + ": a file that cannot be read, expected a saved state");
    fs::create_directory(file);
    EXPECT_EQ(complaint(), file.string() + ": a folder, expected a saved state");
}

TEST_F(StateFile, ThatIsEmptyOrCutSaysHowLongItShouldBe) {
    const std::string bytes = saved();
    write("");
    EXPECT_EQ(complaint(), file.string() + ": byte 0: 0 bytes, expected at least 48");
    write(bytes.substr(0, 20));
    EXPECT_EQ(complaint(), file.string() + ": byte 20: 20 bytes, expected at least 48");
    write(bytes.substr(0, bytes.size() - 1));
    EXPECT_THAT(complaint(), AllOf(StartsWith(file.string() + ": byte "),
                                   HasSubstr(std::to_string(bytes.size() - 1) + " bytes"),
                                   EndsWith("expected " + std::to_string(bytes.size()))));
    write(bytes + "x");
    EXPECT_THAT(complaint(), AllOf(HasSubstr(std::to_string(bytes.size() + 1) + " bytes"),
                                   EndsWith("expected " + std::to_string(bytes.size()))));
}

TEST_F(StateFile, OfAnotherKindIsToldByItsFirstBytes) {
    write(std::string(100, 'x'));
    EXPECT_THAT(complaint(), AllOf(StartsWith(file.string() + ": byte 0: "), HasSubstr("expected")));
}

TEST_F(StateFile, WithOneBitChangedIsRefusedWhereverItIs) {
    const std::string bytes = saved();
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        write(damaged);
        ASSERT_THAT(complaint(), AllOf(StartsWith(file.string() + ": byte "), HasSubstr(", expected ")))
            << "byte " << at;
    }
}

TEST_F(StateFile, OfAnotherSceneSeedOrOriginSaysBoth) {
    (void)saved();
    options.seed = 8;
    EXPECT_THAT(complaint(), AllOf(HasSubstr(": a state of city:blocks=2x2, seed 7, "),
                                   HasSubstr("expected one of city:blocks=2x2, seed 8, ")));
    options.seed = 7;
    options.scene = "forest";
    EXPECT_THAT(complaint(), AllOf(HasSubstr("city:blocks=2x2"), HasSubstr("expected one of forest")));
    options.scene = "city:blocks=2x2";
    stage.origin.cell = {0, 0, 5};
    EXPECT_THAT(complaint(), AllOf(HasSubstr("in cell (0 0 0)"), HasSubstr("in cell (0 0 5)")));
}

TEST_F(StateFile, ThatCannotBeWrittenIsNamedAndLeavesNothingBehind) {
    const std::string reason = ": a place that cannot be written to";
    const fs::path nowhere = folder / "missing" / "a.state";
    EXPECT_EQ(saving_complaint(nowhere), nowhere.string() + reason);
    fs::create_directory(file);
    EXPECT_EQ(saving_complaint(file), file.string() + reason);
    EXPECT_EQ(std::distance(fs::directory_iterator{folder}, {}), 1) << "the folder alone";
}

}  // namespace
}  // namespace rambla::game
