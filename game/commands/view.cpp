#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "assets/export/image.h"
#include "game/app.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/model_view.h"
#include "game/options.h"
#include "game/run_trace.h"
#include "game/view_session.h"
#include "game/view_sheet.h"
#include "game/window.h"
#include "render/render_thread.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

constexpr glm::uvec2 k_cell_px{320, 240};  // of a sheet: thirty of them fit on a screen

struct ViewCommand {
    Options options;
    ViewWishes wishes;
    std::vector<fs::path> files;
    fs::path out;
    std::uint64_t frames = 0;
    const CLI::Option* shadows = nullptr;
    const CLI::Option* size = nullptr;
};

int draw_picture(const ViewCommand& command, RunTrace* trace) {
    const fs::path& file = command.files[0];
    ModelView view = view_model(file, command.wishes);
    render::RenderThread thread{
        {.window = {}, .shaders = {}, .gl_errors_throw = false, .compile_for = view.settings}};
    const ModelPicture picture =
        draw_model(thread, view, command.out.extension() == ".exr", command.options.quiet, {}, trace);
    assets::write_image(command.out, picture.image);
    nlohmann::json json = picture_facts(view, picture);
    json["schema"] = "rambla.view/1";
    json["file"] = file.string();
    json["out"] = command.out.string();
    write_json(command.options.json, json);
    spdlog::info("Wrote {}", command.out.string());
    return k_done;
}

int draw_sheet(const ViewCommand& command) {
    const nlohmann::json rows =
        write_view_sheet(command.files, command.wishes, command.out, command.options.quiet);
    write_json(command.options.json,
               {{"schema", "rambla.view_sheet/1"}, {"out", command.out.string()}, {"files", rows}});
    spdlog::info("Wrote {}", command.out.string());
    const bool all_refused = std::all_of(rows.begin(), rows.end(),
                                         [](const nlohmann::json& row) { return row.contains("error"); });
    return all_refused ? k_bad_input : k_done;
}

int show_window(const ViewCommand& command, RunTrace* trace) {
    const fs::path& file = command.files[0];
    ModelView view = view_model(file, command.wishes);
    ViewSession session{view};
    const std::uint64_t frames = run_app({.title = "Rambla: " + file.filename().string(),
                                          .size_px = command.options.size_px,
                                          .walking = false,
                                          .quiet = command.options.quiet,
                                          .frames = command.frames,
                                          .trace = trace,
                                          .overlay_part =
                                              [&session] {
                                                  session.draw_overlay_part();
                                              }},
                                         view.stage, view.settings,
                                         [&session](const Moment& moment) { return session.update(moment); });
    nlohmann::json json = clip_facts(view.stage);
    json["schema"] = "rambla.view/1";
    json["file"] = file.string();
    json["frames"] = frames;
    write_json(command.options.json, json);
    return k_done;
}

/// For CLI11: what is wrong with a number, if anything.
std::string finite_number(const std::string& text) {
    try {
        if (std::isfinite(std::stod(text))) return {};
    } catch (const std::exception&) {
        // no number at all
    }
    return fmt::format("found '{}', expected a finite number of seconds", text);
}

/// Where the picture goes: what --out says, else a place in out/.
fs::path picture_file(const ViewCommand& command) {
    const bool sheet = command.files.size() > 1;
    if (command.out.empty())
        return fs::path{"out"} / (sheet ? "sheet" : command.files[0].stem()).concat(".png");
    const std::string extension = command.out.extension().string();
    if (extension == ".png" || (extension == ".exr" && !sheet)) return command.out;
    throw std::invalid_argument{fmt::format("--out is '{}', expected a name that ends in .png{}",
                                            command.out.string(), sheet ? "" : " or .exr")};
}

