#include "game/study/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "unit/game/study/svg_reader.h"

namespace rambla::game::study {
namespace {

using testing::HasSubstr;
using testing::Not;

const RunFacts k_facts{{"machine", "a box"}, {"date", "2024-05-07"}};

StudyRun sample(std::string name = "shadows") {
    StudyResult study;
    study.name = std::move(name);
    study.title = "Shadows & light";
    study.question = "How near is <simple>?";
    study.reference = "Rays.";
    study.command = "./run study shadows --size \"1280x720\"";
    study.plotted_metric = "wrong_pixels_pct";
    study.duration_s = 250.0;
    study.grades = {{"city", "simple", {2, 2, 2}, 2048, {{"wrong_pixels_pct", 5, "%"}}},
                    {"city", "queried", {3, 3, 3}, 1 << 20, {{"wrong_pixels_pct", 0.25, "%"}}},
                    {"city", "worse", {4, 4, 4}, 0, {{"wrong_pixels_pct", 0.5, "%"}}}};
    return {study, k_facts};
}

/// The body, since a style sheet has a '>' that stands for itself.
std::string body(const std::string& page) {
    EXPECT_THAT(page, HasSubstr("<body>"));
    return page.substr(page.find("<body>"), page.find("</html>") - page.find("<body>"));
}

/// Without the elements that HTML leaves open.
std::string closed(std::string html) {
    for (const char* const empty : {"<br>", "<wbr>"})
        for (std::size_t at = html.find(empty); at != std::string::npos; at = html.find(empty, at))
            html.erase(at, std::string_view{empty}.size());
    return html;
}

TEST(StudyPage, IsWellFormedAndEscaped) {
    StudyRun run = sample();
    run.result.tables = {{"T <1>", {"a", "<b>"}, {{"x&y", "1 < 2"}}}};
    run.result.incomplete = "\"<none>\"";
    run.result.plots = {{"<plot>", "x", "y", false, false, true, {{"<s>", {{1, 2}}}}}};
    run.facts.emplace_back("<fact>", "</dl>");
    const std::string html = body(to_page({run}, run.facts));
    EXPECT_TRUE(is_well_formed(closed(html)));
    for (const char* const text :
         {"&lt;simple&gt;", "Shadows &amp; light", "T &lt;1&gt;", "x&amp;y", "1 &lt; 2",
          "&quot;&lt;none&gt;&quot;", "&lt;plot&gt;", "&lt;fact&gt;", "&lt;/dl&gt;"})
        EXPECT_THAT(html, HasSubstr(text));
}

TEST(StudyPage, ShowsEachGradeWithCostAndError) {
    const std::string html = body(to_page({sample()}, k_facts));
    EXPECT_THAT(html, HasSubstr(">simple<"));
    EXPECT_THAT(html,
                HasSubstr("<td>1.50</td><td class=\"muted\">1.50–1.50</td><td>1.0 MiB</td><td>0.250</td>"));
    EXPECT_THAT(html, HasSubstr("wrong_<wbr>pixels_<wbr>pct<br>%"));
    EXPECT_THAT(html, HasSubstr("3 rounds"));
    EXPECT_THAT(html, HasSubstr("It took 4 min 10 s. Run it again: <code>./run study shadows --size "
                                "&quot;1280x720&quot;</code>"));
    EXPECT_EQ(matches(html, "class=\"tag\">cheapest<").size(), 1u);
    EXPECT_EQ(matches(html, "<tr class=\"front\">").size(), 2u);
    EXPECT_EQ(matches(html, "<svg class=\"plot\"").size(), 1u);
}

TEST(StudyPage, MarksTheCheapestGradeInItsRow) {
    StudyRun run = sample();
    run.result.grades[2].ms = {1, 1, 1};
    const std::string html = body(to_page({run}, k_facts));
    const std::size_t row = html.find("<span class=\"whole\">worse");
    ASSERT_NE(row, std::string::npos);
    EXPECT_LT(html.find("<span class=\"whole\">queried"), row);
    EXPECT_LT(row, html.find("class=\"tag\">cheapest<"));
    EXPECT_EQ(matches(html, "class=\"tag\">cheapest<").size(), 1u);
}

TEST(StudyPage, GradesWithoutTimesOrMetricsShowDashes) {
    StudyRun run = sample();
    run.result.grades[0].ms.clear();
    run.result.grades[1].metrics.clear();
    run.result.grades[2].bytes = std::numeric_limits<double>::quiet_NaN();
    const std::string html = body(to_page({run}, k_facts));
    EXPECT_THAT(html, HasSubstr("<td>–</td><td class=\"muted\">–</td><td>–</td><td "
                                "class=\"muted\">–</td><td>2.0 KiB</td><td>5</td>"));
    EXPECT_THAT(html, HasSubstr("<td>1.0 MiB</td><td>–</td>"));
    EXPECT_THAT(html, HasSubstr("<td>–</td><td>0.500</td>"));
}

TEST(StudyPage, BytesAreShownInUnitsOfTheirSize) {
    StudyRun run = sample();
    run.result.grades[0].metrics.push_back({"saved_bytes", -3.0 * 1024 * 1024, "B"});
    EXPECT_THAT(to_page({run}, k_facts), HasSubstr("<td>−3.0 MiB</td>"));
}

TEST(StudyPage, ManyTablesAreFoldedButForTheFirst) {
    StudyRun run = sample();
    const auto add = [&](int count) {
        for (int i = 0; i < count; ++i)
            run.result.tables.push_back(
                {std::string{"T"}.append(std::to_string(run.result.tables.size())), {"a"}, {{"x"}}});
    };
    add(3);
    EXPECT_THAT(to_page({run}, k_facts), Not(HasSubstr("<details>")));
    add(2);
    const std::string page = body(to_page({run}, k_facts));
    EXPECT_THAT(page, HasSubstr("2 further tables"));
    EXPECT_LT(page.find("T2"), page.find("<details>"));
    EXPECT_LT(page.find("<details>"), page.find("T3"));
    EXPECT_LT(page.find("T4"), page.find("</details>"));
}

TEST(StudyPage, SaysThatAStudyIsIncompleteOnlyWhereItIs) {
    StudyRun run = sample();
    EXPECT_THAT(to_page({run}, k_facts), Not(HasSubstr("incomplete.")));
    run.result.incomplete = "One scene had no room.";
    EXPECT_THAT(to_page({run}, k_facts),
                HasSubstr("<b>This study is incomplete.</b> One scene had no room."));
}

TEST(StudyPage, SaysWhatDiffersInAStudyOfAnotherRun) {
    StudyRun earlier = sample("lighting");
    earlier.facts[1].second = "2023-01-01";
    const std::string html = to_page({sample(), earlier}, k_facts);
    EXPECT_EQ(matches(html, "From another run: date 2023-01-01\\.").size(), 1u);
    EXPECT_THAT(html, HasSubstr("<a href=\"#lighting\">"));
    EXPECT_THAT(html, HasSubstr("<a href=\"#shadows\">"));
}

TEST(StudyPage, APlotWithoutAPointIsASentence) {
    StudyRun run = sample();
    run.result.plots = {{"Empty", "x", "y", false, false, false, {}}};
    const std::string html = to_page({run}, k_facts);
    EXPECT_THAT(html, HasSubstr("“Empty” is not drawn"));
    EXPECT_EQ(matches(html, "<svg class=\"plot\"").size(), 1u);
}

TEST(StudyPage, NeedsNothingFromElsewhereAndNoScripts) {
    const std::string html = to_page({sample()}, k_facts);
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr("src="))) << "but for pictures, which are inside";
    EXPECT_THAT(html, Not(HasSubstr("@import")));
    EXPECT_THAT(html, Not(HasSubstr("url(")));
}

TEST(StudyPage, WithoutStudiesItSaysSo) {
    EXPECT_THAT(to_page({}, {}), HasSubstr("No study has been run yet."));
}

}  // namespace
}  // namespace rambla::game::study
