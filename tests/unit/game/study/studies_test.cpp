#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>

#include "ecs/query.h"
#include "game/study/blocks_scene.h"
#include "game/study/grades.h"
#include "game/study/pass_ms.h"
#include "game/study/picture_error.h"
#include "game/study/study.h"
#include "systems/components.h"

namespace rambla::game::study {
namespace {

using testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<const Study*>& studies) {
    std::vector<std::string> names;
    for (const Study* study : studies)
        names.emplace_back(study->name);
    return names;
}

TEST(Studies, AreFoundByNameOnceAndInTheOrderOfTheReport) {
    const std::vector<std::string> asked{"passes", "lighting", "passes"};
    EXPECT_EQ(names_of(find_studies(asked)), (std::vector<std::string>{"lighting", "passes"}));
    const std::vector<std::string> all{"detail", "all"};
    EXPECT_EQ(find_studies(all).size(), all_studies().size());
    const std::vector<std::string> wrong{"lighting", "lightning"};
    try {
        static_cast<void>(find_studies(wrong));
        FAIL() << "there is none of that name";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("'lightning'"));
        EXPECT_THAT(error.what(), HasSubstr("lighting, detail"));
    }
}

TEST(Studies, KeepWhatTheyFoundBeforeTheyFailed) {
    const Study failing{.name = "failing", .summary = "", .run = [](StudyContext&, StudyResult& result) {
                            result.title = "Failing";
                            result.grades.push_back({.scene = "s", .grade = "g", .ms = {1.0}});
                            throw std::runtime_error{"no light"};
                        }};
    const std::atomic<bool> stop{false};
    StudyContext context{{}, stop};
    const StudyResult result = run_study(failing, context, "rambla study failing");
    EXPECT_EQ(result.name, "failing");
    EXPECT_EQ(result.command, "rambla study failing");
    ASSERT_EQ(result.grades.size(), 1u);
    EXPECT_THAT(result.incomplete, HasSubstr("no light"));
}

TEST(Studies, AreMarkedWhenTheUserEndsThem) {
    const Study long_one{
        .name = "long", .summary = "", .run = [](StudyContext& context, StudyResult& result) {
            while (!context.stopped() && result.grades.size() < 3)
                result.grades.push_back({.scene = "s", .grade = "g"});
        }};
    std::atomic<bool> stop{false};
    StudyContext context{{}, stop};
    EXPECT_EQ(run_study(long_one, context, "").incomplete, "");
    stop = true;
    const StudyResult ended = run_study(long_one, context, "");
    EXPECT_THAT(ended.incomplete, HasSubstr("interrupted"));
    EXPECT_TRUE(ended.grades.empty());
}

TEST(Studies, AreSmallWhenQuickUnlessToldOtherwise) {
    const std::atomic<bool> stop{false};
    const auto context = [&](StudyOptions options) {
        return StudyContext{options, stop};
    };
    const std::vector<glm::uvec2> full{{640, 360}, {1280, 720}};
    EXPECT_EQ(context({}).rounds(9), 9u);
    EXPECT_EQ(context({}).sizes(full), full);
    EXPECT_LT(context({.quick = true}).rounds(9), 9u);
    EXPECT_EQ(context({.quick = true}).sizes(full).size(), 1u);
    EXPECT_EQ(context({.rounds = 4, .quick = true}).rounds(9), 4u);
    EXPECT_EQ(context({.size_px = {50, 40}, .quick = true}).sizes(full), (std::vector<glm::uvec2>{{50, 40}}));
}

TEST(Studies, GradesAreWhatTheCommandLineTakes) {
    render::Settings usual;
    usual.lighting.tile_px = 32;
    const PictureGrade grade = grade_of("forward:prepass=1,slices=8", render::k_lighting_parameters,
                                        &render::Settings::lighting, usual);
    EXPECT_EQ(grade.name, "forward:prepass=1,slices=8");
    EXPECT_EQ(grade.settings.lighting.path, render::LightingPath::forward);
    EXPECT_TRUE(grade.settings.lighting.prepass);
    EXPECT_EQ(grade.settings.lighting.slices, 8);
    EXPECT_EQ(grade.settings.lighting.tile_px, 32) << "what it does not name stays";
    EXPECT_THROW(static_cast<void>(
                     grade_of("backward", render::k_lighting_parameters, &render::Settings::lighting, usual)),
                 std::invalid_argument);
}

