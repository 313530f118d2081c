// Tone curves: what they cost, how exact they are, and how the street looks in them.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/picture.h"
#include "game/study/picture_error.h"
#include "render/post/picture_reference.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr glm::uvec2 k_size_px{1280, 720};
constexpr glm::uvec2 k_picture_px{640, 360};
/// The first is what others are compared with.
constexpr std::array<std::string_view, 12> k_grades{"aces",
                                                    "reinhard",
                                                    "extended",
                                                    "extended:estimate=1",
                                                    "filmic",
                                                    "agx",
                                                    "aces:on=luminance",
                                                    "filmic:on=luminance",
                                                    "aces:gamma=1.2",
                                                    "aces:blue_shift=1",
                                                    "aces:dither=0",
                                                    "aces:format=r11g11b10f"};
constexpr std::array<std::string_view, 4> k_passes{"luminance", "luminance histogram", "exposure", "tonemap"};

struct Hour {
    std::string_view name;
    assets::TimeOfDay time;
};
const std::array<Hour, 2> k_hours{{{"noon", {}}, {"night", assets::k_night}}};

std::vector<PictureGrade> grades() {
    std::vector<PictureGrade> all;
    for (const std::string_view name : k_grades)
        all.push_back(grade_of(std::string{name}, render::k_tone_parameters, &render::Settings::tone,
                               plain_settings()));
    return all;
}

/// Curve, scale and white that a picture is shown with, in double precision.
struct Formula {
    render::ToneParameters tone;
    double scale = 1.0;
    double white = 1.0;

    Formula(const render::Settings& settings, const Picture& scene)
        : tone{settings.tone}, white{static_cast<double>(tone.white)} {
        if (tone.curve != render::ToneCurve::extended || !tone.estimate) return;
        const auto delta = static_cast<double>(settings.exposure.delta);
        const double average = render::log_average_luminance(scene.texels, delta);
        const auto percentile = [&](double share) {
            return std::max(render::luminance_percentile(scene.texels, share), delta);
        };
        const render::EstimatedCurve curve =
            render::estimate_curve(average, percentile(0.01), percentile(0.99));
        scale = curve.key / average;
        white = curve.white;
    }

    /// In 255ths of what a screen is sent.
    [[nodiscard]] glm::dvec3 shown(const glm::vec3& scene) const {
        const glm::dvec3 light = render::tone_mapped(scale * glm::dvec3{scene}, tone.curve, tone.on, white);
        glm::dvec3 sent{0.0};
        for (int i = 0; i < 3; ++i)
            sent[i] = 255.0 * std::pow(render::srgb_encoded(static_cast<double>(tone.brightness) * light[i]),
                                       1.0 / static_cast<double>(tone.gamma));
        return sent;
    }
};

struct Sample {
    float scene = 0.0f;
    int shown = 0;
};

/// How far what is shown falls, at most, while scene light rises.
double worst_fall(std::vector<Sample> samples) {
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return a.scene < b.scene; });
    int most = 0;
    int worst = 0;
    for (const Sample& sample : samples) {
        worst = std::max(worst, most - sample.shown);
        most = std::max(most, sample.shown);
    }
    return worst;
}

/// A picture of a grade without dither and smoothing, against the formula at each pixel.
std::vector<Metric> errors(StudyContext& context, Stage& stage, const PictureGrade& grade,
                           const systems::Eye& eye) {
    if (grade.settings.tone.blue_shift > 0.0f) return {};  // which no curve is
    PictureGrade plain = grade;
    plain.settings.tone.dither = false;
    plain.settings.anti_aliasing.method = render::AntiAliasing::none;
    const render::FrameOutput drawn =
        draw(context.thread(), stage, plain, eye, {.display = true, .linear = true});
    Picture scene = to_picture(drawn.linear.value());
    for (glm::vec3& texel : scene.texels)
        texel *= std::exp2(stage.exposure_ev);
    const Formula formula{plain.settings, scene};
    const std::vector<std::byte>& bytes = drawn.display->texels;
    std::vector<Sample> samples;
    double worst = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.texels.size(); ++i) {
        const glm::dvec3 expected = formula.shown(scene.texels[i]);
        for (int channel = 0; channel < 3; ++channel) {
            const int shown = std::to_integer<int>(bytes[4 * i + static_cast<std::size_t>(channel)]);
            const double away = std::fabs(shown - expected[channel]);
            worst = std::max(worst, away);
            sum += away;
            samples.push_back({scene.texels[i][channel], shown});
        }
    }
    std::vector<Metric> metrics{{"error_worst_255ths", worst, ""},
                                {"error_mean_255ths", sum / static_cast<double>(samples.size()), ""}};
    const bool by_channel = plain.settings.tone.on == render::ToneOn::channels &&
                            plain.settings.tone.curve != render::ToneCurve::agx;
    if (by_channel) metrics.push_back({"fall_worst_255ths", worst_fall(std::move(samples)), ""});
    return metrics;
}

