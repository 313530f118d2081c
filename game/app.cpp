#include "game/app.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include "assets/export/image.h"
#include "game/entity_browser.h"
#include "game/hud.h"
#include "game/interface.h"
#include "game/overlay.h"
#include "game/picture_writer.h"
#include "game/scene_cache.h"
#include "game/shader_folder.h"
#include "game/supersampling.h"
#include "game/window.h"
#include "render/post/hud.h"
#include "render/render_thread.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double k_notice_s = 4.0;
constexpr double k_minimised_wait_s = 0.1;

/// The first screenshot name that is not taken.
fs::path free_screenshot(std::uint32_t& number, std::string_view extension) {
    fs::create_directories("out");
    for (;; ++number) {
        const fs::path file = fs::path{"out"} / fmt::format("screenshot_{:04}{}", number, extension);
        if (!fs::exists(file)) return file;
    }
}

class App {
public:
    App(const AppOptions& options, Stage& stage, const render::Settings& settings)
        : options_{options},
          stage_{stage},
          settings_{settings},
          window_{options.size_px, options.title, true},
          input_{window_.handle()},
          interface_{window_.handle()},
          browser_{*stage.world},
          overlay_{settings_,
                   [this] {
                       if (options_.overlay_part) options_.overlay_part();
                       browser_.draw();
                   }},
          shaders_{ShaderFolder::of_build()},
          thread_{{.window = window_.context(),
                   .shaders = shaders_.source(),
                   .gl_errors_throw = false,
                   .compile_for = settings}} {
        hud_.walking = options.walking;
        hand_over(prepare_scene(*stage.scene, thread_.device(), options.quiet), stage, thread_);
        if (options.trace) options.trace->listen_to(*stage.world);
    }

    std::uint64_t run(const Update& update) {
        Clock::time_point before = Clock::now();
        std::uint64_t frames = 0;
        while (options_.frames == 0 || frames < options_.frames) {
            if (window_.size_px().x == 0 || window_.size_px().y == 0) {
                glfwWaitEventsTimeout(k_minimised_wait_s);
                if (window_.closing()) break;
                continue;
            }
            // The wait for a free frame comes before the look at the keys: pictures show the newest wishes.
            render::FrameInput& frame = thread_.begin();
            window_.poll();
            if (window_.closing() || input_.pressed(Action::quit)) break;
            const Clock::time_point now = Clock::now();
            const double elapsed_s = std::chrono::duration<double>(now - before).count();
            before = now;
            act_on_keys();
            const Shot shot = update({.elapsed_s = hud_.paused ? 0.0 : elapsed_s,
                                      .input = input_,
                                      .keys_free = !interface_.wants_keys(),
                                      .pointer_free = !interface_.wants_pointer()});
            hud_.caption = shot.caption;
            fill(frame, shot, now);
            frame.frame.hud = build_interface(shot, elapsed_s);
            thread_.submit();
            input_.end_frame();
            take_outputs();
            ++frames;
        }
        thread_.finish();
        take_outputs();
        return frames;
    }

private:
    void act_on_keys() {
        if (input_.pressed(Action::help)) hud_.help = !hud_.help;
        if (input_.pressed(Action::timings)) hud_.timings = !hud_.timings;
        if (input_.pressed(Action::overlay)) show_overlay_ = !show_overlay_;
        if (input_.pressed(Action::pause)) hud_.paused = !hud_.paused;
        if (input_.pressed(Action::full_screen)) window_.toggle_full_screen();
        const bool captured = options_.walking && !show_overlay_ && !hud_.paused;
        if (captured == pointer_captured_) return;
        pointer_captured_ = captured;
        window_.capture_pointer(captured);
        input_.forget_pointer();
    }

    void fill(render::FrameInput& frame, const Shot& shot, Clock::time_point now) {
        systems::Eye eye = shot.eye;
        eye.size_px = window_.size_px();
        systems::build_frame(*stage_.world, sampled(eye, settings_.anti_aliasing, thread_.device()),
                             shot.interpolation, frame.frame);
        const bool wanted = input_.pressed(Action::screenshot);
        const bool linear = input_.with_shift(Action::screenshot);
        frame.frame.capture = {.display = wanted && !linear, .linear = wanted && linear};
        frame.settings = settings_;
        frame.timers = pass_timers();
        frame.draw_graph = false;
        frame.complete_textures = false;
        frame.reload_shaders = shaders_.exists() && shaders_.changed(now);
        if (frame.reload_shaders) hud_.shader_error.clear();
        counts_ = frame.frame.counts;
        if (now > notice_ends_) hud_.notice.clear();
    }

    [[nodiscard]] render::PassTimers pass_timers() const {
        if (hud_.timings) return render::PassTimers::alone;
        return options_.trace ? render::PassTimers::stamped : render::PassTimers::off;
    }

    std::shared_ptr<const void> build_interface(const Shot& shot, double elapsed_s) {
        hud_.picture_ms = 1000.0 * elapsed_s;
        interface_.begin_frame(window_.size_px());
        draw_hud(hud_, timings_);
        if (show_overlay_) {
            overlay_.draw({.counts = counts_,
                           .entities = stage_.world->entity_count(),
                           .archetypes = stage_.world->archetype_count(),
                           .steps = shot.steps,
                           .feedback = timings_.newest()});
        }
        return render::clone_hud(interface_.end_frame());
    }

    void take_outputs() {
        for (render::FrameOutput& output : thread_.collect()) {
            if (options_.trace) options_.trace->add(output.feedback);
            timings_.add(std::move(output.feedback));
            if (output.display) save(std::move(*output.display), ".png");
            if (output.linear) save(std::move(*output.linear), ".exr");
            if (output.shader_error.empty()) continue;
            spdlog::error("{}", output.shader_error);
            hud_.shader_error = std::move(output.shader_error);
        }
    }

    void save(assets::Image image, std::string_view extension) {
        const fs::path file = free_screenshot(screenshots_, extension);
        ++screenshots_;
        hud_.notice = "Picture: " + file.string();
        notice_ends_ = Clock::now() +
                       std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{k_notice_s});
        const auto picture = std::make_shared<const assets::Image>(std::move(image));
        writer_.run([file, picture] {
            try {
                assets::write_image(file, *picture);
                spdlog::info("Wrote {}", file.string());
            } catch (const std::exception& error) {
                spdlog::error("{}", error.what());  // a full disk does not end the game
            }
        });
    }

    AppOptions options_;
    Stage& stage_;
    render::Settings settings_;
    Window window_;
    Input input_;
    Interface interface_;
    EntityBrowser browser_;
    Overlay overlay_;
    ShaderFolder shaders_;
    TimingsPanel timings_;
    PictureWriter writer_;
    Hud hud_;
    bool show_overlay_ = false;
    bool pointer_captured_ = false;
    systems::FrameCounts counts_;
    Clock::time_point notice_ends_{};
    std::uint32_t screenshots_ = 0;
    render::RenderThread thread_;  // the last: it ends before the window whose context it holds
};

}  // namespace

std::uint64_t run_app(const AppOptions& options, Stage& stage, const render::Settings& settings,
                      const Update& update) {
    App app{options, stage, settings};
    return app.run(update);
}

}  // namespace rambla::game