int run(ViewCommand& command) {
    prepare_json(command.options.json);
    const tbb::global_control limit = worker_limit(command.options);
    const bool sheet = command.files.size() > 1;
    if (sheet && command.frames > 0) throw std::invalid_argument{"--frames is for one file in a window"};
    if (sheet && !command.options.trace.empty()) throw std::invalid_argument{"--trace is for one file"};
    if (sheet && command.size->count() == 0) command.options.size_px = k_cell_px;
    const bool windowed = !sheet && !command.options.headless && command.out.empty() && has_display();
    command.wishes.plays = windowed;
    command.wishes.size_px = command.options.size_px;
    command.wishes.origin = command.options.origin;
    command.wishes.settings = command.options.settings;
    command.wishes.own_shadows = command.shadows->count() > 0;
    command.wishes.own_exposure = command.options.own_exposure;
    if (command.options.time_given->count() > 0) command.wishes.time = command.options.time;
    if (!windowed) command.out = picture_file(command);
    const std::unique_ptr<RunTrace> trace = begin_trace(command.options.trace);
    const int exit_code = windowed ? show_window(command, trace.get())
                          : sheet  ? draw_sheet(command)
                                   : draw_picture(command, trace.get());
    if (trace) trace->finish();
    return exit_code;
}

}  // namespace

Command add_view(CLI::App& program) {
    CLI::App* const line = program.add_subcommand("view", "Shows a glTF file, in a window or as a picture");
    const auto command = std::make_shared<ViewCommand>();
    Options& options = command->options;
    // Who looks at a model wants to see how light or dark it is, and to compare it with others on a sheet.
    options.settings.exposure.mode = render::ExposureMode::fixed;
    line->footer(
        "Looks through the file's first camera, or shows everything if it has none. The light is the file's "
        "own with a\n"
        "soft sky, or that of the time that `generate` wrote; a file without lights stands in the noon sun. "
        "--time "
        "replaces sun and sky, whatever the "
        "file has.\n"
        "Opens a window where there is a display, unless --headless or --out is given. In the window the "
        "left button\n"
        "turns around the model, the wheel comes nearer; F1 shows the keys. The first clip plays there, or "
        "that "
        "of --clip;\n"
        "a picture shows the file's own pose unless --clip or --clip-time is given. A file's camera moves as "
        "its clips say.\n"
        "Exposure is fixed unless --exposure auto is given.\n"
        "Several files become one picture, a cell of --size (default 320x240) for each; what cannot be shown "
        "there gets a\n"
        "cell with the reason; if nothing can be shown, the exit code is 2.\n");
    line->add_option("files", command->files, "File to show; several: a contact sheet of them")
        ->type_name("FILE.glb|FILE.gltf")
        ->required();
    CLI::Option* const out =
        line->add_option("-o,--out", command->out,
                         "Picture to write: .png as a screen shows it, .exr linear light")
            ->type_name("FILE");
    CLI::Option* const headless = line->add_flag("--headless", options.headless,
                                                 "Draws without a window; into out/ unless --out says where");
    line->add_option("--camera", command->wishes.camera, "Looks through the file's camera number N, from 0")
        ->type_name("N")
        ->transform(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
    line->add_option("--clip", command->wishes.clip,
                     "Shows the clip of that name, or of that number, from 0 (rambla inspect lists them)")
        ->type_name("NAME");
    line->add_option("--clip-time", command->wishes.clip_time_s,
                     "Shows the clip (default: the first) at that time; beyond its ends it starts over")
        ->type_name("S")
        ->check(CLI::Validator{finite_number, "", "a finite number"});
    line->add_option("--frames", command->frames, "Window only: closes it after so many pictures")
        ->type_name("N")
        ->transform(whole_number())
        ->excludes(headless)
        ->excludes(out);
    add_time_option(*line, options);
    add_place_options(*line, options);
    add_picture_options(*line, options);
    add_trace_option(*line, options);
    add_message_options(*line, options);
    command->shadows = line->get_option("--shadows");
    command->size = line->get_option("--size");
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
