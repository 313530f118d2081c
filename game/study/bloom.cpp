// Ways to spread bright light, against the point-spread function that all of them are fitted to.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "assets/daylight.h"
#include "game/camera_path.h"
#include "game/study/bloom_reference.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/metrics/flip.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr glm::uvec2 k_size_px{1280, 720};
/// Of the pictures whose flicker is measured, at most: each step asks for another exact convolution.
constexpr glm::uvec2 k_flicker_size_px{640, 360};
constexpr std::uint32_t k_flicker_steps = 10;
constexpr std::uint32_t k_quick_flicker_steps = 3;
constexpr std::array<std::string_view, 7> k_grades{"pyramid",
                                                   "pyramid:fireflies=0",
                                                   "dual:fireflies=0",
                                                   "kawase:passes=6,fireflies=0",
                                                   "kawase:passes=10,fireflies=0",
                                                   "iterated:passes=6,fireflies=0",
                                                   "iterated:passes=16,fireflies=0"};

struct View {
    std::string name;
    systems::Eye eye;
};

PictureGrade grade(std::string_view name) {
    render::Settings settings;
    settings.exposure.mode = render::ExposureMode::fixed;  // every grade's picture shall be equally bright
    settings.anti_aliasing.method = render::AntiAliasing::none;
    return grade_of(std::string{name}, render::k_bloom_parameters, &render::Settings::bloom, settings);
}

/// With all the light above the threshold spread, so that the half floats of scene colour, which llvmpipe
/// rounds towards zero, take the least part of what is measured.
PictureGrade strong(PictureGrade how) {
    how.settings.bloom.intensity = 1.0f;
    return how;
}

/// Scene light as tone mapping finds it, split into what was there before bloom and what bloom added.
struct Drawn {
    Picture scene;  ///< exposed
    Picture glow;
    systems::Feedback feedback;
    assets::Image display;
};

Drawn draw_with_glow(StudyContext& context, Stage& stage, const PictureGrade& how, const systems::Eye& eye) {
    render::FrameOutput output =
        draw(context.thread(), stage, how, eye, {.display = true, .linear = true, .glowing = true});
    Drawn drawn{.scene = to_picture(output.linear.value()),
                .glow = to_picture(output.glowing.value()),
                .feedback = std::move(output.feedback),
                .display = std::move(output.display.value())};
    const float exposure = std::exp2(stage.exposure_ev);
    for (std::size_t i = 0; i < drawn.scene.texels.size(); ++i) {
        drawn.scene.texels[i] *= exposure;
        drawn.glow.texels[i] = exposure * drawn.glow.texels[i] - drawn.scene.texels[i];
    }
    return drawn;
}

/// Glow where the scene is dark: there half floats keep what is added to it.
Picture in_the_dark(const Picture& scene, Picture glow) {
    constexpr float k_dark = 0.125f;
    for (std::size_t i = 0; i < scene.texels.size(); ++i) {
        const glm::vec3& light = scene.texels[i];
        if (std::max({light.x, light.y, light.z}) > k_dark) glow.texels[i] = glm::vec3{0.0f};
    }
    return glow;
}

bool is_bloom(const systems::PassTiming& pass) {
    return std::string_view{pass.name}.starts_with("bloom");
}

std::vector<double> bloom_ms(const PictureCost& cost) {
    std::vector<double> ms;
    for (const systems::Feedback& feedback : cost.rounds) {
        double sum = 0.0;
        for (const systems::PassTiming& pass : feedback.passes)
            if (is_bloom(pass)) sum += pass.gpu_ms;
        ms.push_back(sum);
    }
    return ms;
}

/// Most memory that bloom's passes hold at a time beside scene colour.
double bloom_bytes(const systems::Feedback& feedback, glm::uvec2 size_px) {
    constexpr double k_half_float_texel_bytes = 8.0;
    double most = 0.0;
    for (const systems::PassTiming& pass : feedback.passes)
        if (is_bloom(pass)) most = std::max(most, static_cast<double>(pass.memory_bytes));
    return std::max(0.0, most - k_half_float_texel_bytes * size_px.x * size_px.y);
}

