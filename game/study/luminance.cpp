// Ways to take a picture's average luminance, and exposure that follows it.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "game/statistics.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/light_step.h"
#include "game/study/picture.h"
#include "render/post/picture_reference.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr std::uint32_t k_moves = 12;  ///< of the eye, within one pixel
constexpr std::uint32_t k_quick_moves = 3;
constexpr std::array<std::string_view, 4> k_grades{"auto:luminance=chain", "auto:luminance=compute",
                                                   "auto:luminance=mips", "auto:luminance=mips16"};
constexpr std::array<std::string_view, 1> k_passes{"luminance"};

struct Hour {
    std::string_view name;
    assets::TimeOfDay time;
};
const std::array<Hour, 3> k_hours{{{"noon", {}}, {"dusk", assets::k_dusk}, {"night", assets::k_night}}};

std::vector<PictureGrade> grades() {
    std::vector<PictureGrade> all;
    for (const std::string_view name : k_grades)
        all.push_back(grade_of(std::string{name}, render::k_exposure_parameters, &render::Settings::exposure,
                               plain_settings()));
    return all;
}

/// Averages of some pictures, in double precision and as each grade finds them.
struct Averages {
    std::vector<double> reference;
    std::vector<std::vector<double>> found;  ///< by grade
};

double average_of(const assets::Image& linear, float exposure_ev, double delta) {
    Picture picture = to_picture(linear);
    for (glm::vec3& texel : picture.texels)
        texel *= std::exp2(exposure_ev);
    return render::log_average_luminance(picture.texels, delta);
}

Averages look(StudyContext& context, Stage& stage, std::span<const PictureGrade> all, const EyeOfRound& eye,
              std::uint32_t pictures) {
    Averages averages;
    averages.found.resize(all.size());
    for (std::uint32_t picture = 0; picture < pictures && !context.stopped(); ++picture) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool first = i == 0;  // all draw the same light
            const render::FrameOutput drawn =
                draw(context.thread(), stage, all[i], eye(picture), {.linear = first});
            averages.found[i].push_back(drawn.feedback.exposure.average_luminance);
            if (!first) continue;
            const auto delta = static_cast<double>(all[i].settings.exposure.delta);
            averages.reference.push_back(average_of(drawn.linear.value(), stage.exposure_ev, delta));
        }
    }
    return averages;
}

/// Looks that differ by less than a pixel, in a spiral.
EyeOfRound within_a_pixel(const systems::Eye& eye) {
    return [eye](std::uint32_t move) {
        const float share = static_cast<float>(move) / static_cast<float>(k_moves);
        const float pixel_rad = eye.vertical_fov_rad / static_cast<float>(eye.size_px.y);
        systems::Eye moved = eye;
        moved.rotation = moved.rotation *
                         glm::angleAxis(share * pixel_rad * std::cos(5.0f * share), glm::vec3{0, 1, 0}) *
                         glm::angleAxis(share * pixel_rad * std::sin(5.0f * share), glm::vec3{1, 0, 0});
        return moved;
    };
}

/// From the least to the most, as a share of the mean.
double spread_pct(const std::vector<double>& values) {
    if (values.empty()) return 0.0;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return 100.0 * (*high - *low) * static_cast<double>(values.size()) / sum;
}

std::vector<double> ratios(const std::vector<double>& found, const std::vector<double>& reference) {
    std::vector<double> all;
    for (std::size_t i = 0; i < found.size(); ++i)
        all.push_back(found[i] / reference[i]);
    return all;
}

double worst_error_pct(const std::vector<double>& found, const std::vector<double>& reference) {
    double worst = 0.0;
    for (const double ratio : ratios(found, reference))
        worst = std::max(worst, 100.0 * std::fabs(ratio - 1.0));
    return worst;
}

double bytes_written(const PictureCost& cost) {
    std::uint64_t most = 0;
    for (const systems::Feedback& feedback : cost.rounds) {
        std::uint64_t sum = 0;
        for (const systems::PassTiming& pass : feedback.passes)
            if (pass.name == k_passes.front()) sum += pass.bytes_written;
        most = std::max(most, sum);
    }
    return static_cast<double>(most);
}

