#include "game/walk_render.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <regex>
#include <system_error>
#include <utility>
#include <vector>

#include "assets/error.h"
#include "assets/export/image.h"
#include "game/camera_path.h"
#include "game/contact_sheet.h"
#include "game/heap_meter.h"
#include "game/pass_table.h"
#include "game/picture_writer.h"
#include "game/process_memory.h"
#include "game/progress.h"
#include "game/scene_cache.h"
#include "game/step_clock.h"
#include "game/supersampling.h"
#include "game/walk_report.h"
#include "game/window.h"
#include "render/render_thread.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t k_sheet_pictures = 25;  // a 5 × 5 grid shows a walk at one glance
constexpr std::uint32_t k_profile_warm_up = 1;  // the first frame with timers makes the queries
constexpr std::uint64_t k_stats_every_frames = 10;
/// Until both frames in flight are taken, begin() does not wait; the wait after that is for compiled shaders.
constexpr std::uint32_t k_filling_frames = 2;

/// Number `index` of `count` values spread evenly over 0 … last, both ends included.
std::uint32_t spread(std::uint32_t index, std::uint32_t count, std::uint32_t last) {
    return count > 1 ? static_cast<std::uint32_t>(std::uint64_t{index} * last / (count - 1)) : 0;
}

void prepare_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw assets::Error{folder.string(), "", error.message(), "a folder that can be written to"};
    static const std::regex frame_name{R"(frame_\d{4,}\.(png|exr))"};
    for (const fs::directory_entry& entry : fs::directory_iterator{folder}) {
        if (std::regex_match(entry.path().filename().string(), frame_name)) fs::remove(entry.path());
    }
}

class WalkRun {
public:
    WalkRun(Stage& stage, const Options& options, const WalkRender& walk)
        : stage_{stage},
          options_{options},
          walk_{walk},
          settings_{options.settings_at(stage.exposure_ev)},
          sheet_{std::min(walk.frames, k_sheet_pictures), options.size_px} {
        if (!options.headless && has_display()) {
            window_.emplace(options.size_px, "Rambla: walk", false);
        }
        thread_.emplace(
            render::RenderThreadOptions{.window = window_ ? window_->context() : render::WindowContext{},
                                        .shaders = {},
                                        .gl_errors_throw = false,
                                        .compile_for = settings_});
        upload();
        measures_.scene = options.scene;
        measures_.seed = options.seed;
        measures_.size_px = options.size_px;
        measures_.walk_s = static_cast<double>(duration_s(stage.walk));
        measures_.entities = stage.world->entity_count();
        measures_.drawn.reserve(walk.frames);
        measures_.held.reserve(walk.frames);
        measures_.profiled.reserve(walk.profile_frames + k_profile_warm_up);
    }

    void draw_walk() {
        if (walk_.trace) walk_.trace->listen_to(*stage_.world);
        Progress progress{"Walking", walk_.frames, !options_.quiet};
        const Clock::time_point start = Clock::now();
        Clock::time_point before = start;
        for (std::uint32_t i = 0; i < walk_.frames && !interrupted(); ++i) {
            const float time_s = time_of(i);
            const StepsAt moment = steps_at(time_s);
            for (; measures_.steps < moment.steps; ++measures_.steps)
                systems::step(*stage_.world);
            render::FrameInput& input = thread_->begin();
            const Clock::time_point now = Clock::now();
            if (i > k_filling_frames) {
                measures_.frame_ms.push_back(std::chrono::duration<double, std::milli>(now - before).count());
            }
            before = now;
            fill(input, i, moment.interpolation);
            input.frame.capture = {.display = true, .linear = walk_.format == "exr"};
            input.draw_graph = i == 0 && !walk_.graph.empty();
            input.complete_textures = !window_;  // in a window nothing waits
            measures_.counts = input.frame.counts;
            measures_.most_visible_lights =
                std::max(measures_.most_visible_lights, input.frame.counts.visible_lights);
            note_system_times();
            thread_->submit();
            take_outputs();
            progress.update(static_cast<std::uint32_t>(measures_.drawn.size()));
        }
        thread_->finish();
        take_outputs();
        measures_.run_s = std::chrono::duration<double>(Clock::now() - start).count();
        writer_.finish();
        assets::write_image(walk_.folder / "contact.png", sheet_.image());
    }

    /// Draws a sample of the walk again, with timers. The world stays as the walk has left it.
    void draw_profile() {
        if (walk_.profile_frames == 0) return;
        const std::uint32_t count = walk_.profile_frames + k_profile_warm_up;
        Progress progress{"Measuring passes", count, !options_.quiet};
        for (std::uint32_t i = 0; i < count && !interrupted(); ++i) {
            const std::uint32_t sample = i < k_profile_warm_up ? 0 : i - k_profile_warm_up;
            render::FrameInput& input = thread_->begin();
            fill(input, spread(sample, walk_.profile_frames, walk_.frames - 1), 1.0f);
            input.frame.capture = {};
            input.draw_graph = false;
            input.timers = render::PassTimers::alone;
            thread_->submit();
            take_profiled();
            progress.update(i + 1);
        }
        thread_->finish();
        take_profiled();
        const auto warm = std::min<std::size_t>(k_profile_warm_up, measures_.profiled.size());
        measures_.profiled.erase(measures_.profiled.begin(),
                                 measures_.profiled.begin() + static_cast<std::ptrdiff_t>(warm));
    }

