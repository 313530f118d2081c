#include "game/study/light_step.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "render/post/adaptation.h"

namespace rambla::game::study {
namespace {

constexpr double k_step_ev = 6.0;
/// Of the scene's light, one phase after the other.
constexpr std::array<double, 5> k_phases_ev{0.0, k_step_ev, 0.0, -k_step_ev, 0.0};
constexpr double k_least_step_ev = 0.1;  ///< the first phase has none
constexpr double k_phase_s = 3.0;
constexpr double k_frame_s = 1.0 / 15.0;
constexpr double k_quick_phase_s = 0.2;
constexpr glm::uvec2 k_size_px{160, 90};

void scale_light(systems::Frame& frame, float factor) {
    assets::Environment& light = frame.environment;
    light.sun_illuminance *= factor;
    light.sky_zenith_radiance *= factor;
    light.sky_horizon_radiance *= factor;
    light.ground_radiance *= factor;
    for (systems::FrameLight& lamp : frame.lights)
        lamp.intensity *= factor;
}

/// How exposure went in one phase.
struct Phase {
    double begin_ev = 0.0;
    double target_ev = 0.0;
    double worst_from_exponential_ev = 0.0;
    double overshoot_ev = 0.0;
    double largest_turn_ev = 0.0;  ///< farthest that a frame went the wrong way

    void take(double since_s, double before_ev, double ev, const render::ExposureParameters& parameters) {
        const render::FollowedShares shares = render::followed_shares(since_s, parameters);
        const double expected = render::followed_ev(begin_ev, target_ev, shares);
        const double sign = target_ev > begin_ev ? 1.0 : -1.0;
        worst_from_exponential_ev = std::max(worst_from_exponential_ev, std::fabs(ev - expected));
        overshoot_ev = std::max(overshoot_ev, sign * (ev - target_ev));
        largest_turn_ev = std::max(largest_turn_ev, sign * (before_ev - ev));
    }
};

}  // namespace

void follow_light_steps(StudyContext& context, Stage& stage, const std::string& grade, StudyResult& result) {
    PictureGrade film =
        grade_of(grade, render::k_exposure_parameters, &render::Settings::exposure, plain_settings());
    const render::ExposureParameters parameters = film.settings.exposure;
    systems::Eye eye = walk_eye(stage, stage.walk.front().time_s);
    eye.size_px = k_size_px;
    const double phase_s = context.options().quick ? k_quick_phase_s : k_phase_s;
    const auto frames = static_cast<std::uint32_t>(std::lround(phase_s / k_frame_s));
    Series light{.name = "stops of scene light", .points = {}, .line = true};
    Series found{.name = "departure of exposure", .points = {}, .line = true};
    Series wanted{.name = "its target", .points = {}, .line = true};
    Phase worst;
    double time_s = 0.0;
    double ev = 0.0;
    double smallest_step_ev = k_step_ev;
    for (const double light_ev : k_phases_ev) {
        Phase phase{.begin_ev = ev};
        for (std::uint32_t i = 1; i <= frames && !context.stopped(); ++i) {
            film.change = [&](systems::Frame& frame) {
                frame.time_s = time_s;
                scale_light(frame, static_cast<float>(std::exp2(light_ev)));
            };
            const auto told = draw(context.thread(), stage, film, eye).feedback.exposure;
            phase.target_ev = render::target_ev(told.average_luminance, parameters);
            // The first frame is where it shall be.
            if (!film.follows) phase.begin_ev = ev = phase.target_ev;
            film.follows = true;
            if (time_s > 0.0) phase.take(i * k_frame_s, ev, told.departure_ev, parameters);
            ev = told.departure_ev;
            light.points.emplace_back(time_s, light_ev);
            found.points.emplace_back(time_s, ev);
            wanted.points.emplace_back(time_s, phase.target_ev);
            time_s += k_frame_s;
        }
        const double step_ev = std::fabs(phase.target_ev - phase.begin_ev);
        if (step_ev > k_least_step_ev) smallest_step_ev = std::min(smallest_step_ev, step_ev);
        worst.worst_from_exponential_ev =
            std::max(worst.worst_from_exponential_ev, phase.worst_from_exponential_ev);
        worst.overshoot_ev = std::max(worst.overshoot_ev, phase.overshoot_ev);
        worst.largest_turn_ev = std::max(worst.largest_turn_ev, phase.largest_turn_ev);
    }
    if (context.stopped()) return;
    result.grades.push_back(
        {.scene = "light that steps by ±6 EV and back",
         .grade = grade,
         .metrics = {{"overshoot_pct", 100.0 * worst.overshoot_ev / smallest_step_ev, "%"},
                     {"wrong_way_ev", worst.largest_turn_ev, "EV"},
                     {"from_exponential_ev", worst.worst_from_exponential_ev, "EV"}}});
    result.plots.push_back({.title = fmt::format("Exposure after steps of the light, {}", grade),
                            .x_label = "s",
                            .y_label = "EV",
                            .series = {light, wanted, found}});
}

}  // namespace rambla::game::study
