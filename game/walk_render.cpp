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
#include "game/pass_table.h"
#include "game/picture_writer.h"
#include "game/process_memory.h"
#include "game/progress.h"
#include "game/statistics.h"
#include "game/step_clock.h"
#include "game/window.h"
#include "render/render_thread.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t k_sheet_pictures = 25;  // a 5 × 5 grid shows a walk at one glance
constexpr std::uint32_t k_profile_warm_up = 1;  // the first frame with timers makes the queries
constexpr std::uint64_t k_stats_every_frames = 10;

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
          sheet_{std::min(walk.frames, k_sheet_pictures), options.size_px} {
        if (!options.headless && has_display()) {
            window_.emplace(options.size_px, "Rambla: walk", false);
        }
        thread_.emplace(
            render::RenderThreadOptions{.window = window_ ? window_->context() : render::WindowContext{},
                                        .shaders = {},
                                        .gl_errors_throw = false});
        thread_->upload(stage.scene);
        drawn_.reserve(walk.frames);
        held_.reserve(walk.frames);
        profiled_.reserve(walk.profile_frames + k_profile_warm_up);
    }

    void draw_walk() {
        Progress progress{"Walking", walk_.frames, !options_.quiet};
        const Clock::time_point start = Clock::now();
        Clock::time_point before = start;
        for (std::uint32_t i = 0; i < walk_.frames && !interrupted(); ++i) {
            const float time_s = time_of(i);
            const StepsAt moment = steps_at(time_s);
            for (; steps_ < moment.steps; ++steps_)
                systems::step(*stage_.world);
            render::FrameInput& input = thread_->begin();
            const Clock::time_point now = Clock::now();
            if (i > 0) frame_ms_.push_back(std::chrono::duration<double, std::milli>(now - before).count());
            before = now;
            fill(input, i, moment.interpolation);
            input.frame.capture = {.display = true, .linear = walk_.format == "exr"};
            input.draw_graph = i == 0 && !walk_.graph.empty();
            counts_ = input.frame.counts;
            thread_->submit();
            take_outputs();
            progress.update(static_cast<std::uint32_t>(drawn_.size()));
        }
        thread_->finish();
        take_outputs();
        seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
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
            input.profile = true;
            thread_->submit();
            for (render::FrameOutput& output : thread_->collect())
                profiled_.push_back(std::move(output.feedback));
            progress.update(i + 1);
        }
        thread_->finish();
        for (render::FrameOutput& output : thread_->collect())
            profiled_.push_back(std::move(output.feedback));
        const auto warm = std::min<std::size_t>(k_profile_warm_up, profiled_.size());
        profiled_.erase(profiled_.begin(), profiled_.begin() + static_cast<std::ptrdiff_t>(warm));
    }

    [[nodiscard]] WalkResult result() const {
        WalkResult result{
            .steps = steps_, .steadiness = steadiness(held_), .text = summary(), .json = summary_json()};
        if (walk_.profile_frames > 0) {
            const PassTable table = make_pass_table(profiled_);
            const std::string text = to_text(table);
            result.text += "\n" + text;
            result.json["pass_table"] = to_json(table);
            assets::write_text(walk_.folder / "passes.txt", summary() + "\n" + text);
        }
        if (walk_.stats) {
            result.text += "\n" + to_text(held_, k_stats_every_frames);
            result.json["steady"] =
                result.steadiness.known ? nlohmann::json(result.steadiness.steady) : nlohmann::json();
            result.json["resident_growth_bytes"] = result.steadiness.resident_growth_bytes;
            result.json["gl_object_growth"] = result.steadiness.gl_object_growth;
        }
        return result;
    }

private:
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
        systems::build_frame(*stage_.world, eye, interpolation, input.frame);
        input.settings = options_.settings;
        input.profile = false;
        input.reload_shaders = false;
    }

    void take_outputs() {
        for (render::FrameOutput& output : thread_->collect()) {
            const auto frame = static_cast<std::uint32_t>(drawn_.size());
            if (!output.graph_svg.empty()) assets::write_text(walk_.graph, output.graph_svg);
            held_.push_back({.frame = frame,
                             .resident_bytes = resident_bytes(),
                             .gpu_bytes = output.feedback.gpu_memory_bytes,
                             .gl_objects = output.feedback.gl_objects});
            drawn_.push_back(std::move(output.feedback));
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

    [[nodiscard]] double median_of(std::uint64_t (*value)(const systems::Feedback&)) const {
        std::vector<double> values;
        for (const systems::Feedback& feedback : drawn_)
            values.push_back(static_cast<double>(value(feedback)));
        return median(values);
    }
    [[nodiscard]] double draws() const {
        return median_of([](const systems::Feedback& f) -> std::uint64_t { return f.draws; });
    }
    [[nodiscard]] double triangles() const {
        return median_of([](const systems::Feedback& f) { return f.triangles; });
    }
    [[nodiscard]] double frames_per_second() const {
        return seconds_ > 0.0 ? static_cast<double>(drawn_.size()) / seconds_ : 0.0;
    }

    [[nodiscard]] std::string summary() const {
        return fmt::format(
            "{} seed {}, {} frames of {}x{} over {:.1f} s of walk ({} steps)\n"
            "drawn and encoded in {:.1f} s, {:.2f} frames per second; a frame takes {:.1f} ms (median), "
            "{:.1f} ms (p99)\n"
            "{} entities, {} renderables, {} casters and {} lights; {:.0f} draws and {:.0f} triangles per "
            "frame\n"
            "memory {} resident, {} on the GPU, {} GL objects\n",
            options_.scene, options_.seed, drawn_.size(), options_.size_px.x, options_.size_px.y,
            duration_s(stage_.walk), steps_, seconds_, frames_per_second(), median(frame_ms_),
            percentile(frame_ms_, 0.99), stage_.world->entity_count(), counts_.renderables, counts_.casters,
            counts_.lights, draws(), triangles(), bytes_text(static_cast<double>(last_held().resident_bytes)),
            bytes_text(static_cast<double>(last_held().gpu_bytes)), last_held().gl_objects);
    }

    [[nodiscard]] nlohmann::json summary_json() const {
        return {{"frames", drawn_.size()},
                {"width_px", options_.size_px.x},
                {"height_px", options_.size_px.y},
                {"out", walk_.folder.string()},
                {"run_s", seconds_},
                {"frames_per_second", frames_per_second()},
                {"frame_ms_median", median(frame_ms_)},
                {"frame_ms_p99", percentile(frame_ms_, 0.99)},
                {"renderables", counts_.renderables},
                {"lights", counts_.lights},
                {"draws_median", draws()},
                {"triangles_median", triangles()},
                {"gpu_memory_bytes", last_held().gpu_bytes},
                {"gl_objects", last_held().gl_objects}};
    }

    [[nodiscard]] HeldSample last_held() const { return held_.empty() ? HeldSample{} : held_.back(); }

    Stage& stage_;
    const Options& options_;
    const WalkRender& walk_;
    ContactSheet sheet_;
    std::optional<Window> window_;
    std::optional<render::RenderThread> thread_;  // ends before the window whose context it holds
    PictureWriter writer_;                        // ends before the sheet that it fills

    std::uint64_t steps_ = 0;
    double seconds_ = 0.0;
    systems::FrameCounts counts_;
    std::vector<double> frame_ms_;
    std::vector<HeldSample> held_;
    std::vector<systems::Feedback> drawn_;
    std::vector<systems::Feedback> profiled_;
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
