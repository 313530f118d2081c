#include "game/run_trace.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace rambla::game {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t k_main_track = 1;
constexpr std::uint32_t k_render_track = 2;
constexpr std::uint32_t k_gpu_track = 3;
constexpr std::uint32_t k_first_worker_track = 4;

/// Exact again: the milliseconds come from whole nanoseconds.
std::chrono::nanoseconds nanoseconds(double ms) {
    return std::chrono::nanoseconds{std::llround(ms * 1e6)};
}

}  // namespace

RunTrace::RunTrace(const std::filesystem::path& file)
    : file_{file, Clock::now()}, tracks_{{std::this_thread::get_id(), k_main_track}} {
    file_.name_track(k_main_track, "main");
    file_.name_track(k_render_track, "render");
    file_.name_track(k_gpu_track, "GPU");
}

void RunTrace::listen_to(ecs::World& world) {
    world.set_resource(systems::SystemsListener{[this](const systems::SystemsRun& run) {
        add(run);
    }});
}

void RunTrace::add(const systems::SystemsRun& run) {
    const bool step = run.kind == systems::SystemsRun::Kind::step;
    const std::string_view kind = step ? "step" : "look";
    const std::string_view of = step ? "step" : "frame";
    file_.add({.name = kind,
               .category = kind,
               .track = track_of(std::this_thread::get_id()),
               .begin = run.begin,
               .duration = run.end - run.begin,
               .of = of,
               .number = run.number});
    sorted_.assign(run.systems.begin(), run.systems.end());
    std::sort(sorted_.begin(), sorted_.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    for (const systems::SystemTiming& system : sorted_) {
        file_.add({.name = system.name,
                   .category = "system",
                   .track = track_of(system.thread),
                   .begin = system.begin,
                   .duration = nanoseconds(system.ms),
                   .of = of,
                   .number = run.number});
    }
}

void RunTrace::add(const systems::Feedback& frame) {
    file_.add({.name = "frame",
               .category = "frame,cpu",
               .track = k_render_track,
               .begin = frame.cpu_begin,
               .duration = nanoseconds(frame.cpu_frame_ms),
               .of = "frame",
               .number = frame.frame});
    for (const systems::PassTiming& pass : frame.passes) {
        file_.add({.name = pass.name,
                   .category = "pass,cpu",
                   .track = k_render_track,
                   .begin = pass.cpu_begin,
                   .duration = nanoseconds(pass.cpu_ms),
                   .of = "frame",
                   .number = frame.frame});
    }
    if (frame.gpu_begin != Clock::time_point{}) add_gpu(frame);
}

void RunTrace::add_gpu(const systems::Feedback& frame) {
    // The GPU does one after the other. Its clock is read anew from time to time, to some microseconds, by
    // which the end of one may come to lie behind the begin of the next.
    const Clock::time_point frame_begin = std::max(frame.gpu_begin, gpu_end_);
    const Clock::time_point frame_end =
        std::max(frame.gpu_begin + nanoseconds(frame.gpu_frame_ms), frame_begin);
    file_.add({.name = "frame",
               .category = "frame,gpu",
               .track = k_gpu_track,
               .begin = frame_begin,
               .duration = frame_end - frame_begin,
               .of = "frame",
               .number = frame.frame});
    gpu_end_ = frame_begin;
    for (const systems::PassTiming& pass : frame.passes) {
        if (pass.gpu_begin == Clock::time_point{}) continue;
        const Clock::time_point begin = std::clamp(pass.gpu_begin, gpu_end_, frame_end);
        gpu_end_ = std::clamp(pass.gpu_begin + nanoseconds(pass.gpu_ms), begin, frame_end);
        file_.add({.name = pass.name,
                   .category = "pass,gpu",
                   .track = k_gpu_track,
                   .begin = begin,
                   .duration = gpu_end_ - begin,
                   .of = "frame",
                   .number = frame.frame});
    }
    gpu_end_ = frame_end;
}

void RunTrace::finish() {
    file_.close();
    spdlog::info("Wrote {}", file_.path().string());
}

std::uint32_t RunTrace::track_of(std::thread::id thread) {
    const auto [found, is_new] =
        tracks_.try_emplace(thread, k_first_worker_track + static_cast<std::uint32_t>(tracks_.size()) - 1);
    if (is_new) file_.name_track(found->second, fmt::format("worker {}", tracks_.size() - 1));
    return found->second;
}

std::unique_ptr<RunTrace> begin_trace(const std::filesystem::path& file) {
    return file.empty() ? nullptr : std::make_unique<RunTrace>(file);
}

}  // namespace rambla::game
