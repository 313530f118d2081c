#include "game/study/report/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "assets/error.h"

namespace rambla::game::study {
namespace {

using nlohmann::json;

assets::Image one_pixel() {
    return {.name = {}, .width = 1, .height = 1, .texels = std::vector(4, std::byte{255})};
}

StudyRun sample() {
    const double infinite = std::numeric_limits<double>::infinity();
    StudyResult study{"lighting", "Lighting paths", "Which?", "The one in doubles, \"exact\".",
                      "./run study lighting"};
    study.grades = {{"blocks, 64 lights",
                     "clustered:tile=64",
                     {0.1, 1.0 / 3.0, 12.5},
                     4096,
                     {{"flip_mean", 1e-9, ""}, {"psnr_db", infinite, "dB"}}},
                    {"blocks, 64 lights", "off", {}, 0, {{"lowest", -infinite, "%"}}}};
    study.plotted_metric = "flip_mean";
    study.plots = {{"Time against lights",
                    "lights",
                    "ms",
                    true,
                    false,
                    true,
                    {{"µ <b>", {{1, 2.5}, {infinite, -4}}, true}, {"none", {}, false}}}};
    study.tables = {{"Memory", {"path", "bytes"}, {{"clustered", "4096"}, {"off", "–"}}}};
    study.pictures = {{"Before and after", {{"off", {}}, {"on", one_pixel()}}}, {"None", {}}};
    study.incomplete = "no room for one of them";
    study.duration_s = 12.75;
    return {study, {{"machine", "a box"}, {"date", "2024-05-07"}}};
}

TEST(StudyJson, ReadsBackWhatItWrote) {
    const StudyRun run = sample();
    const std::string text = to_json(run);
    const StudyRun back = from_json(text, "x.json");
    EXPECT_EQ(back.facts, run.facts);
    const StudyResult& is = back.result;
    const StudyResult& was = run.result;
    EXPECT_EQ(is.name, was.name);
    EXPECT_EQ(is.title, was.title);
    EXPECT_EQ(is.question, was.question);
    EXPECT_EQ(is.reference, was.reference);
    EXPECT_EQ(is.command, was.command);
    EXPECT_EQ(is.plotted_metric, was.plotted_metric);
    EXPECT_EQ(is.incomplete, was.incomplete);
    EXPECT_EQ(is.duration_s, was.duration_s);
    ASSERT_EQ(is.grades.size(), 2u);
    EXPECT_EQ(is.grades[0].scene, was.grades[0].scene);
    EXPECT_EQ(is.grades[0].grade, was.grades[0].grade);
    EXPECT_EQ(is.grades[0].ms, was.grades[0].ms);
    EXPECT_EQ(is.grades[0].bytes, was.grades[0].bytes);
    EXPECT_EQ(is.grades[0].metrics[1].name, "psnr_db");
    EXPECT_EQ(is.grades[0].metrics[1].unit, "dB");
    EXPECT_EQ(is.grades[0].metrics[1].value, std::numeric_limits<double>::infinity());
    const Plot& plot = is.plots.at(0);
    EXPECT_EQ(plot.title, was.plots[0].title);
    EXPECT_EQ(plot.x_label, was.plots[0].x_label);
    EXPECT_EQ(plot.y_label, was.plots[0].y_label);
    EXPECT_TRUE(plot.x_log && !plot.y_log && plot.pareto);
    EXPECT_EQ(plot.series[0].name, was.plots[0].series[0].name);
    EXPECT_EQ(plot.series[0].points, was.plots[0].series[0].points);
    EXPECT_TRUE(plot.series[0].line && !plot.series[1].line);
    EXPECT_EQ(is.tables.at(0).title, was.tables[0].title);
    EXPECT_EQ(is.tables[0].head, was.tables[0].head);
    EXPECT_EQ(is.tables[0].rows, was.tables[0].rows);
    ASSERT_EQ(is.pictures.size(), 2u);
    EXPECT_EQ(is.pictures[0].title, was.pictures[0].title);
    ASSERT_EQ(is.pictures[0].pictures.size(), 2u);
    EXPECT_EQ(is.pictures[0].pictures[1].label, "on");
    EXPECT_TRUE(is.pictures[1].pictures.empty());
    // Whatever is compared above for one item holds for all. Texels are in files of their own.
    StudyRun with_texels = back;
    with_texels.result.pictures[0].pictures[1].image = one_pixel();
    EXPECT_EQ(to_json(with_texels), text);
}

TEST(StudyJson, NamesTheFilesOfPicturesThatCanBeShown) {
    const json pictures = json::parse(to_json(sample()))["pictures"][0]["pictures"];
    EXPECT_EQ(pictures[0], (json{{"label", "off"}, {"file", nullptr}}));
    EXPECT_EQ(pictures[1], (json{{"label", "on"}, {"file", "lighting-1-2.png"}}));
}

TEST(StudyJson, AFileFromBeforeThereWerePicturesIsRead) {
    json old = json::parse(to_json(sample()));
    old.erase("pictures");
    EXPECT_TRUE(from_json(old.dump(), "x.json").result.pictures.empty());
}

TEST(StudyJson, NotANumberReadsBack) {
    StudyRun run = sample();
    run.result.grades[0].ms[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(from_json(to_json(run), "x.json").result.grades[0].ms[1]));
}

TEST(StudyJson, StatesItsSchema) {
    EXPECT_EQ(json::parse(to_json(sample()))["schema"], "rambla.study/1");
}

TEST(StudyJson, BytesThatAreNoTextDoNotBreakIt) {
    StudyRun run = sample();
    run.result.grades[0].grade = "a\xFF";
    EXPECT_EQ(from_json(to_json(run), "x.json").result.grades[0].grade, "a\xEF\xBF\xBD");
}

std::string message_for(const std::string& text) {
    try {
        (void)from_json(text, "runs/lighting.json");
    } catch (const assets::Error& error) {
        return error.what();
    }
    return "no error";
}

/// What is said of the sample with the value at a JSON pointer replaced.
std::string message_for(const char* pointer, const json& value) {
    json damaged = json::parse(to_json(sample()));
    damaged[json::json_pointer{pointer}] = value;
    return message_for(damaged.dump());
}

TEST(StudyJson, RefusesOtherFilesAndSaysWhatIsWrong) {
    using testing::StartsWith;
    EXPECT_THAT(message_for("{"), StartsWith("runs/lighting.json: no JSON ("));
    EXPECT_THAT(message_for(""), StartsWith("runs/lighting.json: no JSON ("));
    EXPECT_THAT(message_for("{\"a\": 1e999}"), StartsWith("runs/lighting.json: no JSON ("));
    EXPECT_EQ(message_for("[]"), "runs/lighting.json: top: an array of 0, expected an object");
    EXPECT_EQ(message_for("{}"), "runs/lighting.json: schema: nothing, expected a value");
    EXPECT_EQ(message_for("/schema", "rambla.walk/1"),
              "runs/lighting.json: schema: \"rambla.walk/1\", expected \"rambla.study/1\"");
    EXPECT_EQ(message_for("/grades/0/metrics/1/value", "much"),
              "runs/lighting.json: grades[0].metrics[1].value: \"much\", expected a number");
    EXPECT_EQ(message_for("/grades/1/ms", nullptr),
              "runs/lighting.json: grades[1].ms: null, expected an array");
    EXPECT_EQ(message_for("/plots/0/series/0/points/1", json::array({1, 2, 3})),
              "runs/lighting.json: plots[0].series[0].points[1]: an array of 3, expected an array of 2");
    EXPECT_EQ(message_for("/plots/0/x_log", 1),
              "runs/lighting.json: plots[0].x_log: 1, expected true or false");
    EXPECT_EQ(message_for("/tables/0/rows/0", json::array({"one"})),
              "runs/lighting.json: tables[0].rows[0]: an array of 1, expected an array of 2");
    EXPECT_EQ(message_for("/pictures/0/pictures/1/label", 7),
              "runs/lighting.json: pictures[0].pictures[1].label: 7, expected a text");
    EXPECT_EQ(message_for("/pictures", "many"), "runs/lighting.json: pictures: \"many\", expected an array");
    EXPECT_EQ(message_for("/facts/0/value", 7), "runs/lighting.json: facts[0].value: 7, expected a text");
    EXPECT_THAT(message_for("/title", json::object()),
                testing::HasSubstr("title: an object of 0, expected a text"));
}

TEST(StudyJson, DeepNestingIsAnErrorLikeOthers) {
    constexpr std::size_t k_depth = 200'000;
    EXPECT_THAT(message_for(std::string(k_depth, '[') + std::string(k_depth, ']')),
                testing::HasSubstr("expected an object"));
}

TEST(StudyJson, NamesAFileThatCannotBeRead) {
    EXPECT_THROW((void)read_study("no/such/file.json"), assets::Error);
    EXPECT_THROW((void)read_study(std::filesystem::temp_directory_path()), assets::Error);
}

}  // namespace
}  // namespace rambla::game::study