    [[nodiscard]] WalkResult result() const {
        WalkResult result{.steps = measures_.steps,
                          .steadiness = steadiness(measures_.held),
                          .text = summary_text(measures_),
                          .json = summary_json(measures_)};
        result.json["out"] = walk_.folder.string();
        if (walk_.profile_frames > 0) {
            const PassTable table = make_pass_table(measures_.profiled);
            const std::string text = to_text(table);
            result.text += "\n" + text;
            result.json["pass_table"] = to_json(table);
            assets::write_text(walk_.folder / "passes.txt", summary_text(measures_) + "\n" + text);
        }
        if (walk_.stats) {
            result.text += "\n" + to_text(measures_.held, k_stats_every_frames);
            result.json["steady"] =
                result.steadiness.known ? nlohmann::json(result.steadiness.steady) : nlohmann::json();
            result.json["heap_growth_bytes"] = result.steadiness.heap_growth_bytes;
            result.json["resident_growth_bytes"] = result.steadiness.resident_growth_bytes;
            result.json["gl_object_growth"] = result.steadiness.gl_object_growth;
        }
        return result;
    }

private:
    /// Waits until everything is drawn that the first frame needs, so that frames are measured alone.
    void upload() {
        PreparedScene prepared = prepare_scene(*stage_.scene, thread_->device(), options_.quiet);
        measures_.start = {.generating_ms = walk_.generating_ms,
                           .loading_ms = prepared.loading_ms,
                           .processing_ms = prepared.processing_ms,
                           .uploading_ms = 0.0,
                           .cache_hits = prepared.cache_hits,
                           .cache_misses = prepared.cache_misses};
        const Clock::time_point start = Clock::now();
        hand_over(std::move(prepared), stage_, *thread_);
        thread_->finish();
        measures_.start.uploading_ms =
            std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }

    [[nodiscard]] float time_of(std::uint32_t frame) const {
        const float whole_s = duration_s(stage_.walk);
        return walk_.frames > 1 ? whole_s * static_cast<float>(frame) / static_cast<float>(walk_.frames - 1)
                                : 0.0f;
    }

    [[nodiscard]] bool interrupted() {
        if (!window_) return false;
        window_->poll();
        if (glfwGetKey(window_->handle(), GLFW_KEY_ESCAPE) == GLFW_PRESS) window_->close();
        return window_->closing();
    }

    void fill(render::FrameInput& input, std::uint32_t frame, float interpolation) {
        systems::Eye eye = walk_eye(stage_, time_of(frame));
        eye.size_px = options_.size_px;
        systems::build_frame(*stage_.world, sampled(eye, settings_.anti_aliasing, thread_->device()),
                             interpolation, input.frame);
        input.settings = settings_;
        input.timers = walk_.trace ? render::PassTimers::stamped : render::PassTimers::off;
        input.reload_shaders = false;
        input.complete_textures = false;
    }

    void take_profiled() {
        for (render::FrameOutput& output : thread_->collect()) {
            if (walk_.trace) walk_.trace->add(output.feedback);
            measures_.profiled.push_back(std::move(output.feedback));
        }
    }

    void take_outputs() {
        for (render::FrameOutput& output : thread_->collect()) {
            if (walk_.trace) walk_.trace->add(output.feedback);
            const auto frame = static_cast<std::uint32_t>(measures_.drawn.size());
            if (!output.graph_svg.empty()) assets::write_text(walk_.graph, output.graph_svg);
            measures_.held.push_back(
                {.frame = frame,
                 .heap_bytes = heap_bytes(),
                 .resident_bytes = resident_bytes(),
                 .gpu_bytes = output.feedback.gpu_memory_bytes - output.feedback.textures.resident_bytes,
                 .gl_objects = output.feedback.gl_objects});
            measures_.drawn.push_back(std::move(output.feedback));
            write(frame, std::move(output.display), std::move(output.linear));
        }
    }

    void write(std::uint32_t frame, std::optional<assets::Image> display,
               std::optional<assets::Image> linear) {
        const fs::path file = walk_.folder / fmt::format("frame_{:04}", frame);
        if (linear) writer_.write(fs::path{file}.concat(".exr"), std::move(*linear));
        if (!display) return;
        const auto picture = std::make_shared<const assets::Image>(std::move(*display));
        for (std::uint32_t cell = 0; cell < std::min(walk_.frames, k_sheet_pictures); ++cell) {
            if (spread(cell, std::min(walk_.frames, k_sheet_pictures), walk_.frames - 1) != frame) continue;
            writer_.run([this, cell, picture] { sheet_.place(cell, *picture); });
        }
        writer_.run([file = fs::path{file}.concat(".png"), picture] { assets::write_image(file, *picture); });
    }

    void note_system_times() {
        const auto timings = stage_.world->resource<systems::StepTimings>().all();
        measures_.systems.resize(timings.size());
        for (std::size_t i = 0; i < timings.size(); ++i) {
            measures_.systems[i].name = timings[i].name;
            measures_.systems[i].ms.push_back(timings[i].ms);
        }
    }

    Stage& stage_;
    const Options& options_;
    const WalkRender& walk_;
    render::Settings settings_;
    ContactSheet sheet_;
    std::optional<Window> window_;
    std::optional<render::RenderThread> thread_;  // ends before the window whose context it holds
    PictureWriter writer_;                        // ends before the sheet that it fills

    WalkMeasures measures_;
};

}  // namespace

WalkResult render_walk(Stage& stage, const Options& options, const WalkRender& walk) {
    prepare_folder(walk.folder);
    WalkRun run{stage, options, walk};
    run.draw_walk();
    run.draw_profile();
    return run.result();
}

}  // namespace rambla::game
