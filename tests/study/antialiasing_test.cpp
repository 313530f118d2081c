// What the study of anti-aliasing measures of pictures that follow each other.
#include <gtest/gtest.h>

#include <atomic>

#include "game/study/antialiasing_motion.h"
#include "game/study/blocks_scene.h"
#include "game/study/in_turns.h"

namespace rambla::game::study {
namespace {

double value_of(const StudyResult& result, const std::string& grade, const std::string& name) {
    for (const GradeResult& found : result.grades) {
        if (found.grade != grade) continue;
        for (const Metric& metric : found.metrics)
            if (metric.name == name) return metric.value;
    }
    ADD_FAILURE() << "no " << name << " of " << grade;
    return 0.0;
}

TEST(AntiAliasingStudy, SlowMotionIsAFilmInWhichTemporalAntiAliasingHasAPast) {
    const std::atomic<bool> stop{false};
    StudyContext context{{.quick = true, .quiet = true}, stop};
    Stage stage = blocks_with_lights(16, 1);
    static_cast<void>(show(context, stage));
    StudyResult result;
    measure_slow_motion(context, stage, eye_of(stage, View::above, 0.5, {96, 54}), result);
    const double flicker = value_of(result, "none", "flicker_pct");
    EXPECT_GT(flicker, 0.5);
    // If each picture were the first of its history, all that is left of it would be its jitter: more flicker
    // than without. The mean of eight pictures and more takes most of it away.
    EXPECT_LT(value_of(result, "taa", "flicker_pct"), 0.5 * flicker);
}

}  // namespace
}  // namespace rambla::game::study
