// What the study of anti-aliasing counts as the cost of a method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "game/study/antialiasing_grades.h"

namespace rambla::game::study {
namespace {

systems::PassTiming pass(const char* name, double ms, std::uint64_t bytes, std::uint64_t memory = 0) {
    return {.name = name, .gpu_ms = ms, .bytes_written = bytes, .memory_bytes = memory};
}

PictureCost one_round(std::vector<systems::PassTiming> passes, double frame_ms) {
    systems::Feedback feedback;
    feedback.passes = std::move(passes);
    feedback.gpu_frame_ms = frame_ms;
    return {.rounds = {feedback}};
}

double value_of(const std::vector<Metric>& metrics, const std::string& name) {
    for (const Metric& metric : metrics)
        if (metric.name == name) return metric.value;
    ADD_FAILURE() << "no metric " << name;
    return 0.0;
}

const PictureCost k_plain = one_round({pass("gbuffer", 30.0, 100), pass("tonemap", 4.0, 10)}, 35.0);

TEST(AntialiasingCost, OfNoneIsZero) {
    EXPECT_EQ(antialiasing_ms(k_plain, k_plain), std::vector<double>{0.0});
}

TEST(AntialiasingCost, IsThatOfPassesThatAreNotThereWithoutIt) {
    const PictureCost cost = one_round({pass("gbuffer", 33.0, 100), pass("tonemap", 4.0, 10),
                                        pass("find edges", 0.5, 1), pass("fxaa", 1.5, 10)},
                                       41.0);
    EXPECT_EQ(antialiasing_ms(cost, k_plain), std::vector<double>{2.0}) << "not what a pass varies by";
}

TEST(AntialiasingCost, CountsWhatAPassTakesLongerThatWritesMore) {
    const PictureCost cost =
        one_round({pass("gbuffer", 33.0, 120), pass("tonemap", 4.5, 10), pass("taa", 5.0, 20)}, 44.0);
    EXPECT_EQ(antialiasing_ms(cost, k_plain), std::vector<double>{8.0});
    const std::vector<Metric> metrics = cost_metrics(cost, k_plain);
    EXPECT_DOUBLE_EQ(value_of(metrics, "aa_share_pct"), 100.0 * 8.0 / 44.0);
    EXPECT_DOUBLE_EQ(value_of(metrics, "frame_more_ms"), 9.0);
}

TEST(AntialiasingCost, NamesTheTransientMemoryThatAPictureNeedsMore) {
    constexpr std::uint64_t k_mib = 1024 * 1024;
    const PictureCost plain = one_round({pass("gbuffer", 1.0, 1, 8 * k_mib)}, 1.0);
    const PictureCost cost =
        one_round({pass("gbuffer", 1.0, 1, 8 * k_mib), pass("fxaa", 1.0, 1, 10 * k_mib)}, 2.0);
    EXPECT_DOUBLE_EQ(value_of(cost_metrics(cost, plain), "transient_more_mib"), 2.0);
}

TEST(AntialiasingGrades, AreEveryMethodOnceOrMoreAndBeginWithNone) {
    const std::atomic<bool> stop{false};
    const StudyContext context{{}, stop};
    const std::vector<PictureGrade> grades = antialiasing_grades(context, Past::settled);
    std::set<render::AntiAliasing> methods;
    std::set<std::string> names;
    for (const PictureGrade& grade : grades) {
        const render::AntiAliasing method = grade.settings.anti_aliasing.method;
        methods.insert(method);
        names.insert(grade.name);
        EXPECT_EQ(grade.frames_before > 0, method == render::AntiAliasing::taa) << grade.name;
        EXPECT_EQ(grade.settings.exposure.mode, render::ExposureMode::fixed);
        EXPECT_EQ(grade.settings.bloom.method, render::BloomMethod::off);
    }
    EXPECT_EQ(methods.size(), render::k_anti_aliasing_methods.size());
    EXPECT_EQ(names.size(), grades.size());
    EXPECT_EQ(grades.front().settings.anti_aliasing.method, render::AntiAliasing::none);
}

}  // namespace
}  // namespace rambla::game::study
