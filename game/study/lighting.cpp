// Lighting paths on the boxes of the comparison scene, by number of lights and size of the picture.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "game/compare.h"
#include "game/statistics.h"
#include "game/study/blocks_scene.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/lighting_reference.h"
#include "game/study/pass_ms.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 5;
constexpr std::uint32_t k_most_unculled_lights = 256;
constexpr std::uint32_t k_usual_lights = 64;
constexpr glm::uvec2 k_usual_size_px{1280, 720};
constexpr glm::uvec2 k_brdf_size_px{480, 270};
constexpr std::uint32_t k_checked_width_px = 480;
constexpr double k_wanted_of_tiled = 3.0;

constexpr std::array<std::string_view, 3> k_lighting{"light tiles", "lighting", "light volumes"};
/// From geometry to lit pixels: what deferred and forward do differently.
constexpr std::array<std::string_view, 7> k_surfaces{
    "light tiles", "lighting", "light volumes", "depth pre-pass", "gbuffer", "shadow result", "forward"};

/// One set-up, drawn in every way.
struct Case {
    View view = View::above;
    glm::uvec2 size_px{0};
    std::uint32_t lights = 0;
    std::uint32_t suns = 1;
};

struct Measured {
    Case what;
    std::vector<PictureGrade> grades;
    std::vector<PictureCost> costs;

    [[nodiscard]] const PictureCost* cost_of(std::string_view grade) const {
        for (std::size_t i = 0; i < costs.size(); ++i)
            if (grades[i].name == grade) return &costs[i];
        return nullptr;
    }
};

std::string scene_text(const Case& what) {
    return fmt::format("blocks from {}, {} {}{}, {}", to_text(what.view), what.lights,
                       what.lights == 1 ? "light" : "lights", what.suns > 1 ? ", 2 suns" : "",
                       size_text(what.size_px));
}

std::vector<Case> cases(const StudyContext& context) {
    std::vector<std::uint32_t> lights{1, 16, 64, 256, 1024};
    if (context.options().quick) lights = {k_usual_lights};
    std::vector<Case> all;
    for (const glm::uvec2 size_px : context.sizes({{480, 270}, {960, 540}, k_usual_size_px, {1920, 1080}})) {
        for (const std::uint32_t count : lights) {
            all.push_back({.view = View::above, .size_px = size_px, .lights = count});
            if (count != k_usual_lights) continue;
            all.push_back({.view = View::above, .size_px = size_px, .lights = count, .suns = 2});
            all.push_back({.view = View::below, .size_px = size_px, .lights = count});
        }
    }
    return all;
}

/// The ways that draw a scene with so many lights: those whose lists are the frame's own end early.
std::vector<PictureGrade> paths(std::uint32_t lights) {
    const render::Settings settings = compare_settings({}, "blocks");
    std::vector<PictureGrade> all;
    const auto add = [&](std::string name) {
        all.push_back(
            grade_of(std::move(name), render::k_lighting_parameters, &render::Settings::lighting, settings));
    };
    if (lights <= k_most_unculled_lights) {
        add("fullscreen");
        add("volumes");
        add("volumes:volume=solid");
    }
    add("clustered");
    add("tiled");
    add("tiled:prepass=1");
    add("forward");
    add("forward:prepass=1");
    all.push_back(grade_of("wide", render::k_gbuffer_parameters, &render::Settings::gbuffer, settings));
    all.back().name = "tiled, --gbuffer wide";
    return all;
}

/// Reflection grades of the usual path.
std::vector<PictureGrade> reflections() {
    std::vector<PictureGrade> all;
    for (const std::string_view name : render::k_brdf_models)
        all.push_back(grade_of(std::string{name}, render::k_brdf_parameters, &render::Settings::brdf,
                               compare_settings({}, "blocks")));
    return all;
}

/// Errors do not depend on the size: they are looked at where every light at every pixel can be waited for.
bool is_checked(const Case& what) {
    constexpr std::uint64_t k_most_sums = 40'000'000;
    return what.size_px.x <= k_checked_width_px &&
           std::uint64_t{what.size_px.x} * what.size_px.y * what.lights <= k_most_sums;
}

