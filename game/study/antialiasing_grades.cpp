#include "game/study/antialiasing_grades.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>

#include "game/statistics.h"
#include "game/study/grades.h"

namespace rambla::game::study {
namespace {

constexpr double k_mib = 1024.0 * 1024.0;
/// The renderer's pools have let go by then of what nothing asks for.
constexpr std::uint32_t k_frames_to_hold_nothing_else = 10;
constexpr std::uint32_t k_moment_frames = 2;
/// Of a history that keeps 0.95 each time 4 % are left then.
constexpr std::uint32_t k_settling_frames = 64;
constexpr std::uint32_t k_quick_settling_frames = 4;

constexpr std::array<std::string_view, 13> k_grades{"none",
                                                    "sobel:of=colour",
                                                    "sobel:of=depth",
                                                    "edges",
                                                    "fxaa:quality=low",
                                                    "fxaa:quality=medium",
                                                    "fxaa:quality=high",
                                                    "morphological:quality=low",
                                                    "morphological:quality=medium",
                                                    "morphological:quality=high",
                                                    "taa",
                                                    "ssaa:samples=2",
                                                    "ssaa:samples=4"};

/// Glow is measured in pixels that are drawn, and exposure follows earlier pictures: with either, methods
/// would differ by more than their edges. A shadow map takes longer than all else of a small picture.
render::Settings settings(const StudyContext& context) {
    render::Settings settings;
    settings.bloom.method = render::BloomMethod::off;
    settings.exposure.mode = render::ExposureMode::fixed;
    if (context.options().quick) settings.shadows.method = render::ShadowMethod::off;
    return settings;
}

PictureGrade named(const StudyContext& context, std::string name) {
    return grade_of(std::move(name), render::k_anti_aliasing_parameters, &render::Settings::anti_aliasing,
                    settings(context));
}

std::uint32_t frames_of(Past past, bool quick) {
    if (past == Past::moment) return k_moment_frames;
    return quick ? k_quick_settling_frames : k_settling_frames;
}

const systems::PassTiming* find(const systems::Feedback& feedback, std::string_view name) {
    const auto found = std::find_if(feedback.passes.begin(), feedback.passes.end(),
                                    [&](const systems::PassTiming& pass) { return pass.name == name; });
    return found == feedback.passes.end() ? nullptr : &*found;
}

double round_ms(const systems::Feedback& with, const systems::Feedback& without) {
    double ms = 0.0;
    for (const systems::PassTiming& pass : with.passes) {
        const systems::PassTiming* const before = find(without, pass.name);
        if (before == nullptr) {
            ms += pass.gpu_ms;
        } else if (pass.bytes_written > before->bytes_written) {
            ms += pass.gpu_ms - before->gpu_ms;
        }
    }
    return std::max(ms, 0.0);
}

}  // namespace

std::vector<PictureGrade> antialiasing_grades(const StudyContext& context, Past past) {
    std::vector<PictureGrade> all;
    for (const std::string_view name : k_grades) {
        all.push_back(named(context, std::string{name}));
        if (all.back().settings.anti_aliasing.method == render::AntiAliasing::taa)
            all.back().frames_before = frames_of(past, context.options().quick);
    }
    return all;
}

PictureGrade supersampled(const StudyContext& context, std::uint32_t samples) {
    return named(context, fmt::format("ssaa:samples={}", samples));
}

PictureGrade bare_surfaces(const StudyContext& context, std::uint32_t samples) {
    PictureGrade grade = supersampled(context, samples);
    grade.settings.detail.grade = render::DetailGrade::flat;
    grade.settings.shadows.method = render::ShadowMethod::off;
    return grade;
}

std::vector<double> antialiasing_ms(const PictureCost& cost, const PictureCost& plain) {
    std::vector<double> ms;
    for (std::size_t i = 0; i < std::min(cost.rounds.size(), plain.rounds.size()); ++i)
        ms.push_back(round_ms(cost.rounds[i], plain.rounds[i]));
    return ms;
}

std::vector<Metric> cost_metrics(const PictureCost& cost, const PictureCost& plain) {
    const std::vector<double> own = antialiasing_ms(cost, plain);
    std::vector<double> shares;
    std::vector<double> more;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const double frame_ms = cost.rounds[i].gpu_frame_ms;
        shares.push_back(frame_ms > 0.0 ? 100.0 * own[i] / frame_ms : 0.0);
        more.push_back(frame_ms - plain.rounds[i].gpu_frame_ms);
    }
    return {{"aa_share_pct", median(shares), "%"},
            {"frame_more_ms", median(more), "ms"},
            {"transient_more_mib", (transient_bytes(cost) - transient_bytes(plain)) / k_mib, "MiB"}};
}

Table held_memory(StudyContext& context, Stage& stage, const systems::Eye& eye) {
    Table table{
        .title = "Memory held by the renderer, without the scene's textures: " + size_text(eye.size_px),
        .head = {"grade", "MiB", "more than without anti-aliasing"},
        .rows = {}};
    double without = 0.0;
    for (PictureGrade& grade : antialiasing_grades(context, Past::moment)) {
        grade.frames_before = context.options().quick ? 0 : k_frames_to_hold_nothing_else;
        const systems::Feedback feedback = draw(context.thread(), stage, grade, eye).feedback;
        const double held =
            static_cast<double>(feedback.gpu_memory_bytes - feedback.textures.resident_bytes) / k_mib;
        if (table.rows.empty()) without = held;
        table.rows.push_back(
            {grade.name, fmt::format("{:.1f}", held), fmt::format("{:.1f}", held - without)});
    }
    return table;
}

}  // namespace rambla::game::study
