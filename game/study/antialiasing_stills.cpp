#include "game/study/antialiasing_stills.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "game/study/antialiasing_grades.h"
#include "game/study/geometric_edges.h"
#include "game/study/metrics/flip.h"
#include "game/study/metrics/psnr.h"
#include "game/study/metrics/smoothing.h"
#include "game/study/picture_error.h"
#include "game/study/picture_part.h"

namespace rambla::game::study {
namespace {

/// Eyes whose pictures are compared: the reference of each takes 64 pictures' time.
constexpr std::uint32_t k_compared_eyes = 3;
constexpr std::uint32_t k_reference_samples = 8;
/// Four pixels for one: finds what is half as thin as a pixel.
constexpr std::uint32_t k_edge_samples = 2;
/// A pixel that an edge crosses, its neighbours, and what a method blends into those.
constexpr double k_edges_within_px = 1.5;
constexpr double k_textures_beyond_px = 3.0;
constexpr glm::uvec2 k_part_px{160, 120};
constexpr std::uint32_t k_enlarged = 3;

/// What one eye should see.
struct Expected {
    assets::Image image;
    Picture picture;
    PixelRegions regions;
};

assets::Image display_of(StudyContext& context, Stage& stage, const PictureGrade& grade,
                         const systems::Eye& eye) {
    return draw(context.thread(), stage, grade, eye, {.display = true}).display.value();
}

Expected expected_at(StudyContext& context, Stage& stage, const systems::Eye& eye) {
    Expected expected;
    expected.image = display_of(context, stage, supersampled(context, k_reference_samples), eye);
    expected.picture = to_picture(expected.image);
    const render::FrameOutput bare = draw(context.thread(), stage, bare_surfaces(context, k_edge_samples),
                                          eye, {.objects = true, .surfaces = true});
    const std::uint32_t samples = bare.objects.value().width / expected.image.width;
    const std::vector<std::uint8_t> edges =
        geometric_edges(bare.objects.value(), bare.surfaces.value(), samples);
    expected.regions = pixel_regions({expected.image.width, expected.image.height}, edges, k_edges_within_px,
                                     k_textures_beyond_px);
    return expected;
}

double lost_pct(double left, double of) {
    return of > 0.0 ? 100.0 * (1.0 - left / of) : 0.0;
}

std::vector<Metric> metrics_of(const Expected& expected, const Picture& plain, const Picture& test) {
    const PixelRegions& regions = expected.regions;
    const Flip flip = ldr_flip(expected.picture, test);
    const double contrast = local_contrast(test, regions.textures);
    return {
        {"edge_rms_pct", 100.0 * rms_display(expected.picture, test, regions.edges), "%"},
        {"edge_flip", mean_within(flip.map, regions.edges), ""},
        {"texture_rms_pct", 100.0 * rms_display(expected.picture, test, regions.textures), "%"},
        {"contrast_lost_pct", lost_pct(contrast, local_contrast(expected.picture, regions.textures)), "%"},
        {"contrast_lost_of_none_pct", lost_pct(contrast, local_contrast(plain, regions.textures)), "%"},
        {"flip_mean", flip.mean, ""},
        {"psnr_db", psnr_db(expected.picture, test), "dB"}};
}

/// Corner of the part where the picture without anti-aliasing is most wrong within the region that is shown.
glm::uvec2 shown_corner(const Expected& expected, const assets::Image& plain, Stills::Shown shown) {
    const PixelRegions& regions = expected.regions;
    const std::vector<std::uint8_t>& region =
        shown == Stills::Shown::edges ? regions.edges : regions.textures;
    constexpr std::size_t k_texel = 4;
    assets::Image within = expected.image;
    for (std::size_t i = 0; i < region.size(); ++i)
        if (region[i] != 0)
            std::copy_n(plain.texels.begin() + static_cast<std::ptrdiff_t>(k_texel * i), k_texel,
                        within.texels.begin() + static_cast<std::ptrdiff_t>(k_texel * i));
    return most_different_part(expected.image, within, k_part_px);
}

using MetricsOfEyes = std::vector<std::vector<Metric>>;

/// Compares the pictures of one eye; shows parts of them if `row` is there.
void compare(StudyContext& context, Stage& stage, const systems::Eye& eye,
             const std::vector<PictureGrade>& grades, Stills::Shown shown, PictureRow* row,
             std::vector<MetricsOfEyes>& metrics) {
    const Expected expected = expected_at(context, stage, eye);
    Picture plain;
    glm::uvec2 corner{0};
    const auto show_part = [&](std::string label, const assets::Image& image) {
        if (row != nullptr)
            row->pictures.push_back(
                {std::move(label), enlarged(part_of(image, corner, k_part_px), k_enlarged)});
    };
    for (std::size_t i = 0; i < grades.size() && !context.stopped(); ++i) {
        const assets::Image image = display_of(context, stage, grades[i], eye);
        const Picture picture = to_picture(image);
        if (i == 0) {
            plain = picture;
            corner = shown_corner(expected, image, shown);
            show_part(fmt::format("reference, ssaa:samples={}", k_reference_samples), expected.image);
        }
        metrics[i].push_back(metrics_of(expected, plain, picture));
        show_part(grades[i].name, image);
    }
}

std::string title_of(const Stills& stills) {
    const bool edges = stills.shown == Stills::Shown::edges;
    return fmt::format("{}, {} times as large: {}", edges ? "Edges" : "Textures", k_enlarged, stills.scene);
}

}  // namespace

void measure_stills(StudyContext& context, Stage& stage, const Stills& stills, StudyResult& result) {
    const std::uint32_t rounds = stills.rounds;
    const std::vector<PictureCost> costs =
        draw_in_turns(context, stage, antialiasing_grades(context, Past::moment), stills.eye, rounds,
                      "antialiasing: " + stills.scene);
    if (costs.empty()) return;
    const std::vector<PictureGrade> grades = antialiasing_grades(context, Past::settled);
    std::vector<MetricsOfEyes> metrics(grades.size());
    PictureRow row{.title = title_of(stills), .pictures = {}};
    const std::uint32_t eyes = context.options().quick ? 1 : std::min(rounds, k_compared_eyes);
    for (std::uint32_t i = 0; i < eyes && !context.stopped(); ++i)
        compare(context, stage, stills.eye(i * rounds / eyes), grades, stills.shown, i == 0 ? &row : nullptr,
                metrics);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        GradeResult grade{.scene = stills.scene, .grade = grades[i].name};
        grade.ms = antialiasing_ms(costs[i], costs.front());
        grade.bytes = transient_bytes(costs[i]);
        grade.metrics = mean_metrics(metrics[i]);
        for (Metric& metric : cost_metrics(costs[i], costs.front()))
            grade.metrics.push_back(std::move(metric));
        result.grades.push_back(std::move(grade));
    }
    if (!row.pictures.empty()) result.pictures.push_back(std::move(row));
}

}  // namespace rambla::game::study
