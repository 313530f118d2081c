#include "game/walk_report.h"

#include <spdlog/fmt/fmt.h>

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

std::string start_text(const StartMeasures& s) {
    return fmt::format(
        "started in {:.0f} ms: {:.0f} generating, {:.0f} loading ({} cache hits), {:.0f} processing ({} "
        "misses), {:.0f} uploading and compiling\n",
        s.generating_ms + s.loading_ms + s.processing_ms + s.uploading_ms, s.generating_ms, s.loading_ms,
        s.cache_hits, s.processing_ms, s.cache_misses, s.uploading_ms);
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
    text += fmt::format("systems on the CPU: {}\n", systems_text(m));
    text += fmt::format("memory {} resident, {} on the GPU, {} GL objects\n",
                        bytes_text(static_cast<double>(held.resident_bytes)),
                        bytes_text(static_cast<double>(held.gpu_bytes)), held.gl_objects);
    return text;
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
            {"gpu_memory_bytes", last_held(m).gpu_bytes},
            {"gl_objects", last_held(m).gl_objects}};
}

}  // namespace rambla::game
