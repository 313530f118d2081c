// What studies measure, measured: that grades take turns, that an end keeps whole rounds, and that references
// see when a picture is another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "game/compare.h"
#include "game/study/blocks_scene.h"
#include "game/study/frame_tracer.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/lighting_reference.h"
#include "game/study/surface_errors.h"

namespace rambla::game::study {
namespace {

constexpr glm::uvec2 k_size_px{96, 54};

double value_of(const std::vector<Metric>& metrics, const std::string& name) {
    for (const Metric& metric : metrics)
        if (metric.name == name) return metric.value;
    ADD_FAILURE() << "no metric " << name;
    return 0.0;
}

std::vector<std::string> names_of(const std::vector<Metric>& metrics) {
    std::vector<std::string> names;
    for (const Metric& metric : metrics)
        names.push_back(metric.name);
    return names;
}

struct Harness : testing::Test {
    std::atomic<bool> stop{false};
    StudyContext context{{.quick = true, .quiet = true}, stop};
    Stage stage = blocks_with_lights(16, 1);
    std::shared_ptr<const assets::ProcessedScene> processed = show(context, stage);

    static std::vector<PictureGrade> two_grades() {
        return {{.name = "a", .settings = plain_settings()}, {.name = "b", .settings = plain_settings()}};
    }
    systems::Eye eye(double share) const { return eye_of(stage, View::above, share, k_size_px); }
};

TEST_F(Harness, GradesTakeTurnsAndTheFirstRoundDoesNotCount) {
    std::string turns;
    std::vector<PictureGrade> grades = two_grades();
    grades[0].change = [&](systems::Frame&) {
        turns += 'a';
    };
    grades[1].change = [&](systems::Frame&) {
        turns += 'b';
    };
    std::vector<std::uint32_t> asked;
    const auto costs = draw_in_turns(
        context, stage, grades,
        [&](std::uint32_t round) {
            asked.push_back(round);
            return eye(0.0);
        },
        3, "test");
    EXPECT_EQ(turns,
              "ab"
              "ab"
              "ba"
              "ab");
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{0, 0, 0, 1, 2})) << "one eye for all grades of a round";
    ASSERT_EQ(costs.size(), 2u);
    for (const PictureCost& cost : costs) {
        ASSERT_EQ(cost.rounds.size(), 3u);
        for (const double ms : frames_ms(cost))
            EXPECT_GT(ms, 0.0);
    }
}

TEST_F(Harness, AnEndKeepsWholeRoundsOnly) {
    std::vector<PictureGrade> grades = two_grades();
    int drawn = 0;
    grades[0].change = grades[1].change = [&](systems::Frame&) {
        stop = ++drawn >= 5;
    };
    const auto costs = draw_in_turns(
        context, stage, grades, [&](std::uint32_t) { return eye(0.0); }, 10, "test");
    // Two that do not count, one round of two, and the fifth, after which the second grade is missing.
    EXPECT_EQ(drawn, 5);
    ASSERT_EQ(costs.size(), 2u);
    EXPECT_EQ(costs[0].rounds.size(), 1u);
    EXPECT_EQ(costs[1].rounds.size(), 1u);
}

TEST_F(Harness, AnEndBeforeAWholeRoundLeavesNothingThatCouldBeTakenForNumbers) {
    std::vector<PictureGrade> grades = two_grades();
    for (const int last : {1, 3}) {  // while nothing counts yet, and in the first round
        int drawn = 0;
        stop = false;
        grades[0].change = grades[1].change = [&](systems::Frame&) {
            stop = ++drawn >= last;
        };
        EXPECT_TRUE(draw_in_turns(
                        context, stage, grades, [&](std::uint32_t) { return eye(0.0); }, 10, "test")
                        .empty());
    }
}

TEST_F(Harness, TheLightingReferenceAgreesWithEveryPathAndSeesACheaperReflection) {
    const render::Settings settings = compare_settings({}, "blocks");
    const LightingReference reference{stage, *processed, eye(0.3)};
    const auto error_of = [&](const PictureGrade& grade) {
        return reference.error_of(context, stage, grade);
    };
    double ggx = 0.0;
    for (const std::string_view path : render::k_lighting_paths) {
        const auto metrics = error_of(grade_of(std::string{path}, render::k_lighting_parameters,
                                               &render::Settings::lighting, settings));
        // An 8-bit base colour is off by 1/510 of its encoded value at most, which is 2.2 times that of its
        // light, and the half floats of the sum by 2⁻¹¹: 1 % covers both, also for ground of 0.35.
        EXPECT_LT(value_of(metrics, "error_p99_linear"), 0.01) << path;
        EXPECT_GT(value_of(metrics, "psnr_db"), 45.0) << path;
        // 96×54 pixels of boxes and ground: sky and silhouettes are not compared.
        EXPECT_GT(value_of(metrics, "compared_pct"), 60.0) << path;
        ggx = std::max(ggx, value_of(metrics, "flip_mean"));
    }
    const auto lambert =
        error_of(grade_of("lambert", render::k_brdf_parameters, &render::Settings::brdf, settings));
    EXPECT_GT(value_of(lambert, "flip_mean"), 3.0 * ggx);
    EXPECT_GT(value_of(lambert, "error_p99_linear"), 0.02);
}

struct Surfaces : Harness {
    render::FrameOutput drawn;
    assets::HitPicture seen;