void measure(StudyContext& context, Stage& stage, std::string_view hour, glm::uvec2 size_px,
             StudyResult& result) {
    const std::string scene = fmt::format("street at {}, {}", hour, size_text(size_px));
    const std::vector<PictureGrade> all = grades();
    const std::uint32_t rounds = context.rounds(k_rounds);
    const EyeOfRound eye = along_the_walk(stage, size_px, rounds);
    const std::vector<PictureCost> costs =
        draw_in_turns(context, stage, all, eye, rounds, "tonemap: " + scene);
    const auto picture = [&](const PictureGrade& grade) {
        return draw(context.thread(), stage, grade, eye(0), {.display = true}).display.value();
    };
    const assets::Image usual = picture(all.front());
    for (std::size_t i = 0; i < costs.size() && !context.stopped(); ++i) {
        GradeResult grade{.scene = scene, .grade = all[i].name};
        grade.ms = sums_ms(costs[i], k_passes);
        grade.bytes = transient_bytes(costs[i]);
        grade.metrics = errors(context, stage, all[i], eye(0));
        grade.metrics.push_back(display_metrics(usual, picture(all[i])).front());
        result.grades.push_back(std::move(grade));
    }
}

void show_curves(StudyContext& context, Stage& stage, std::string_view hour, glm::uvec2 size_px,
                 StudyResult& result) {
    const EyeOfRound eye = along_the_walk(stage, size_px, k_rounds);
    for (const std::uint32_t view : {0u, k_rounds / 2}) {
        PictureRow row{.title = fmt::format("The street at {}", hour), .pictures = {}};
        for (const PictureGrade& grade : grades()) {
            if (context.stopped()) return;
            const render::ToneParameters& tone = grade.settings.tone;
            if (!tone.dither || tone.format != render::SceneColourFormat::rgba16f) continue;  // all alike
            row.pictures.push_back(
                {grade.name,
                 draw(context.thread(), stage, grade, eye(view), {.display = true}).display.value()});
        }
        result.pictures.push_back(std::move(row));
        if (context.options().quick) return;
    }
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Tone mapping";
    result.question =
        "What does each tone curve cost, is what it shows what its formula says, and how does the street "
        "look "
        "in it, at fixed exposure and without bloom? Milliseconds are those of tone mapping and of what "
        "finds "
        "its parameters.";
    result.reference =
        "The formulas of the publications in double precision, at each pixel of the scene light that was "
        "drawn, in 255ths of what a screen is sent: rounding to bytes is up to 0.5 of them. "
        "fall_worst_255ths is how far what is shown falls while light rises, of curves on channels. "
        "flip_mean "
        "is how far the look is from the usual one, aces.";
    result.plotted_metric = "error_mean_255ths";
    for (const Hour& hour : std::span{k_hours}.first(context.options().quick ? 1 : k_hours.size())) {
        Stage stage = make_stage("street", context.options().seed, hour.time, {});
        static_cast<void>(show(context, stage));
        for (const glm::uvec2 size_px : context.sizes({k_size_px})) {
            if (context.stopped()) return;
            measure(context, stage, hour.name, size_px, result);
        }
        show_curves(context, stage, hour.name, context.sizes({k_picture_px}).front(), result);
    }
}

}  // namespace

const Study k_tonemap_study{.name = "tonemap", .summary = "tone curves and their settings", .run = run};

}  // namespace rambla::game::study