Measured measure(StudyContext& context, const Case& what, std::vector<PictureGrade> grades,
                 const std::string& scene, StudyResult& result) {
    Stage stage = blocks_with_lights(what.lights, what.suns);
    const auto processed = show(context, stage);
    const std::uint32_t rounds = context.rounds(k_rounds);
    const auto eye = [&](std::uint32_t round) {
        return eye_of(stage, what.view, static_cast<double>(round) / rounds, what.size_px);
    };
    Measured measured{.what = what, .grades = std::move(grades), .costs = {}};
    measured.costs = draw_in_turns(context, stage, measured.grades, eye, rounds, "lighting: " + scene);
    std::optional<LightingReference> reference;
    if (is_checked(what) && !context.stopped()) reference.emplace(stage, *processed, eye(0));
    for (std::size_t i = 0; i < measured.costs.size(); ++i) {
        GradeResult grade{.scene = scene, .grade = measured.grades[i].name};
        grade.ms = sums_ms(measured.costs[i], k_surfaces);
        grade.bytes = transient_bytes(measured.costs[i]);
        if (reference) grade.metrics = reference->error_of(context, stage, measured.grades[i]);
        result.grades.push_back(std::move(grade));
    }
    return measured;
}

/// Pass by pass, a column for each way.
Table pass_table(const Measured& measured) {
    Table table{.title = "Milliseconds by pass: " + scene_text(measured.what), .head = {"pass"}, .rows = {}};
    std::vector<PassMs> ms;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < measured.costs.size(); ++i) {
        table.head.push_back(measured.grades[i].name);
        ms.push_back(pass_ms(measured.costs[i]));
        for (const auto& [name, median_ms] : ms.back())
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const std::string& name : names) {
        std::vector<std::string>& row = table.rows.emplace_back();
        row.push_back(name);
        for (const PassMs& of_grade : ms)
            row.push_back(ms_text(of_grade, name));
    }
    return table;
}

/// Median over the rounds of a / b: rounds show the same picture both ways.
double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (b[i] > 0.0) ratios.push_back(a[i] / b[i]);
    return median(ratios);
}