    void draw_in(const char* layout) {
        const PictureGrade grade =
            grade_of(layout, render::k_gbuffer_parameters, &render::Settings::gbuffer, plain_settings());
        drawn = draw(context.thread(), stage, grade, eye(0.3), {.objects = true, .surfaces = true});
        systems::Frame frame;
        systems::build_frame(*stage.world, eye(0.3), 1.0f, frame);
        const FrameTracer traced{frame, *stage.scene, *processed};
        seen = assets::trace_picture(traced.tracer(), traced.camera());
    }
    std::vector<Metric> errors() const {
        SurfaceErrors errors;
        errors.add(seen, drawn.objects.value(), drawn.surfaces.value());
        return errors.metrics();
    }
    /// Nothing here has masks or coincident faces, which show another surface than the ray meets.
    static void expect_all_compared(const std::vector<Metric>& found) {
        EXPECT_EQ(value_of(found, "other_surface_pct"), 0.0);
        EXPECT_EQ(value_of(found, "broken_pct"), 0.0);
        EXPECT_GT(value_of(found, "compared_pct"), 10.0) << "small boxes have much rim";
    }
};

TEST_F(Surfaces, OfTheCompactLayoutAreWithinWhatItsBitsAllow) {
    draw_in("compact");
    const auto found = errors();
    expect_all_compared(found);
    // Depth, the matrices and the interpolation are 24-bit: 2⁻²⁴ = 0.06 ppm each, of which a surface seen at
    // a grazing angle makes a dozen times as much along the ray.
    EXPECT_LT(value_of(found, "position_p99_ppm"), 5.0);
    // 16 bits each of the octahedron's two axes: half a step of 2/65535 in both moves the third coordinate by
    // their sum, and normalising stretches by √3 at most: √6·√3/65535 is 0.0037°.
    EXPECT_LT(value_of(found, "angle_max_deg"), 0.0038);
}

TEST_F(Surfaces, OfTheWideLayoutAreThoseOfHalfFloats) {
    draw_in("wide");
    const auto found = errors();
    expect_all_compared(found);
    // 11 bits of each coordinate: half a step is 2⁻¹² of it at most, 423 ppm of the length with all three.
    EXPECT_LT(value_of(found, "position_max_mm"), 1e3 * 200.0 * 3.0 * 0x1p-12)
        << "nothing here is 200 m away";
    EXPECT_GT(value_of(found, "position_p99_ppm"), 50.0) << "which a position from depth does not show";
}

TEST_F(Surfaces, AnotherPixelIsNoticed) {
    draw_in("compact");
    const auto before = errors();
    const auto middle = std::size_t{k_size_px.y - 4} * k_size_px.x + k_size_px.x / 2;  // ground
    ASSERT_TRUE(seen.hits[middle].exists());
    const auto texel = [&](assets::Image& image) {
        return reinterpret_cast<glm::vec4*>(image.texels.data()) + middle;
    };
    texel(drawn.surfaces->positions)->x += 0.5f;
    *texel(drawn.surfaces->normals) = {1.0f, 0.0f, 0.0f, 0.0f};
    const auto after = errors();
    EXPECT_NEAR(value_of(after, "position_max_mm"), 500.0, 1.0);
    EXPECT_GT(value_of(after, "angle_max_deg"), 10.0);
    EXPECT_LT(value_of(before, "position_max_mm"), 100.0);
    expect_all_compared(before);
    const glm::vec4 place = *texel(drawn.surfaces->positions);
    texel(drawn.surfaces->positions)->x += 50.0f;
    const auto elsewhere = errors();
    EXPECT_GT(value_of(elsewhere, "other_surface_pct"), 0.0);
    EXPECT_LT(value_of(elsewhere, "position_max_mm"), 100.0)
        << "which is not taken for an error of its place";
    texel(drawn.surfaces->positions)->x = std::nanf("");
    EXPECT_GT(value_of(errors(), "broken_pct"), 0.0);
    *texel(drawn.surfaces->positions) = place;
    EXPECT_EQ(value_of(errors(), "broken_pct"), 0.0);
    *texel(drawn.surfaces->normals) = glm::vec4{0.0f};
    EXPECT_GT(value_of(errors(), "broken_pct"), 0.0);
}

TEST_F(Surfaces, NothingComparedIsNoPerfectLayout) {
    draw_in("compact");
    std::fill(drawn.objects->ids.begin(), drawn.objects->ids.end(), assets::k_none);
    EXPECT_THAT(names_of(errors()), testing::ElementsAre("other_surface_pct", "broken_pct", "compared_pct"));
    EXPECT_EQ(value_of(errors(), "compared_pct"), 0.0);
}

TEST_F(Harness, ObjectsAreWhatIsSeenInEveryPath) {
    const render::Settings settings = compare_settings({}, "blocks");
    std::vector<std::uint32_t> first;
    for (const std::string_view path : render::k_lighting_paths) {
        const PictureGrade grade =
            grade_of(std::string{path}, render::k_lighting_parameters, &render::Settings::lighting, settings);
        const render::FrameOutput drawn = draw(context.thread(), stage, grade, eye(0.3), {.objects = true});
        ASSERT_TRUE(drawn.objects);
        EXPECT_EQ(drawn.objects->width, k_size_px.x);
        ASSERT_EQ(drawn.objects->ids.size(), std::size_t{k_size_px.x} * k_size_px.y);
        EXPECT_FALSE(drawn.display) << "what nobody asked for is not read back";
        if (first.empty()) first = drawn.objects->ids;
        EXPECT_EQ(drawn.objects->ids, first) << path;
    }
    EXPECT_NE(std::count(first.begin(), first.end(), assets::k_none), 0) << "some sky";
}

}  // namespace
}  // namespace rambla::game::study