void measure(StudyContext& context, Stage& stage, const std::string& scene, glm::uvec2 size_px,
             StudyResult& result) {
    const std::vector<PictureGrade> all = grades();
    const std::uint32_t rounds = context.rounds(k_rounds);
    const EyeOfRound walk = along_the_walk(stage, size_px, rounds);
    const std::vector<PictureCost> costs =
        draw_in_turns(context, stage, all, walk, rounds, "luminance: " + scene);
    const std::uint32_t moves = context.options().quick ? k_quick_moves : k_moves;
    const Averages far = look(context, stage, all, walk, rounds);
    const Averages near = look(context, stage, all, within_a_pixel(walk(0)), moves);
    if (context.stopped()) return;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        result.grades.push_back(
            {.scene = scene,
             .grade = all[i].name,
             .ms = sums_ms(costs[i], k_passes),
             .bytes = bytes_written(costs[i]),
             .metrics = {{"error_worst_pct", worst_error_pct(far.found[i], far.reference), "%"},
                         {"spread_pct", spread_pct(near.found[i]), "%"},
                         {"own_spread_pct", spread_pct(ratios(near.found[i], near.reference)), "%"}}});
    }
}

/// The same view at each hour, as the light wants it and as it is adapted to.
void show_hours(StudyContext& context, std::span<const Hour> hours, glm::uvec2 size_px, StudyResult& result) {
    Table table{.title = "Automatic exposure along the street's walk: departure in EV",
                .head = {"time", "least", "most"},
                .rows = {}};
    for (const Hour& hour : hours) {
        if (context.stopped()) return;
        Stage stage = make_stage("street", context.options().seed, hour.time, {});
        static_cast<void>(show(context, stage));
        const std::uint32_t views = context.rounds(k_rounds);
        const EyeOfRound eye = along_the_walk(stage, size_px, views);
        std::vector<double> departures;
        for (std::uint32_t view = 0; view < views; ++view) {
            PictureRow row{.title = fmt::format("The street at {}", hour.name), .pictures = {}};
            for (const char* name : {"fixed", "auto"}) {
                const PictureGrade grade = grade_of(name, render::k_exposure_parameters,
                                                    &render::Settings::exposure, plain_settings());
                render::FrameOutput drawn =
                    draw(context.thread(), stage, grade, eye(view), {.display = true});
                if (drawn.feedback.exposure.known) departures.push_back(drawn.feedback.exposure.departure_ev);
                row.pictures.push_back({name, std::move(drawn.display.value())});
            }
            if (view == 0 || view + 1 == views) result.pictures.push_back(std::move(row));
        }
        const auto [least, most] = std::minmax_element(departures.begin(), departures.end());
        table.rows.push_back(
            {std::string{hour.name}, fmt::format("{:+.2f}", *least), fmt::format("{:+.2f}", *most)});
    }
    result.tables.push_back(std::move(table));
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Average luminance and automatic exposure";
    result.question =
        "What does the log-average luminance of a picture cost by each method, how exact is it, and how "
        "still "
        "while the eye moves within a pixel? And how does exposure follow the light? Milliseconds are those "
        "of taking the average; bytes are those that this writes, but for mip levels beyond the first.";
    result.reference =
        "The log-average in double precision over the very scene light that was drawn. spread_pct is how far "
        "averages of looks within one pixel lie apart, own_spread_pct what the method adds to what the "
        "pictures themselves differ by. Exposure is held against the exponential in closed form.";
    result.plotted_metric = "error_worst_pct";
    const std::span<const Hour> hours =
        std::span{k_hours}.first(context.options().quick ? 1 : k_hours.size());
    Stage stage = make_stage("street", context.options().seed, {}, {});
    static_cast<void>(show(context, stage));
    // No side of the second is a multiple of two.
    for (const glm::uvec2 size_px : context.sizes({{1280, 720}, {1279, 719}, {640, 360}})) {
        if (context.stopped()) return;
        measure(context, stage, fmt::format("street, {}", size_text(size_px)), size_px, result);
    }
    follow_light_steps(context, stage, "auto", result);
    if (!context.options().quick) follow_light_steps(context, stage, "auto:strength=1,range=10", result);
    show_hours(context, hours, context.sizes({{640, 360}}).front(), result);
}

}  // namespace

const Study k_luminance_study{
    .name = "luminance", .summary = "average luminance and automatic exposure", .run = run};

}  // namespace rambla::game::study
