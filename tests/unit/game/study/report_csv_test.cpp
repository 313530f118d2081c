#include "game/study/report/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <limits>

namespace rambla::game::study {
namespace {

constexpr const char* k_head = "study,scene,grade,metric,value,unit,ms,ms_ratio,bytes\n";

StudyResult named(const char* name) {
    StudyResult study;
    study.name = name;
    return study;
}

TEST(StudyCsv, HasARowForEachSceneGradeAndMetric) {
    StudyResult study = named("bloom");
    study.grades = {
        {"street", "wide", {2.0, 2.5, 3.0}, 1024, {{"flip_mean", 0.1, ""}, {"psnr_db", 31.5, "dB"}}},
        {"street", "off", {1.0, 1.25, 2.0}, 0}};
    EXPECT_EQ(to_csv(study), std::string{k_head}.append("bloom,street,wide,flip_mean,0.1,,2.5,2,1024\n"
                                                        "bloom,street,wide,psnr_db,31.5,dB,2.5,2,1024\n"
                                                        "bloom,street,off,,,,1.25,1,0\n"));
}

TEST(StudyCsv, QuotesWhatHoldsCommasQuotesAndLineEnds) {
    StudyResult study = named("s");
    study.grades = {{"blocks, 64 lights", "a\"b", {}, 0, {{"m\nn", 1, "%"}}}};
    EXPECT_EQ(to_csv(study),
              std::string{k_head}.append("s,\"blocks, 64 lights\",\"a\"\"b\",\"m\nn\",1,%,,,0\n"));
}

TEST(StudyCsv, WritesWhatIsNotFiniteAsWords) {
    const double infinite = std::numeric_limits<double>::infinity();
    StudyResult study = named("s");
    study.grades = {
        {"x",
         "g",
         {},
         0,
         {{"a", infinite, ""}, {"b", -infinite, ""}, {"c", std::numeric_limits<double>::quiet_NaN(), ""}}}};
    EXPECT_THAT(to_csv(study), testing::HasSubstr("a,inf,"));
    EXPECT_THAT(to_csv(study), testing::HasSubstr("b,-inf,"));
    EXPECT_THAT(to_csv(study), testing::HasSubstr("c,nan,"));
}

TEST(StudyCsv, DoesNotDependOnTheLocale) {
    StudyResult study = named("s");
    study.grades = {{"x", "g", {1234567.25}, 1e9, {{"a", 0.5, ""}}}};
    const std::string text = to_csv(study);
    // Where the system has none of these, the test says nothing.
    for (const char* const name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, name);
        EXPECT_EQ(to_csv(study), text);
    }
    std::setlocale(LC_ALL, "C");
    EXPECT_THAT(text, testing::HasSubstr("a,0.5,,1234567.25,1,"));
}

}  // namespace
}  // namespace rambla::game::study