/// How much the glow changes while the camera turns by an eighth of a pixel at a time. Surfaces are sampled
/// at pixels' middles, so that what is bright changes by whole pixels: what the exact convolution changes by
/// is not bloom's doing.
struct Flicker {
    double change_pct = 0.0;  ///< largest from picture to picture, of the glow's energy
    double excess_pct = 0.0;  ///< largest beyond what the exact glow changes by
    double energy_pct = 0.0;  ///< largest change of the glow's energy
};

/// What a step finds of a grade and of its reference.
struct FlickerStep {
    Picture found;
    Picture exact;
};

systems::Eye turned(systems::Eye eye, std::uint32_t eighths) {
    const float pixel_rad = 2.0f * std::tan(0.5f * eye.vertical_fov_rad) / static_cast<float>(eye.size_px.y);
    const float angle_rad = 0.125f * static_cast<float>(eighths) * pixel_rad;
    eye.rotation = glm::angleAxis(angle_rad, glm::vec3{0.0f, 1.0f, 0.0f}) * eye.rotation;
    return eye;
}

std::vector<Flicker> flickers(StudyContext& context, Stage& stage, const std::vector<PictureGrade>& grades,
                              systems::Eye eye) {
    const float smaller =
        std::min(1.0f, static_cast<float>(k_flicker_size_px.y) / static_cast<float>(eye.size_px.y));
    eye.size_px = glm::max(glm::uvec2{glm::vec2{eye.size_px} * smaller}, glm::uvec2{1});
    std::vector<Flicker> found(grades.size());
    std::vector<Picture> before(grades.size());
    std::optional<Picture> exact_before;
    const std::uint32_t steps = context.options().quick ? k_quick_flicker_steps : k_flicker_steps;
    for (std::uint32_t step = 0; step < steps && !context.stopped(); ++step) {
        std::optional<Picture> exact;
        for (std::size_t i = 0; i < grades.size(); ++i) {
            const PictureGrade how = strong(grades[i]);
            Drawn drawn = draw_with_glow(context, stage, how, turned(eye, step));
            if (!exact) exact = exact_glow(drawn.scene, how.settings.bloom);
            const double whole = energy(drawn.glow);
            if (exact_before && whole > 0.0) {
                const double changed = change(before[i], drawn.glow) / whole;
                const double inevitable = change(*exact_before, *exact) / energy(*exact);
                Flicker& flicker = found[i];
                flicker.change_pct = std::max(flicker.change_pct, 100.0 * changed);
                flicker.excess_pct = std::max(flicker.excess_pct, 100.0 * (changed - inevitable));
                flicker.energy_pct =
                    std::max(flicker.energy_pct, 100.0 * std::fabs(energy(before[i]) / whole - 1.0));
            }
            before[i] = std::move(drawn.glow);
        }
        exact_before = std::move(exact);
    }
    return found;
}

/// From the middle of the walk, and close up to what lights the picture most.
std::vector<View> views(Stage& stage, glm::uvec2 size_px) {
    systems::Eye eye = along_the_walk(stage, size_px, 2)(1);
    systems::Frame frame;
    systems::build_frame(*stage.world, eye, 1.0f, frame);
    std::vector<View> found{{"street", eye}};
    float brightest = 0.0f;
    glm::vec3 lamp_m{0.0f};
    for (const systems::FrameLight& light : frame.lights) {
        const glm::vec3 in_view = glm::mat3{frame.view.view_from_world} * light.position_m;
        const float distance_m = glm::length(in_view);
        constexpr float k_ahead = 0.9f, k_not_overhead_m = 5.0f;
        if (-in_view.z < k_ahead * distance_m || distance_m < k_not_overhead_m) continue;
        const float illuminance = light.intensity.y / (distance_m * distance_m);
        if (illuminance <= brightest) continue;
        brightest = illuminance;
        lamp_m = light.position_m;
    }
    if (brightest > 0.0f) {
        systems::Eye close = eye;
        close.rotation = look_rotation(glm::vec3{0.0f}, lamp_m);
        constexpr float k_metres_across = 4.0f;
        close.vertical_fov_rad = 2.0f * std::atan(0.5f * k_metres_across / glm::length(lamp_m));
        found.push_back({"lamp", close});
    }
    return found;
}

