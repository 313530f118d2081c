#include "game/study/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "assets/error.h"
#include "assets/export/image.h"

namespace rambla::game::study {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

/// A folder of its own for each test.
class StudyReport : public testing::Test {
protected:
    StudyReport() {
        const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
        folder = fs::temp_directory_path() /
                 (std::string{"rambla-report-"} + test->name() + std::to_string(getpid()));
    }
    ~StudyReport() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }

    [[nodiscard]] std::string text(const char* name) const {
        std::ifstream in{folder / name, std::ios::binary};
        return {std::istreambuf_iterator<char>{in}, {}};
    }

    fs::path folder;
};

StudyResult study(std::string name, std::string title = "Title") {
    StudyResult result;
    result.name = std::move(name);
    result.title = std::move(title);
    result.plotted_metric = "flip_mean";
    result.grades = {{"scene", "grade", {1, 2}, 0, {{"flip_mean", 0.5, ""}}}};
    return result;
}

void write(const fs::path& folder, const StudyResult& result, const RunFacts& facts = {{"date", "today"}},
           const std::vector<std::string>& order = {}) {
    write_report(folder, std::vector{result}, facts, order);
}

TEST_F(StudyReport, WritesAllFilesOfAStudyAndThePage) {
    write(folder, study("bloom"));
    EXPECT_THAT(text("bloom.csv"), HasSubstr("bloom,scene,grade,flip_mean,0.5,"));
    EXPECT_THAT(text("bloom.svg"), HasSubstr("<svg"));
    EXPECT_EQ(read_study(folder / "bloom.json").facts, (RunFacts{{"date", "today"}}));
    EXPECT_THAT(text("index.html"), HasSubstr("id=\"bloom\""));
    EXPECT_EQ(std::distance(fs::directory_iterator{folder}, {}), 4);  // nothing unfinished beside them
}

TEST_F(StudyReport, ShowsStudiesOfEarlierRunsInTheOrderGiven) {
    write(folder, study("bloom"), {{"date", "yesterday"}});
    write(folder, study("aliasing"), {{"date", "yesterday"}});
    write(folder, study("shadows"), {{"date", "today"}}, {"shadows", "bloom"});
    const std::string page = text("index.html");
    const std::size_t shadows = page.find("id=\"shadows\"");
    const std::size_t bloom = page.find("id=\"bloom\"");
    const std::size_t aliasing = page.find("id=\"aliasing\"");
    EXPECT_LT(shadows, bloom);
    EXPECT_LT(bloom, aliasing);
    ASSERT_NE(aliasing, std::string::npos);
    EXPECT_THAT(page, HasSubstr("From another run: date yesterday."));
}

TEST_F(StudyReport, ANewRunOfAStudyReplacesTheEarlierOne) {
    write(folder, study("bloom", "Before"));
    write(folder, study("bloom", "After"));
    EXPECT_THAT(text("index.html"), HasSubstr("After"));
    EXPECT_THAT(text("index.html"), Not(HasSubstr("Before")));
    const std::string page = text("index.html");
    EXPECT_EQ(page.find("id=\"bloom\""), page.rfind("id=\"bloom\""));  // once
}

TEST_F(StudyReport, APlotThatIsNoMoreIsRemoved) {
    write(folder, study("bloom"));
    StudyResult without = study("bloom");
    without.plotted_metric.clear();
    write(folder, without);
    EXPECT_FALSE(fs::exists(folder / "bloom.svg"));
    EXPECT_THAT(text("index.html"), Not(HasSubstr("bloom.svg")));
}

TEST_F(StudyReport, FilesThatAreNoStudiesAreLeftOut) {
    write(folder, study("bloom"));
    assets::write_text(folder / "broken.json", "{");
    assets::write_text(folder / "walk.json", "{\"schema\": \"rambla.walk/1\"}");
    fs::create_directory(folder / "folder.json");
    // A copy under another name would be on the page twice.
    fs::copy_file(folder / "bloom.json", folder / "copy.json");
    write(folder, study("shadows"));
    EXPECT_THAT(text("index.html"), HasSubstr("id=\"bloom\""));
    EXPECT_THAT(text("index.html"), Not(HasSubstr("id=\"copy\"")));
}

TEST_F(StudyReport, NamesThatAreNoFileNamesAreRefused) {
    EXPECT_THROW(write(folder, study("../bloom")), assets::Error);
    EXPECT_THROW(write(folder, study("")), assets::Error);
    EXPECT_THROW(write_report(folder, std::vector{study("a"), study("a")}, {}), assets::Error);
    EXPECT_FALSE(fs::exists(folder));
}

TEST_F(StudyReport, AFolderThatCannotBeWrittenToIsAnError) {
    assets::write_text(folder, "a file where the folder should be");
    EXPECT_THROW(write(folder, study("bloom")), assets::Error);
}

}  // namespace
}  // namespace rambla::game::study
