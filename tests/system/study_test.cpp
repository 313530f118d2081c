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

const std::vector<std::string> k_names{"gbuffer", "lighting",     "detail", "luminance",  "tonemap",
                                       "bloom",   "antialiasing", "passes", "compression"};

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

/// Making textures as they are takes a fraction of making blocks well, whatever else the machine does: those
/// two grades alone are compared with what an earlier run might have measured.
struct StudyAgainst : StudyProgram {
    Ended against(const std::vector<double>& off_ms, const std::vector<double>& good_ms, const char* rounds) {
        const auto grade = [](const char* name, const std::vector<double>& ms) {
            return nlohmann::json{{"scene", "making 2 textures of the street"},
                                  {"grade", name},
                                  {"ms", ms},
                                  {"bytes", 0},
                                  {"metrics", nlohmann::json::array()}};
        };
        const nlohmann::json earlier{
            {"schema", "rambla.study/1"},
            {"name", "compression"},
            {"title", ""},
            {"question", ""},
            {"reference", ""},
            {"command", ""},
            {"incomplete", ""},
            {"duration_s", 1},
            {"facts", nlohmann::json::array()},
            {"plotted_metric", ""},
            {"grades", {grade("compression=off", off_ms), grade("compression=good", good_ms)}},
            {"plots", nlohmann::json::array()},
            {"tables", nlohmann::json::array()}};
        write_file(folder / "old.json", earlier.dump());
        return rambla({"study", "compression", "--quick", "--rounds", rounds, "--size", "64x36", "-o",
                       "report", "--against", "old.json"},
                      folder);
    }
};

TEST_F(StudyAgainst, EndsWellWhereTheOrderIsTheSame) {
    const Ended ended = against({1, 1, 1}, {9, 9, 9}, "3");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("compression: 1 pairs of grades differ by more than their spreads in "
                                     "both runs, 0 changed places"));
}

TEST_F(StudyAgainst, SaysWhichGradesChangedPlaces) {
    const Ended ended = against({9, 9, 9}, {1, 1, 1}, "3");
    EXPECT_EQ(ended.exit_code, 1) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("CHANGED PLACES"));
}

TEST_F(StudyAgainst, SaysThatNothingWasComparedAndWhy) {
    const Ended few = against({1, 1, 1}, {9, 9, 9}, "2");
    EXPECT_EQ(few.exit_code, 1) << few.err;
    EXPECT_THAT(few.out, HasSubstr("NOTHING COMPARED  one of the runs has fewer than three rounds"));
    const Ended alike = against({1, 5, 9}, {1, 5, 9}, "3");
    EXPECT_EQ(alike.exit_code, 1) << alike.err;
    EXPECT_THAT(alike.out, HasSubstr("NOTHING COMPARED  no two grades differ by more than their spreads"));
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
