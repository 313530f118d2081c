#include "game/study/antialiasing_motion.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ecs/query.h"
#include "game/progress.h"
#include "game/study/antialiasing_grades.h"
#include "game/study/metrics/flip.h"
#include "game/study/metrics/temporal.h"
#include "game/study/metrics/trail.h"
#include "systems/saved_state.h"

namespace rambla::game::study {
namespace {

/// References of motion are of many frames: sixteen pixels for one, and an edge is off by 1/8 of its contrast
/// at most.
constexpr std::uint32_t k_reference_samples = 4;

constexpr std::uint32_t k_turned_frames = 9;
constexpr std::uint32_t k_quick_turned_frames = 2;
/// Of a pixel per frame, sideways and up: no fraction of each other, so that edges of all directions pass
/// pixels' middles at different times.
constexpr float k_sideways_px = 0.125f;
constexpr float k_up_px = 0.091f;
/// Linear light. An edge of full contrast changes its pixels by an eighth while the eye turns by as much.
constexpr double k_flicker_tolerance = 0.15;

constexpr std::uint32_t k_candidate_eyes = 16;
constexpr std::uint32_t k_walked_frames = 30;
constexpr std::uint32_t k_quick_walked_frames = 4;
/// Of a history that keeps 0.95 a third is left then: what takes so long to go is seen.
constexpr std::uint32_t k_longest_trail_frames = 24;
/// Of the display's range: two and a half steps of a byte, which nobody sees in a pixel that changes.
constexpr double k_trail_tolerance = 0.01;

using Pictures = std::vector<Picture>;

/// The eye after so many frames of slow motion.
systems::Eye turned(const systems::Eye& eye, std::uint32_t frame) {
    const float pixel_rad = 2.0f * std::tan(0.5f * eye.vertical_fov_rad) / static_cast<float>(eye.size_px.y);
    const float angle = pixel_rad * static_cast<float>(frame);
    systems::Eye turned = eye;
    turned.rotation = eye.rotation * glm::angleAxis(k_sideways_px * angle, glm::vec3{0, 1, 0}) *
                      glm::angleAxis(k_up_px * angle, glm::vec3{1, 0, 0});
    return turned;
}

/// A film; before its first picture, as many as the grade wants.
template <class DrawFrame>
Pictures sequence(StudyContext& context, PictureGrade grade, std::uint32_t frames, DrawFrame&& draw_frame) {
    Pictures pictures;
    for (std::uint32_t frame = 0; frame < frames && !context.stopped(); ++frame) {
        pictures.push_back(to_picture(draw_frame(grade, frame)));
        grade.frames_before = 0;
        grade.follows = true;
    }
    return pictures;
}

Pictures turning(StudyContext& context, Stage& stage, const PictureGrade& grade, const systems::Eye& eye,
                 std::uint32_t frames) {
    return sequence(context, grade, frames, [&](const PictureGrade& now, std::uint32_t frame) {
        return draw(context.thread(), stage, now, turned(eye, frame), {.display = true}).display.value();
    });
}

std::vector<Metric> slow_motion_metrics(const Pictures& reference, const Pictures& test) {
    double flicker = 0.0;
    double flip = 0.0;
    for (std::size_t i = 1; i < test.size(); ++i) {
        flicker += flicker_pct({reference[i - 1], reference[i]}, {test[i - 1], test[i]}, k_flicker_tolerance);
        flip += ldr_flip(reference[i], test[i]).mean;
    }
    const auto pairs = static_cast<double>(std::max<std::size_t>(test.size(), 2) - 1);
    return {{"flicker_pct", flicker / pairs, "%"}, {"flip_mean", flip / pairs, ""}};
}

/// Entities that move, by their indices, which object ids are.
std::set<std::uint32_t> moving_objects(ecs::World& world) {
    std::set<std::uint32_t> moving;
    ecs::Query<ecs::Entity, const systems::PreviousWorldTransform, ecs::With<systems::Renderable>>{}.each(
        world,
        [&](ecs::Entity entity, const systems::PreviousWorldTransform&) { moving.insert(entity.index); });
    return moving;
}

std::vector<std::uint8_t> moving_mask(const render::ObjectImage& objects,
                                      const std::set<std::uint32_t>& moving) {
    std::vector<std::uint8_t> mask;
    mask.reserve(objects.ids.size());
    for (const std::uint32_t id : objects.ids)
        mask.push_back(moving.contains(id) ? 1 : 0);
    return mask;
}

struct Walk {
    Pictures pictures;
    std::vector<std::vector<std::uint8_t>> moving;  ///< per frame, where something that moves is seen
};

/// Walks a stage's world on from a state, step by step.
class Walker {
public:
    Walker(StudyContext& context, Stage& stage, const systems::Eye& eye, std::uint32_t frames)
        : context_{context},
          stage_{stage},
          eye_{eye},
          frames_{frames},
          begin_{systems::save_state(*stage.world, {})},
          moving_{moving_objects(*stage.world)} {}