void measure(StudyContext& context, Stage& stage, const View& view, const std::string& scene,
             StudyResult& result) {
    std::vector<PictureGrade> grades;
    for (const std::string_view name : k_grades)
        grades.push_back(grade(name));
    const std::uint32_t rounds = context.rounds(k_rounds);
    const std::vector<PictureCost> costs = draw_in_turns(
        context, stage, grades, [&](std::uint32_t) { return view.eye; }, rounds, "bloom: " + scene);
    if (costs.empty()) return;
    PictureRow row{.title = scene, .pictures = {}};
    row.pictures.push_back({"off", draw_with_glow(context, stage, grade("off"), view.eye).display});
    const std::vector<Flicker> flicker = flickers(context, stage, grades, view.eye);
    std::optional<Picture> exact;
    for (std::size_t i = 0; i < grades.size() && !context.stopped(); ++i) {
        Drawn drawn = draw_with_glow(context, stage, grades[i], view.eye);
        const Drawn strongest = draw_with_glow(context, stage, strong(grades[i]), view.eye);
        if (!exact) exact = exact_glow(drawn.scene, strong(grades[i]).settings.bloom);
        const Picture expected = in_the_dark(drawn.scene, *exact),
                      found = in_the_dark(drawn.scene, strongest.glow);
        const double whole = energy(expected);
        const Picture exact_shown = sum_of(drawn.scene, scaled(*exact, grades[i].settings.bloom.intensity));
        result.grades.push_back(
            {.scene = scene,
             .grade = grades[i].name,
             .ms = bloom_ms(costs[i]),
             .bytes = bloom_bytes(drawn.feedback, view.eye.size_px),
             .metrics = {{"flip_mean", hdr_flip(exact_shown, sum_of(drawn.scene, drawn.glow)).mean, ""},
                         {"glow_rms_error_pct", relative_rms_pct(expected, found), "%"},
                         {"energy_pct", whole > 0.0 ? 100.0 * energy(found) / whole : 100.0, "%"},
                         {"flicker_pct", flicker[i].change_pct, "%"},
                         {"flicker_excess_pct", flicker[i].excess_pct, "%"},
                         {"flicker_energy_pct", flicker[i].energy_pct, "%"}}});
        row.pictures.push_back({grades[i].name, std::move(drawn.display)});
    }
    row.pictures.push_back(
        {"corona", draw_with_glow(context, stage, grade("pyramid:corona=1"), view.eye).display});
    result.pictures.push_back(std::move(row));
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Bloom";
    result.question =
        "How near do the ways to spread bright light come to one point-spread function, what do they cost, "
        "and does "
        "their glow flicker as the camera turns by an eighth of a pixel at a time? Milliseconds and bytes "
        "are those of "
        "bloom's own passes.";
    result.reference =
        "The light above the threshold of the same picture, convolved in double precision with the mean of "
        "four "
        "Gaussians of 24, 48, 96 and 192 pixels. glow_rms_error_pct and energy_pct compare what bloom adds "
        "at "
        "intensity=1 where the scene is dark, flip_mean (HDR) the pictures with it at the usual intensity. "
        "With "
        "fireflies=1 lone bright pixels count less than in the reference, on purpose. flicker_pct is the "
        "largest "
        "change of the glow from picture to picture, in percent of its energy; flicker_excess_pct leaves out "
        "what "
        "the exact glow of the same pictures changes by, which is what sampling bright surfaces at pixels "
        "does.";
    result.plotted_metric = "glow_rms_error_pct";
    Stage stage = make_stage("street", context.options().seed, assets::k_night, {});
    static_cast<void>(show(context, stage));
    for (const glm::uvec2 size_px : context.sizes({k_size_px})) {
        for (const View& view : views(stage, size_px)) {
            if (context.stopped()) return;
            measure(context, stage, view, fmt::format("{} at night, {}", view.name, size_text(size_px)),
                    result);
        }
    }
}

}  // namespace

const Study k_bloom_study{
    .name = "bloom", .summary = "ways to spread bright light, and whether they flicker", .run = run};

}  // namespace rambla::game::study
