#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> k_names{"gbuffer", "lighting", "detail", "luminance", "tonemap", "passes", "compression"};

struct StudyProgram : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();

    nlohmann::json study(const std::string& name) {
        return nlohmann::json::parse(file_text(folder / "report" / (name + ".json")));
    }
};

TEST_F(StudyProgram, RunsAllStudiesQuicklyAndWritesACompleteReport) {
    const Ended ended =
        rambla({"study", "all", "--quick", "--size", "64x36", "-o", "report", "--json", "-"}, folder);
    ASSERT_EQ(ended.exit_code, 0) << ended.err << ended.out;
    const nlohmann::json summary = nlohmann::json::parse(ended.out);
    EXPECT_EQ(summary["schema"], "rambla.studies/1");
    ASSERT_EQ(summary["studies"].size(), k_names.size());
    const std::string page = file_text(folder / "report" / "index.html");
    EXPECT_THAT(page, HasSubstr("</html>"));
    EXPECT_THAT(page, Not(HasSubstr("<script"))) << "it opens from disk and needs none";
    for (const std::string& name : k_names) {
        const nlohmann::json found = study(name);
        EXPECT_EQ(found["schema"], "rambla.study/1");
        EXPECT_THAT(page, HasSubstr("rambla study " + name)) << "how to run it again";
        const std::string csv = file_text(folder / "report" / (name + ".csv"));
        EXPECT_THAT(csv, testing::StartsWith("study,scene,grade,metric,value,unit,ms,ms_ratio,bytes"));
        EXPECT_GT(line_count(csv), 4u) << name;
        EXPECT_THAT(file_text(folder / "report" / (name + ".svg")), HasSubstr("</svg>"));
    }
}

TEST_F(StudyProgram, NamesWhatIsNoStudyAndWhatIs) {
    const Ended ended = rambla({"study", "lighting", "shadow"}, folder);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("no study 'shadow'"));
    for (const std::string& name : k_names)
        EXPECT_THAT(ended.err, HasSubstr(name));
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(StudyProgram, SaysAtOnceThatAFolderCannotBeWrittenTo) {
    write_file(folder / "taken", "a file");
    const Ended ended = rambla({"study", "all", "-o", "taken/report"}, folder);  // would take minutes
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("taken"));
    EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
}

TEST_F(StudyProgram, RefusesAnEarlierRunThatCannotBeRead) {
    write_file(folder / "old.json", R"({"schema": "rambla.study/1", "result": 3})");
    const Ended ended = rambla({"study", "detail", "--against", "old.json"}, folder);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("old.json"));
}

TEST_F(StudyProgram, AnInterruptKeepsWhatWasMeasuredAndMarksIt) {
    Process process{{RAMBLA_PROGRAM, "study", "detail", "passes", "--quick", "--rounds", "3", "--size",
                     "64x36", "-o", "report"},
                    {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}},
                    folder};
    ASSERT_TRUE(eventually([&] { return fs::exists(folder / "report" / "detail.json"); }));
    process.terminate();
    const Ended ended = process.wait(k_patience);
    EXPECT_EQ(ended.exit_code, 1) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("Interrupted"));
    EXPECT_THAT(ended.out, HasSubstr("INCOMPLETE"));
    EXPECT_THAT(file_text(folder / "report" / "index.html"), HasSubstr("interrupted"));
}

}  // namespace
}  // namespace rambla::system_test
