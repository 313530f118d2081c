#include "game/compare.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "game/progress.h"
#include "game/scene_cache.h"
#include "game/statistics.h"
#include "render/render_thread.h"

namespace rambla::game {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<std::string_view, 1> k_without_post_effects{"agents"};

bool has_post_effects(std::string_view scene) {
    return std::find(k_without_post_effects.begin(), k_without_post_effects.end(), scene) ==
           k_without_post_effects.end();
}

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What a Frame and its settings make the renderer do.
struct FeaturesSeen {
    bool sun_shadow = false;
    bool point_lights = false;

    void note(const render::FrameInput& input) {
        const bool sun = input.frame.environment.sun_illuminance != glm::vec3{0.0f};
        const bool mapped = input.settings.shadows.method != render::ShadowMethod::off;
        sun_shadow = sun_shadow || (sun && mapped && input.frame.casters.size() > 0);
        point_lights = point_lights || !input.frame.lights.empty();
    }
};

std::vector<std::string> feature_names(const FeaturesSeen& seen, const render::Settings& settings) {
    std::vector<std::string> names{"hdr", "tone-mapping"};  // the one way that pictures are made
    if (settings.bloom.method != render::BloomMethod::off) names.emplace_back("bloom");
    if (settings.anti_aliasing.method == render::AntiAliasing::fxaa) names.emplace_back("fxaa");
    if (seen.sun_shadow) names.emplace_back("sun-shadow");
    if (seen.point_lights) names.emplace_back("point-lights");
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
}

std::string line(std::string_view what, const std::vector<double>& ms) {
    return fmt::format("{:<8} {:9.2f} ms median, {:9.2f} ms p10, {:9.2f} ms p90\n", what, median(ms),
                       percentile(ms, 0.1), percentile(ms, 0.9));
}

void add(nlohmann::json& json, const std::string& what, const std::vector<double>& ms) {
    json[what + "_ms_median"] = median(ms);
    json[what + "_ms_p10"] = percentile(ms, 0.1);
    json[what + "_ms_p90"] = percentile(ms, 0.9);
}

}  // namespace

render::Settings compare_settings(render::Settings settings, std::string_view scene) {
    settings.shadows = {.method = render::ShadowMethod::focused,
                        .size_texels = 2048,
                        .taps = render::ShadowTaps::sixteen,
                        .distance_m = 400.0f};  // from any eye of the way to the plane's farthest corner
    settings.exposure.mode = render::ExposureMode::fixed;
    settings.bloom = {};
    const bool post_effects = has_post_effects(scene);
    settings.bloom.method = post_effects ? render::BloomMethod::pyramid : render::BloomMethod::off;
    settings.anti_aliasing.method = post_effects ? render::AntiAliasing::fxaa : render::AntiAliasing::none;
    return settings;
}

CompareMeasures run_compare(Stage& stage, const Options& options, std::uint32_t frames) {
    const render::Settings settings = compare_settings(options.settings_at(stage.exposure_ev), options.scene);
    render::RenderThread thread{
        {.window = {}, .shaders = {}, .gl_errors_throw = false, .compile_for = settings}};
    hand_over(prepare_scene(*stage.scene, thread.device(), options.quiet), stage, thread);
    thread.finish();
    CompareMeasures measures{.scene = options.scene, .size_px = options.size_px, .frames = frames};
    FeaturesSeen seen;
    Progress progress{"Comparing", frames, !options.quiet};
    for (std::uint32_t i = 0; i < frames; ++i) {
        const Clock::time_point start = Clock::now();
        systems::step(*stage.world);
        const double update_ms = ms_since(start);
        render::FrameInput& input = thread.begin();
        const Clock::time_point look = Clock::now();
        systems::Eye eye = walk_eye(stage, static_cast<float>(i / 60.0));
        eye.size_px = options.size_px;
        systems::build_frame(*stage.world, eye, 1.0f, input.frame);
        const double look_ms = ms_since(look);
        input.settings = settings;
        thread.submit();
        thread.finish();
        const double frame_ms = ms_since(start);
        static_cast<void>(thread.collect());
        seen.note(input);
        progress.update(i + 1);
        if (i < uncounted(frames)) continue;
        measures.frame_ms.push_back(frame_ms);
        measures.update_ms.push_back(update_ms);
        measures.look_ms.push_back(look_ms);
    }
    measures.features = feature_names(seen, settings);
    return measures;
}

std::string compare_text(const CompareMeasures& m) {
    return fmt::format("{}: {} frames of {}x{}, {} counted\n", m.scene, m.frames, m.size_px.x, m.size_px.y,
                       m.frame_ms.size()) +
           line("frame", m.frame_ms) + line("update", m.update_ms) + line("look", m.look_ms) +
           fmt::format("features={}\n", listed(m.features));
}

nlohmann::json compare_json(const CompareMeasures& m) {
    nlohmann::json json{{"schema", "rambla.compare/1"}, {"frames", m.frames},
                        {"counted", m.frame_ms.size()}, {"width_px", m.size_px.x},
                        {"height_px", m.size_px.y},     {"features", m.features}};
    add(json, "frame", m.frame_ms);
    add(json, "update", m.update_ms);
    add(json, "look", m.look_ms);
    return json;
}

}  // namespace rambla::game
