// What each effect of the picture costs: everything on, then each switched off in turn.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <span>

#include "assets/daylight.h"
#include "game/statistics.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/pass_ms.h"
#include "game/study/picture_error.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr glm::uvec2 k_size_px{1280, 720};
constexpr double k_mib = 1024.0 * 1024.0;
constexpr std::string_view k_all_on = "everything on";

struct Hour {
    std::string_view name;
    assets::TimeOfDay time;
};
const std::array<Hour, 3> k_hours{{{"noon", {}}, {"dusk", assets::k_dusk}, {"night", assets::k_night}}};

/// Each grade switches one thing off, or to its next cheaper grade.
std::vector<PictureGrade> grades() {
    using render::Settings;
    const Settings usual;
    std::vector<PictureGrade> all{{.name = std::string{k_all_on}, .settings = usual}};
    const auto switched = [&](std::string_view option, std::string value, const auto& table, auto part) {
        PictureGrade grade = grade_of(std::move(value), table, part, usual);
        grade.name = fmt::format("--{} {}", option, grade.name);
        all.push_back(std::move(grade));
    };
    const auto without = [&](std::string what, std::function<void(systems::Frame&)> change) {
        all.push_back({.name = "without " + std::move(what), .settings = usual, .change = std::move(change)});
    };
    switched("shadows", "off", render::k_shadow_parameters, &Settings::shadows);
    switched("shadows", "focused:taps=4", render::k_shadow_parameters, &Settings::shadows);
    switched("shadows", "focused:size=2048", render::k_shadow_parameters, &Settings::shadows);
    switched("detail", "flat", render::k_detail_parameters, &Settings::detail);
    switched("brdf", "blinn", render::k_brdf_parameters, &Settings::brdf);
    switched("brdf", "lambert", render::k_brdf_parameters, &Settings::brdf);
    switched("exposure", "fixed", render::k_exposure_parameters, &Settings::exposure);
    switched("exposure", "auto:luminance=compute", render::k_exposure_parameters, &Settings::exposure);
    switched("tonemap", "reinhard", render::k_tone_parameters, &Settings::tone);
    switched("aa", "none", render::k_anti_aliasing_parameters, &Settings::anti_aliasing);
    without("lamps", [](systems::Frame& frame) { frame.lights.clear(); });
    without("glass, haze and what fades", [](systems::Frame& frame) { frame.blended.clear(); });
    without("emission and light maps", [](systems::Frame& frame) { frame.needs_emission = false; });
    return all;
}

/// What a grade saves of the picture with everything on: pairs of rounds, which show the same.
std::vector<Metric> savings(const PictureCost& on, const PictureCost& off) {
    std::vector<double> ms;
    std::vector<double> shares;
    for (std::size_t i = 0; i < std::min(on.rounds.size(), off.rounds.size()); ++i) {
        ms.push_back(on.rounds[i].gpu_frame_ms - off.rounds[i].gpu_frame_ms);
        shares.push_back(100.0 * ms.back() / on.rounds[i].gpu_frame_ms);
    }
    return {{"saved_ms", median(ms), "ms"},
            {"saved_share_pct", median(shares), "%"},
            {"saved_mib", (transient_bytes(on) - transient_bytes(off)) / k_mib, "MiB"}};
}

std::vector<std::vector<Metric>> changes(StudyContext& context, Stage& stage,
                                         const std::vector<PictureGrade>& all, const systems::Eye& eye) {
    std::vector<std::vector<Metric>> metrics(all.size());
    const auto picture = [&](const PictureGrade& grade) {
        return draw(context.thread(), stage, grade, eye, {.display = true}).display.value();
    };
    const assets::Image whole = picture(all.front());
    for (std::size_t i = 0; i < all.size() && !context.stopped(); ++i)
        metrics[i] = display_metrics(whole, picture(all[i]));
    return metrics;
}

void measure(StudyContext& context, const Hour& hour, glm::uvec2 size_px, StudyResult& result) {
    const std::string scene = fmt::format("street at {}, {}", hour.name, size_text(size_px));
    Stage stage = make_stage("street", context.options().seed, hour.time, {});
    static_cast<void>(show(context, stage));
    const std::uint32_t rounds = context.rounds(k_rounds);
    const EyeOfRound eye = along_the_walk(stage, size_px, rounds);
    const std::vector<PictureGrade> all = grades();
    const std::vector<PictureCost> costs =
        draw_in_turns(context, stage, all, eye, rounds, "passes: " + scene);
    if (costs.empty()) return;
    const std::vector<std::vector<Metric>> change = changes(context, stage, all, eye(rounds / 2));
    for (std::size_t i = 0; i < costs.size(); ++i) {
        GradeResult grade{.scene = scene, .grade = all[i].name};
        grade.ms = frames_ms(costs[i]);
        grade.bytes = transient_bytes(costs[i]);
        grade.metrics = savings(costs.front(), costs[i]);
        grade.metrics.insert(grade.metrics.end(), change[i].begin(), change[i].end());
        result.grades.push_back(std::move(grade));
    }
    result.tables.push_back(cost_table("Passes with everything on: " + scene, costs.front()));
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Passes and effects";
    result.question =
        "What does each effect cost of a whole picture, in milliseconds and in memory, and what does the "
        "picture lose without it? Everything is on, then each is switched off, or to its cheaper grade, in "
        "turn.";
    result.reference =
        "The picture with everything on. saved_ms is what is gained without the effect, as the median over "
        "pairs of the same picture; FLIP and PSNR say how much that changes the picture in the middle of the "
        "walk.";
    result.plotted_metric = "flip_mean";
    const std::size_t hours = context.options().quick ? 1 : k_hours.size();
    for (const Hour& hour : std::span{k_hours}.first(hours)) {
        for (const glm::uvec2 size_px : context.sizes({k_size_px})) {
            if (context.stopped()) return;
            measure(context, hour, size_px, result);
        }
    }
}

}  // namespace

const Study k_passes_study{
    .name = "passes", .summary = "what each effect costs: all on, then each off in turn", .run = run};

}  // namespace rambla::game::study
