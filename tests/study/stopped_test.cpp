// Every study, stopped at one question and another: what it publishes has been measured.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "game/study/study.h"

namespace rambla::game::study {
namespace {

/// A study that runs until it has asked often enough whether to stop. The renderer stays the same, so that
/// its programs are made once.
class Stoppable {
public:
    explicit Stoppable(const Study& study) : study_{study} {}

    /// @param last  at this question, counted from 1, and after it the answer is yes
    StudyResult run_until(std::size_t last) {
        last_ = last;
        asked_ = 0;
        return run_study(study_, context_, "");
    }
    [[nodiscard]] std::size_t asked() const { return asked_; }

private:
    const Study& study_;
    std::size_t asked_ = 0;
    std::size_t last_ = 0;
    StudyContext context_{{.size_px = {32, 18}, .rounds = 1, .quick = true, .quiet = true}, [this] {
                              return ++asked_ >= last_;
                          }};
};

/// What follows from milliseconds is another in every run; the rest is the same to the bit.
bool is_of_times(const Metric& metric) {
    return metric.unit == "ms" || metric.name.starts_with("saved_share") || metric.name == "aa_share_pct";
}

bool is_time(const std::string& label) {
    return label.ends_with("ms");
}

template <class Items, class Name>
const typename Items::value_type* find_named(const Items& items, const std::string& name, Name name_of) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return name_of(item) == name; });
    return found == items.end() ? nullptr : &*found;
}

void expect_measured(const GradeResult& grade, const StudyResult& whole) {
    SCOPED_TRACE(grade.scene + ": " + grade.grade);
    ASSERT_LE(grade.ms.size(), 1u) << "of one round, or not timed";
    for (const double ms : grade.ms)
        EXPECT_TRUE(std::isfinite(ms));
    const auto same = std::find_if(whole.grades.begin(), whole.grades.end(), [&](const GradeResult& other) {
        return other.scene == grade.scene && other.grade == grade.grade;
    });
    ASSERT_NE(same, whole.grades.end()) << "it is not one of the whole study's";
    EXPECT_EQ(grade.bytes, same->bytes);
    for (const Metric& metric : grade.metrics) {
        const Metric* const expected =
            find_named(same->metrics, metric.name, [](const Metric& other) { return other.name; });
        ASSERT_NE(expected, nullptr) << metric.name;
        if (is_of_times(metric)) continue;
        EXPECT_EQ(metric.value, expected->value) << metric.name;
    }
}

void expect_measured(const Plot& plot, const StudyResult& whole) {
    SCOPED_TRACE(plot.title);
    const Plot* const expected =
        find_named(whole.plots, plot.title, [](const Plot& other) { return other.title; });
    ASSERT_NE(expected, nullptr);
    for (const Series& series : plot.series) {
        const Series* const line =
            find_named(expected->series, series.name, [](const Series& other) { return other.name; });
        ASSERT_NE(line, nullptr) << series.name;
        EXPECT_LE(series.points.size(), line->points.size()) << series.name;
        for (const glm::dvec2& point : series.points)
            EXPECT_TRUE(std::isfinite(point.y) && (point.y > 0.0 || !is_time(plot.y_label)))
                << series.name << " takes time";
    }
}

void expect_measured(const Table& table, const StudyResult& whole) {
    SCOPED_TRACE(table.title);
    const Table* const expected =
        find_named(whole.tables, table.title, [](const Table& other) { return other.title; });
    ASSERT_NE(expected, nullptr);
    EXPECT_EQ(table.head, expected->head);
    EXPECT_FALSE(table.rows.empty());
    EXPECT_LE(table.rows.size(), expected->rows.size());
}

class StoppedStudy : public testing::TestWithParam<const Study*> {};

TEST_P(StoppedStudy, PublishesNothingThatWasNotMeasured) {
    Stoppable study{*GetParam()};
    const StudyResult whole = study.run_until(std::numeric_limits<std::size_t>::max());
    const std::size_t questions = study.asked();  // the last of which is asked when the study has ended
    ASSERT_EQ(whole.incomplete, "");
    ASSERT_GT(questions, 4u) << "a study asks between its steps";
    ASSERT_FALSE(whole.grades.empty());
    for (const std::size_t last : {std::size_t{1}, std::size_t{2}, questions / 2, questions - 1}) {
        SCOPED_TRACE("stopped at question " + std::to_string(last) + " of " + std::to_string(questions));
        const StudyResult ended = study.run_until(last);
        EXPECT_THAT(ended.incomplete, testing::HasSubstr("interrupted"));
        if (last == 1) {
            EXPECT_TRUE(ended.grades.empty() && ended.tables.empty() && ended.pictures.empty());
        }
        for (const GradeResult& grade : ended.grades)
            expect_measured(grade, whole);
        for (const Plot& plot : ended.plots)
            expect_measured(plot, whole);
        for (const Table& table : ended.tables)
            expect_measured(table, whole);
    }
}

INSTANTIATE_TEST_SUITE_P(All, StoppedStudy, testing::ValuesIn(all_studies().begin(), all_studies().end()),
                         [](const auto& of) { return std::string{of.param->name}; });

}  // namespace
}  // namespace rambla::game::study
