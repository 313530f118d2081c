#include "game/walk_report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "game/pass_table.h"
#include "game/statistics.h"

namespace rambla::game {
namespace {

template <class Value>
double median_of(const std::vector<systems::Feedback>& frames, Value systems::Feedback::*member) {
    std::vector<double> values;
    for (const systems::Feedback& feedback : frames)
        values.push_back(static_cast<double>(feedback.*member));
    return median(values);
}

std::uint64_t sum_of(const std::vector<systems::Feedback>& frames, std::uint64_t systems::Feedback::*member) {
    std::uint64_t sum = 0;
    for (const systems::Feedback& feedback : frames)
        sum += feedback.*member;
    return sum;
}

double frames_per_second(const WalkMeasures& m) {
    return m.run_s > 0.0 ? static_cast<double>(m.drawn.size()) / m.run_s : 0.0;
}

/// Empty for a walk so short that the queue never was full: there is nothing to state then.
std::string frame_times_text(const WalkMeasures& m) {
    if (m.frame_ms.empty()) return "";
    return fmt::format("; a frame takes {:.1f} ms (median), {:.1f} ms (p99)", median(m.frame_ms),
                       percentile(m.frame_ms, 0.99));
}

/// null without samples.
nlohmann::json frame_ms_json(const WalkMeasures& m, double share) {
    return m.frame_ms.empty() ? nlohmann::json() : nlohmann::json(percentile(m.frame_ms, share));
}

HeldSample last_held(const WalkMeasures& m) {
    return m.held.empty() ? HeldSample{} : m.held.back();
}

/// After the last frame, textures included.
std::uint64_t gpu_memory_bytes(const WalkMeasures& m) {
    return m.drawn.empty() ? 0 : m.drawn.back().gpu_memory_bytes;
}

std::string start_text(const StartMeasures& s) {
    return fmt::format(
        "started in {:.0f} ms: {:.0f} generating, {:.0f} loading ({} cache hits), {:.0f} processing ({} "
        "misses), {:.0f} uploading and compiling\n",
        s.generating_ms + s.loading_ms + s.processing_ms + s.uploading_ms, s.generating_ms, s.loading_ms,
        s.cache_hits, s.processing_ms, s.cache_misses, s.uploading_ms);
}

/// After the last frame.
systems::TextureFeedback last_textures(const WalkMeasures& m) {
    return m.drawn.empty() ? systems::TextureFeedback{} : m.drawn.back().textures;
}

std::string textures_text(const systems::TextureFeedback& t) {
    return fmt::format(
        "textures {} resident, {} at most, of a budget of {}; {} loads, {} pending, {} images coarser than "
        "the "
        "picture shows\n",
        bytes_text(static_cast<double>(t.resident_bytes)), bytes_text(static_cast<double>(t.peak_bytes)),
        bytes_text(static_cast<double>(t.budget_bytes)), t.loads, t.pending_loads, t.below_demand);
}

std::string systems_text(const WalkMeasures& m) {
    std::string text;
    for (const SystemSamples& system : m.systems) {
        text += fmt::format("{}{} {:.2f} ms", text.empty() ? "" : ", ", system.name, median(system.ms));
    }
    return text;
}

}  // namespace

std::string summary_text(const WalkMeasures& m) {
    const HeldSample held = last_held(m);
    std::string text =
        fmt::format("{} seed {}, {} frames of {}x{} over {:.1f} s of walk ({} steps)\n", m.scene, m.seed,
                    m.drawn.size(), m.size_px.x, m.size_px.y, m.walk_s, m.steps);
    text += start_text(m.start);
    text += fmt::format("drawn and encoded in {:.1f} s, {:.2f} frames per second{}\n", m.run_s,
                        frames_per_second(m), frame_times_text(m));
    text += fmt::format(
        "{} entities, {} renderables, {} casters and {} lights, of which up to {} reach the picture; {:.0f} "
        "draws and "
        "{:.0f} triangles per frame\n",
        m.entities, m.counts.renderables, m.counts.casters, m.counts.lights, m.most_visible_lights,
        median_of(m.drawn, &systems::Feedback::draws), median_of(m.drawn, &systems::Feedback::triangles));
    text += fmt::format("{:.0f} GL calls per frame, of which {:.0f} change state, {} blocking ones in all\n",
                        median_of(m.drawn, &systems::Feedback::gl_calls),
                        median_of(m.drawn, &systems::Feedback::gl_state_changes),
                        sum_of(m.drawn, &systems::Feedback::gl_blocking_calls));
    text += fmt::format("systems on the CPU: {}\n", systems_text(m));
    text += fmt::format("memory {} resident, {} on the GPU, {} GL objects\n",
                        bytes_text(static_cast<double>(held.resident_bytes)),
                        bytes_text(static_cast<double>(gpu_memory_bytes(m))), held.gl_objects);
    text += textures_text(last_textures(m));
    return text;
}

nlohmann::json textures_json(const systems::TextureFeedback& t) {
    return {{"resident_bytes", t.resident_bytes}, {"peak_bytes", t.peak_bytes},
            {"budget_bytes", t.budget_bytes},     {"loads", t.loads},
            {"pending_loads", t.pending_loads},   {"below_demand", t.below_demand}};
}

/// After the last frame, but for the most bad pixels of any; null where nothing looked at luminances.
nlohmann::json exposure_json(const WalkMeasures& m) {
    if (m.drawn.empty() || !m.drawn.back().exposure.known) return {};
    const systems::ExposureFeedback& last = m.drawn.back().exposure;
    std::uint32_t most_bad_pixels = 0;
    for (const systems::Feedback& feedback : m.drawn)
        most_bad_pixels = std::max(most_bad_pixels, feedback.exposure.bad_pixels);
    return {{"departure_ev", last.departure_ev},
            {"average_luminance", last.average_luminance},
            {"bad_pixels_most", most_bad_pixels}};
}

nlohmann::json summary_json(const WalkMeasures& m) {
    nlohmann::json systems_ms = nlohmann::json::object();
    for (const SystemSamples& system : m.systems)
        systems_ms[system.name] = median(system.ms);
    return {{"frames", m.drawn.size()},
            {"width_px", m.size_px.x},
            {"height_px", m.size_px.y},
            {"start_ms",
             {{"generating", m.start.generating_ms},
              {"loading", m.start.loading_ms},
              {"processing", m.start.processing_ms},
              {"uploading", m.start.uploading_ms}}},
            {"cache_hits", m.start.cache_hits},
            {"cache_misses", m.start.cache_misses},
            {"run_s", m.run_s},
            {"frames_per_second", frames_per_second(m)},
            {"frame_ms_median", frame_ms_json(m, 0.5)},
            {"frame_ms_p99", frame_ms_json(m, 0.99)},
            {"systems_ms_median", systems_ms},
            {"renderables", m.counts.renderables},
            {"casters", m.counts.casters},
            {"lights", m.counts.lights},
            {"visible_lights_most", m.most_visible_lights},
            {"draws_median", median_of(m.drawn, &systems::Feedback::draws)},
            {"triangles_median", median_of(m.drawn, &systems::Feedback::triangles)},
            {"gl_calls_median", median_of(m.drawn, &systems::Feedback::gl_calls)},
            {"gl_state_changes_median", median_of(m.drawn, &systems::Feedback::gl_state_changes)},
            {"gl_blocking_calls", sum_of(m.drawn, &systems::Feedback::gl_blocking_calls)},
            {"gl_pacing_waits", sum_of(m.drawn, &systems::Feedback::gl_pacing_waits)},
            {"gpu_memory_bytes", gpu_memory_bytes(m)},
            {"textures", textures_json(last_textures(m))},
            {"exposure", exposure_json(m)},
            {"gl_objects", last_held(m).gl_objects}};
}

}  // namespace rambla::game
