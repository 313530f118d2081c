// Grades of surface detail along the street's walk.
#include <spdlog/fmt/fmt.h>

#include <array>
#include <utility>

#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/pass_ms.h"
#include "game/study/picture_error.h"
#include "game/study/picture_part.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr std::array<std::string_view, 7> k_grades{"flat",
                                                   "normal",
                                                   "parallax",
                                                   "occlusion:steps=8",
                                                   "occlusion:steps=16",
                                                   "occlusion:steps=32",
                                                   "occlusion:steps=128"};
constexpr std::array<std::string_view, 1> k_passes{"gbuffer"};
constexpr glm::uvec2 k_part_px{160, 90};  ///< of a picture, as the page shows it

std::vector<PictureGrade> grades() {
    render::Settings settings = plain_settings();
    settings.shadows.method = render::ShadowMethod::off;  // which would hide some of it
    std::vector<PictureGrade> all;
    for (const std::string_view name : k_grades)
        all.push_back(
            grade_of(std::string{name}, render::k_detail_parameters, &render::Settings::detail, settings));
    return all;
}

/// What is seen of each grade's picture where the first grade and the last differ most.
PictureRow parts(const std::string& scene, const std::vector<PictureGrade>& all,
                 const std::vector<assets::Image>& pictures) {
    PictureRow row{.title = fmt::format("Where flat differs most from {}: {}", all.back().name, scene),
                   .pictures = {}};
    const glm::uvec2 corner = most_different_part(pictures.front(), pictures.back(), k_part_px);
    for (std::size_t i = 0; i < all.size(); ++i)
        row.pictures.push_back({all[i].name, part_of(pictures[i], corner, k_part_px)});
    return row;
}

struct Errors {
    std::vector<std::vector<Metric>> metrics;  ///< of each grade against the last one, means over the rounds
    std::vector<assets::Image> first{};        ///< each grade's picture of the first round
};

Errors errors(StudyContext& context, Stage& stage, const std::vector<PictureGrade>& all,
              const EyeOfRound& eye, std::uint32_t rounds) {
    Errors found;
    std::vector<std::vector<std::vector<Metric>>> metrics(all.size());
    for (std::uint32_t round = 0; round < rounds && !context.stopped(); ++round) {
        std::vector<assets::Image> pictures;
        for (const PictureGrade& grade : all)
            pictures.push_back(
                draw(context.thread(), stage, grade, eye(round), {.display = true}).display.value());
        for (std::size_t i = 0; i < all.size(); ++i)
            metrics[i].push_back(display_metrics(pictures.back(), pictures[i]));
        if (round == 0) found.first = std::move(pictures);
    }
    for (const auto& of_grade : metrics)
        found.metrics.push_back(mean_metrics(of_grade));
    return found;
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Surface detail";
    result.question =
        "What do normal maps, parallax and parallax occlusion mapping cost, and what do they add to the "
        "picture of the street at noon, without shadows? Milliseconds are those of the G-buffer pass, which "
        "samples them.";
    result.reference =
        "Parallax occlusion mapping that meets the heights at 128 places. This says how far a grade is from "
        "the finest, which stands for true geometry as far as tests show.";
    result.plotted_metric = "flip_mean";
    Stage stage = make_stage("street", context.options().seed, {}, {});
    static_cast<void>(show(context, stage));
    const std::uint32_t rounds = context.rounds(k_rounds);
    for (const glm::uvec2 size_px : context.sizes({{960, 540}, {1280, 720}})) {
        const std::string scene = fmt::format("street, {}", size_text(size_px));
        const std::vector<PictureGrade> all = grades();
        const EyeOfRound eye = along_the_walk(stage, size_px, rounds);
        const std::vector<PictureCost> costs =
            draw_in_turns(context, stage, all, eye, rounds, "detail: " + scene);
        Errors found = errors(context, stage, all, eye, rounds);
        for (std::size_t i = 0; i < costs.size(); ++i) {
            result.grades.push_back({.scene = scene,
                                     .grade = all[i].name,
                                     .ms = sums_ms(costs[i], k_passes),
                                     .bytes = transient_bytes(costs[i]),
                                     .metrics = std::move(found.metrics[i])});
        }
        if (!costs.empty() && !found.first.empty()) result.pictures.push_back(parts(scene, all, found.first));
        if (context.stopped()) return;
    }
}

}  // namespace

const Study k_detail_study{.name = "detail", .summary = "normal maps, parallax and relief", .run = run};

}  // namespace rambla::game::study