TEST(Studies, BlocksHaveTheLightsAndSunsThatTheyAreAskedFor) {
    for (const std::uint32_t lights : {1u, 5u, 64u}) {
        const Stage stage = blocks_with_lights(lights, 2);
        ecs::Query<const systems::LocalLight> local;
        ecs::Query<const systems::DirectionalLight> suns;
        EXPECT_EQ(local.count(*stage.world), lights);
        EXPECT_EQ(suns.count(*stage.world), 1u);
        local.each(*stage.world, [](const systems::LocalLight& light) { EXPECT_EQ(light.radius_m, 20.0f); });
    }
}

systems::Feedback picture_of(std::vector<systems::PassTiming> passes, double frame_ms) {
    systems::Feedback feedback;
    feedback.passes = std::move(passes);
    feedback.gpu_frame_ms = frame_ms;
    return feedback;
}

TEST(PassMs, SumsWhatIsAskedForAndNamesWhatIsMissing) {
    PictureCost cost;
    cost.rounds.push_back(picture_of({{.name = "sky", .gpu_ms = 1.0, .memory_bytes = 10},
                                      {.name = "lighting", .gpu_ms = 4.0, .memory_bytes = 30}},
                                     6.0));
    cost.rounds.push_back(picture_of({{.name = "sky", .gpu_ms = 3.0, .memory_bytes = 20}}, 3.0));
    constexpr std::array<std::string_view, 2> k_both{"sky", "lighting"};
    EXPECT_EQ(sums_ms(cost, k_both), (std::vector<double>{5.0, 3.0}));
    EXPECT_EQ(frames_ms(cost), (std::vector<double>{6.0, 3.0}));
    EXPECT_EQ(transient_bytes(cost), 30.0);
    const PassMs ms = pass_ms(cost);
    EXPECT_EQ(ms_text(ms, "sky"), "2.00");
    EXPECT_EQ(ms_text(ms, "lighting"), "2.00") << "no pass is 0 ms of a round";
    EXPECT_EQ(ms_text(ms, "(missing)"), "0.50");
    EXPECT_EQ(ms_text(ms, "bloom"), "–");
    EXPECT_EQ(cost_table("t", cost).rows.size(), 4u);
}

assets::Image grey(std::uint8_t value) {
    assets::Image image{.name = {}, .width = 8, .height = 8, .texels = {}};
    image.texels.assign(8 * 8 * 4, std::byte{value});
    return image;
}

double value_of(const std::vector<Metric>& metrics, const std::string& name) {
    for (const Metric& metric : metrics)
        if (metric.name == name) return metric.value;
    ADD_FAILURE() << name;
    return 0.0;
}

TEST(DisplayMetrics, SeeOnePixel) {
    const assets::Image reference = grey(100);
    assets::Image found = reference;
    const std::vector<Metric> equal = display_metrics(reference, found);
    EXPECT_EQ(value_of(equal, "flip_mean"), 0.0);
    EXPECT_EQ(value_of(equal, "wrong_pixels_pct"), 0.0);
    EXPECT_TRUE(std::isinf(value_of(equal, "psnr_db")));
    found.texels[4 * 9] = std::byte{105};
    const std::vector<Metric> differ = display_metrics(reference, found);
    EXPECT_GT(value_of(differ, "flip_mean"), 0.0);
    EXPECT_DOUBLE_EQ(value_of(differ, "wrong_pixels_pct"), 100.0 / 64.0);
    // 10·log10(1 / (5²/255²/(3·64))), as one channel of one pixel differs by 5.
    EXPECT_NEAR(value_of(differ, "psnr_db"), 10.0 * std::log10(255.0 * 255.0 * 3.0 * 64.0 / 25.0), 1e-3);
    found.texels[4 * 9] = std::byte{104};
    EXPECT_EQ(value_of(display_metrics(reference, found), "wrong_pixels_pct"), 0.0) << "4 are tolerated";
}

TEST(DisplayMetrics, OfSeveralPicturesAreTheirMeans) {
    const std::vector<Metric> mean = mean_metrics({{{"flip_mean", 0.1, ""}}, {{"flip_mean", 0.3, ""}}});
    ASSERT_EQ(mean.size(), 1u);
    EXPECT_DOUBLE_EQ(mean.front().value, 0.2);
    EXPECT_TRUE(mean_metrics({}).empty());
}

}  // namespace
}  // namespace rambla::game::study