/// How much of each path's time `tiled` needs: of the lighting alone, and from geometry to lit pixels.
Table ratio_table(const std::vector<Measured>& all) {
    Table table{
        .title =
            "Times of the other paths as multiples of tiled's: lighting with the building of its "
            "lists, and geometry with lighting",
        .head = {"scene", "fullscreen, lighting", "volumes, lighting", "clustered, lighting", "forward, all",
                 "forward:prepass=1, all", "tiled:prepass=1, all", "tiled, --gbuffer wide, all"},
        .rows = {}};
    for (const Measured& measured : all) {
        const PictureCost* const tiled = measured.cost_of("tiled");
        std::vector<std::string> row{scene_text(measured.what)};
        const auto add = [&](std::string_view grade, std::span<const std::string_view> passes) {
            const PictureCost* const other = measured.cost_of(grade);
            row.push_back(
                other == nullptr || tiled == nullptr
                    ? std::string{"–"}
                    : fmt::format("{:.2f}", median_ratio(sums_ms(*other, passes), sums_ms(*tiled, passes))));
        };
        add("fullscreen", k_lighting);
        add("volumes", k_lighting);
        add("clustered", k_lighting);
        add("forward", k_surfaces);
        add("forward:prepass=1", k_surfaces);
        add("tiled:prepass=1", k_surfaces);
        add("tiled, --gbuffer wide", k_surfaces);
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// The claim that the culled path is judged by.
std::optional<Table> verdict(const std::vector<Measured>& all) {
    for (const Measured& measured : all) {
        const Case& what = measured.what;
        const bool meant = what.view == View::above && what.size_px == k_usual_size_px &&
                           what.lights == k_usual_lights && what.suns == 1;
        const PictureCost* const tiled = measured.cost_of("tiled");
        const PictureCost* const fullscreen = measured.cost_of("fullscreen");
        if (!meant || tiled == nullptr || fullscreen == nullptr) continue;
        const double gain = median_ratio(sums_ms(*fullscreen, k_lighting), sums_ms(*tiled, k_lighting));
        return Table{.title = "Target",
                     .head = {"what", "wanted", "found", "verdict"},
                     .rows = {{"lighting of fullscreen / of tiled, " + scene_text(what),
                               fmt::format("≥ {:.1f}", k_wanted_of_tiled), fmt::format("{:.2f}", gain),
                               gain >= k_wanted_of_tiled ? "holds" : "missed"}}};
    }
    return std::nullopt;
}

double median_surfaces_ms(const Measured& measured, std::string_view grade) {
    const PictureCost* const cost = measured.cost_of(grade);
    return cost == nullptr ? 0.0 : median(sums_ms(*cost, k_surfaces));
}

bool is_plain(const Case& what) {
    return what.view == View::above && what.suns == 1;
}

/// Fahlén 2005, figure 7.2: deferred and forward shading against resolution.
Plot against_resolution(const std::vector<Measured>& all) {
    Plot plot{.title = fmt::format("Deferred and forward shading, {} lights, from above", k_usual_lights),
              .x_label = "megapixels",
              .y_label = "geometry and lighting, ms",
              .series = {}};
    for (const std::string_view grade : {"tiled", "tiled:prepass=1", "forward", "forward:prepass=1"}) {
        Series series{.name = std::string{grade}, .points = {}, .line = true};
        for (const Measured& measured : all) {
            if (!is_plain(measured.what) || measured.what.lights != k_usual_lights) continue;
            const glm::uvec2 size_px = measured.what.size_px;
            series.points.emplace_back(1e-6 * size_px.x * size_px.y, median_surfaces_ms(measured, grade));
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

Plot against_lights(const std::vector<Measured>& all, glm::uvec2 size_px) {
    Plot plot{.title = fmt::format("Lighting paths by number of lights, {}, from above", size_text(size_px)),
              .x_label = "lights",
              .y_label = "geometry and lighting, ms",
              .x_log = true,
              .y_log = true,
              .series = {}};
    for (const std::string_view grade :
         {"fullscreen", "volumes", "clustered", "tiled", "forward", "forward:prepass=1"}) {
        Series series{.name = std::string{grade}, .points = {}, .line = true};
        for (const Measured& measured : all) {
            const double ms = median_surfaces_ms(measured, grade);
            if (is_plain(measured.what) && measured.what.size_px == size_px && ms > 0.0)
                series.points.emplace_back(measured.what.lights, ms);
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

void conclude(const std::vector<Measured>& all, StudyResult& result) {
    if (all.empty()) return;
    std::set<std::pair<std::uint32_t, std::uint32_t>> sizes;
    for (const Measured& measured : all)
        sizes.emplace(measured.what.size_px.x, measured.what.size_px.y);
    result.plots.push_back(against_resolution(all));
    for (const auto& [width, height] : sizes)
        result.plots.push_back(against_lights(all, {width, height}));
    if (std::optional<Table> found = verdict(all)) result.tables.push_back(std::move(*found));
    result.tables.push_back(ratio_table(all));
    for (const Measured& measured : all)
        result.tables.push_back(pass_table(measured));
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Lighting paths";
    result.question =
        "What does each way to find the lights of a pixel cost, by number of lights and size of the picture, "
        "and where does deferred shading win over forward shading? Milliseconds are those from geometry to "
        "lit pixels: depth pre-pass, G-buffer, shadow look-up, light lists and lighting.";
    result.reference =
        "Sun and lamps without shadows, computed on the CPU in double precision at the places that a ray "
        "through each pixel's middle hits, with every light at every pixel. What errors there are come from "
        "what the G-buffer and half floats drop: all paths show the same. Pixels on silhouettes and of the "
        "sky do not count.";
    result.plotted_metric = "flip_mean";
    std::vector<Measured> all;
    for (const Case& what : cases(context)) {
        if (context.stopped()) break;
        Measured measured = measure(context, what, paths(what.lights), scene_text(what), result);
        if (!measured.costs.empty()) all.push_back(std::move(measured));
    }
    conclude(all, result);
    if (context.stopped()) return;
    const Case brdf{.size_px = context.sizes({k_brdf_size_px}).front(), .lights = k_usual_lights};
    static_cast<void>(
        measure(context, brdf, reflections(), "reflection (--brdf), " + scene_text(brdf), result));
}

}  // namespace

const Study k_lighting_study{
    .name = "lighting", .summary = "lighting paths by lights and size, deferred against forward", .run = run};

}  // namespace rambla::game::study