    Walk walk(const PictureGrade& grade, bool where_something_moves = false) {
        stage_.world = systems::load_state(begin_, *stage_.world, {});
        Walk walk;
        walk.pictures = sequence(context_, grade, frames_, [&](const PictureGrade& now, std::uint32_t) {
            systems::step(*stage_.world);
            render::FrameOutput drawn = draw(context_.thread(), stage_, now, eye_,
                                             {.display = true, .objects = where_something_moves});
            if (drawn.objects) walk.moving.push_back(moving_mask(*drawn.objects, moving_));
            return std::move(drawn.display.value());
        });
        stage_.world = systems::load_state(begin_, *stage_.world, {});
        return walk;
    }

private:
    StudyContext& context_;
    Stage& stage_;
    systems::Eye eye_;
    std::uint32_t frames_;
    std::vector<std::byte> begin_;
    std::set<std::uint32_t> moving_;
};

TrailMeter trails(const Pictures& reference, const Walk& plain, const Pictures& test) {
    TrailMeter meter{k_longest_trail_frames};
    for (std::size_t i = 0; i < test.size(); ++i)
        meter.add(reference[i], plain.pictures[i], test[i], plain.moving[i]);
    return meter;
}

Series line_of(const std::string& name, const TrailMeter& meter) {
    Series series{.name = name, .points = {}, .line = true};
    const std::vector<double> excess = meter.excess_display();
    for (std::size_t age = 0; age < excess.size(); ++age)
        if (meter.pixels()[age] > 0)
            series.points.emplace_back(static_cast<double>(age + 1), 100.0 * excess[age]);
    return series;
}

}  // namespace

systems::Eye busiest_eye(StudyContext& context, Stage& stage, glm::uvec2 size_px) {
    constexpr glm::uvec2 k_glance_px{160, 90};
    const std::uint32_t candidates = context.options().quick ? 2 : k_candidate_eyes;
    const EyeOfRound glance = along_the_walk(stage, k_glance_px, candidates);
    const PictureGrade plain = antialiasing_grades(context, Past::moment).front();
    const std::set<std::uint32_t> moving = moving_objects(*stage.world);
    std::uint32_t best = 0;
    std::ptrdiff_t most = -1;
    for (std::uint32_t i = 0; i < candidates && !context.stopped(); ++i) {
        const render::FrameOutput drawn = draw(context.thread(), stage, plain, glance(i), {.objects = true});
        const std::vector<std::uint8_t> mask = moving_mask(drawn.objects.value(), moving);
        const std::ptrdiff_t count = std::count(mask.begin(), mask.end(), 1);
        if (count <= most) continue;
        most = count;
        best = i;
    }
    return along_the_walk(stage, size_px, candidates)(best);
}

void measure_slow_motion(StudyContext& context, Stage& stage, const systems::Eye& eye, StudyResult& result) {
    const std::uint32_t frames = context.options().quick ? k_quick_turned_frames : k_turned_frames;
    const std::vector<PictureGrade> grades = antialiasing_grades(context, Past::settled);
    const std::string scene = fmt::format("eye turning by 1/{} pixel a frame, {}",
                                          std::lround(1.0f / k_sideways_px), size_text(eye.size_px));
    Progress progress{"antialiasing: " + scene, static_cast<std::uint32_t>(grades.size()),
                      !context.options().quiet};
    const Pictures reference =
        turning(context, stage, supersampled(context, k_reference_samples), eye, frames);
    std::vector<GradeResult> found;
    for (const PictureGrade& grade : grades) {
        const Pictures test = turning(context, stage, grade, eye, frames);
        if (context.stopped()) return;
        found.push_back(
            {.scene = scene, .grade = grade.name, .metrics = slow_motion_metrics(reference, test)});
        progress.update(static_cast<std::uint32_t>(found.size()));
    }
    result.grades.insert(result.grades.end(), found.begin(), found.end());
}

void measure_trails(StudyContext& context, Stage& stage, const systems::Eye& eye, StudyResult& result) {
    const std::uint32_t frames = context.options().quick ? k_quick_walked_frames : k_walked_frames;
    const std::vector<PictureGrade> grades = antialiasing_grades(context, Past::settled);
    const std::string scene = fmt::format("behind walkers and cars, {}", size_text(eye.size_px));
    Progress progress{"antialiasing: " + scene, static_cast<std::uint32_t>(grades.size()),
                      !context.options().quiet};
    Walker walker{context, stage, eye, frames};
    const Pictures reference = walker.walk(supersampled(context, k_reference_samples)).pictures;
    const Walk plain = walker.walk(grades.front(), true);
    Plot plot{.title = "What is left of walkers and cars where they have been",
              .x_label = "frames since they were there",
              .y_label = "error above that without anti-aliasing, % of the display's range",
              .series = {}};
    std::vector<GradeResult> found;
    for (const PictureGrade& grade : grades) {
        const Pictures test = walker.walk(grade).pictures;
        if (context.stopped()) return;
        const TrailMeter meter = trails(reference, plain, test);
        const std::vector<double> excess = meter.excess_display();
        found.push_back(
            {.scene = scene,
             .grade = grade.name,
             .metrics = {{"trail_frames", static_cast<double>(trail_frames(excess, k_trail_tolerance)), ""},
                         {"trail_first_frame_pct", 100.0 * excess.front(), "%"},
                         {"uncovered_pixels", static_cast<double>(meter.pixels().front()), ""}}});
        plot.series.push_back(line_of(grade.name, meter));
        progress.update(static_cast<std::uint32_t>(found.size()));
    }
    result.grades.insert(result.grades.end(), found.begin(), found.end());
    result.plots.push_back(std::move(plot));
}

}  // namespace rambla::game::study
