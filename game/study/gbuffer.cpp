// Layouts of the G-buffer: what they cost, and how far what lighting reads is from what was drawn.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

#include "game/statistics.h"
#include "game/study/frame_tracer.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/pass_ms.h"
#include "game/study/surface_errors.h"
#include "systems/pipeline.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 5;
constexpr std::uint32_t k_error_pictures = 2;

constexpr std::array<std::string_view, 1> k_written{"gbuffer"};
/// Writing it, and all that reads it.
constexpr std::array<std::string_view, 5> k_written_and_read{"gbuffer", "shadow result", "light tiles",
                                                             "lighting", "light volumes"};

std::vector<PictureGrade> grades(const render::Settings& settings) {
    std::vector<PictureGrade> all;
    for (const std::string_view layout : render::k_gbuffer_layouts)
        all.push_back(grade_of(std::string{layout}, render::k_gbuffer_parameters, &render::Settings::gbuffer,
                               settings));
    return all;
}

/// @return  metrics for each of the grades
std::vector<std::vector<Metric>> errors(StudyContext& context, Stage& stage,
                                        const assets::ProcessedScene& processed, const EyeOfRound& eye,
                                        std::uint32_t pictures) {
    render::Settings flat = plain_settings();  // normal maps tilt what the triangles have
    flat.detail.grade = render::DetailGrade::flat;
    const std::vector<PictureGrade> all = grades(flat);
    std::vector<SurfaceErrors> found(all.size());
    for (std::uint32_t picture = 0; picture < pictures && !context.stopped(); ++picture) {
        systems::Frame frame;
        systems::build_frame(*stage.world, eye(picture), 1.0f, frame);
        const FrameTracer traced{frame, *stage.scene, processed};
        const assets::HitPicture seen = assets::trace_picture(traced.tracer(), traced.camera());
        for (std::size_t i = 0; i < all.size(); ++i) {
            const render::FrameOutput drawn =
                draw(context.thread(), stage, all[i], eye(picture), {.objects = true, .surfaces = true});
            found[i].add(seen, drawn.objects.value(), drawn.surfaces.value());
        }
    }
    std::vector<std::vector<Metric>> metrics(all.size());
    for (std::size_t i = 0; i < all.size() && !context.stopped(); ++i)
        metrics[i] = found[i].metrics();
    return metrics;
}

/// A line of the plot of time against resolution.
Series& line_of(Plot& plot, const std::string& name) {
    for (Series& series : plot.series)
        if (series.name == name) return series;
    return plot.series.emplace_back(Series{.name = name, .points = {}, .line = true});
}

double bytes_written(const PictureCost& cost) {
    std::uint64_t most = 0;
    for (const systems::Feedback& feedback : cost.rounds)
        for (const systems::PassTiming& pass : feedback.passes)
            if (pass.name == k_written.front()) most = std::max(most, pass.bytes_written);
    return static_cast<double>(most);
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "G-buffer";
    result.question =
        "What does the compact G-buffer (12 bytes a pixel, or 16 with emission, and positions from depth) "
        "gain over the wide one of half floats (36 or 40 bytes), and what does it lose? Milliseconds are "
        "those of writing and reading it: G-buffer, shadow look-up and lighting. Bytes are those that the "
        "pass writes.";
    result.reference =
        "Places and normals in double precision where a ray through each pixel's middle meets the triangles "
        "of the same frame, without normal maps. Pixels at the rim of an object or at a step in depth "
        "are left out: there, ray and rasteriser may rightly meet two surfaces. So are those that "
        "other_surface_pct and broken_pct count, which show another surface or none that is finite.";
    result.plotted_metric = "position_p99_mm";
    Stage stage = make_stage("street", context.options().seed, {}, {});
    const auto processed = show(context, stage);
    const std::uint32_t rounds = context.rounds(k_rounds);
    const std::vector<PictureGrade> all = grades(plain_settings());
    // Fahlén 2005, figure 7.1: the pass grows with the number of pixels.
    Plot against_resolution{.title = "Time of the G-buffer pass and of all that reads it, by resolution",
                            .x_label = "megapixels",
                            .y_label = "ms",
                            .series = {}};
    for (const glm::uvec2 size_px : context.sizes({{480, 270}, {960, 540}, {1280, 720}, {1920, 1080}})) {
        if (context.stopped()) break;
        const std::string scene = fmt::format("street, {}", size_text(size_px));
        const EyeOfRound eye = along_the_walk(stage, size_px, rounds);
        const std::vector<PictureCost> costs =
            draw_in_turns(context, stage, all, eye, rounds, "gbuffer: " + scene);
        const auto metrics = errors(context, stage, *processed, eye, std::min(rounds, k_error_pictures));
        for (std::size_t i = 0; i < costs.size(); ++i) {
            result.grades.push_back({.scene = scene,
                                     .grade = all[i].name,
                                     .ms = sums_ms(costs[i], k_written_and_read),
                                     .bytes = bytes_written(costs[i]),
                                     .metrics = metrics[i]});
            const double megapixels = 1e-6 * size_px.x * size_px.y;
            line_of(against_resolution, all[i].name + ", written")
                .points.emplace_back(megapixels, median(sums_ms(costs[i], k_written)));
            line_of(against_resolution, all[i].name + ", written and read")
                .points.emplace_back(megapixels, median(sums_ms(costs[i], k_written_and_read)));
            result.tables.push_back(cost_table(fmt::format("Passes, {}: {}", all[i].name, scene), costs[i]));
        }
    }
    result.plots.push_back(std::move(against_resolution));
}

}  // namespace

const Study k_gbuffer_study{.name = "gbuffer",
                            .summary = "compact and wide G-buffers: time, bytes, positions and normals",
                            .run = run};

}  // namespace rambla::game::study
