#include "bench/render/measure.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "game/compare.h"
#include "systems/pipeline.h"

namespace rambla::bench {
namespace {

using render::LightingPath;

constexpr std::uint32_t k_most_unculled_lights = 256;
constexpr std::array<std::string_view, 3> k_lighting{"light tiles", "lighting", "light volumes"};
constexpr std::array<std::string_view, 4> k_also_surfaces{"depth pre-pass", "gbuffer", "shadow result",
                                                          "forward"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Way way(std::string name, LightingPath path, bool prepass = false) {
    render::Settings settings = game::compare_settings({}, "blocks");
    settings.lighting.path = path;
    settings.lighting.prepass = prepass;
    return {std::move(name), settings};
}

void note(WayCost& cost, const systems::Feedback& feedback, std::size_t round) {
    double known = 0.0;
    double lighting = 0.0;
    double surfaces = 0.0;
    double cpu = 0.0;
    for (const systems::PassTiming& pass : feedback.passes) {
        std::vector<double>& ms = cost.passes[pass.name];
        ms.resize(round);
        ms.push_back(pass.gpu_ms);
        known += pass.gpu_ms;
        cpu += pass.cpu_ms;
        if (is_one_of(k_lighting, pass.name)) lighting += pass.gpu_ms;
        if (is_one_of(k_also_surfaces, pass.name)) surfaces += pass.gpu_ms;
    }
    cost.lighting.push_back(lighting);
    cost.surfaces.push_back(lighting + surfaces);
    cost.frame.push_back(feedback.gpu_frame_ms);
    cost.missing.push_back(feedback.gpu_frame_ms - known);
    cost.cpu.push_back(cpu);
}

}  // namespace

render::FrameOutput draw(game::Stage& stage, render::RenderThread& thread, const render::Settings& settings,
                         const systems::Eye& eye, bool captured) {
    render::FrameInput& input = thread.begin();
    systems::build_frame(*stage.world, eye, 1.0f, input.frame);
    input.frame.capture = {.display = captured, .linear = false};
    input.settings = settings;
    input.settings.tone.exposure_ev = stage.exposure_ev;
    input.timers = render::PassTimers::alone;
    input.complete_textures = true;
    thread.submit();
    thread.finish();
    return std::move(thread.collect().back());
}

std::vector<Way> ways(std::uint32_t lights) {
    std::vector<Way> all;
    if (lights <= k_most_unculled_lights) {
        all.push_back(way("fullscreen", LightingPath::fullscreen));
        all.push_back(way("volumes", LightingPath::volumes));
        all.push_back(way("volumes, solid", LightingPath::volumes));
        all.back().settings.lighting.volume = render::LightVolume::solid;
    }
    all.push_back(way("clustered", LightingPath::clustered));
    all.push_back(way("tiled", LightingPath::tiled));
    all.push_back(way("tiled+depth", LightingPath::tiled, true));
    all.push_back(way("tiled, wide", LightingPath::tiled));
    all.back().settings.gbuffer.layout = render::GBufferLayout::wide;
    all.push_back(way("forward", LightingPath::forward));
    all.push_back(way("forward+depth", LightingPath::forward, true));
    return all;
}

std::vector<WayCost> measure(game::Stage& stage, render::RenderThread& thread, const std::vector<Way>& ways,
                             View view, glm::uvec2 size_px, std::uint32_t rounds) {
    std::vector<WayCost> costs;
    for (const Way& way : ways) {
        costs.emplace_back().name = way.name;
        static_cast<void>(draw(stage, thread, way.settings, eye_of(stage, view, 0.0, size_px), false));
    }
    for (std::uint32_t round = 0; round < rounds; ++round) {
        const systems::Eye eye = eye_of(stage, view, static_cast<double>(round) / rounds, size_px);
        for (std::size_t i = 0; i < ways.size(); ++i)
            note(costs[i], draw(stage, thread, ways[i].settings, eye, false).feedback, round);
    }
    for (WayCost& cost : costs) {
        for (auto& [name, ms] : cost.passes)
            ms.resize(rounds);
    }
    return costs;
}

}  // namespace rambla::bench
