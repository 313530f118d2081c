#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "game/commands/command.h"
#include "game/compare.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/options.h"
#include "game/process_memory.h"
#include "game/run_trace.h"
#include "game/stage.h"
#include "game/state_file.h"
#include "game/walk_render.h"

namespace rambla::game {
namespace {

struct WalkCommand {
    Options options;
    WalkRender render;
    bool no_render = false;
    bool compare = false;
    const CLI::Option* frames_given = nullptr;
    const CLI::Option* size_given = nullptr;
    std::uint64_t steps = 600;
    std::string load_state;  ///< files; empty: none
    std::string save_state;
};

/// What every run of `walk` states, drawn or not.
nlohmann::json common_json(const WalkCommand& command, const Stage& stage, std::uint64_t steps) {
    return {{"schema", "rambla.walk/1"},
            {"scene", command.options.scene},
            {"seed", command.options.seed},
            {"time", to_text(command.options.time)},
            {"threads", worker_count()},
            {"worker_threads", systems::worker_threads(*stage.world)},
            {"steps", steps},
            {"entities", stage.world->entity_count()},
            {"state_hash", fmt::format("{:016x}", systems::state_hash(*stage.world))},
            {"memory_bytes", resident_bytes()}};
}

int simulate(const WalkCommand& command, Stage& stage) {
    if (!command.load_state.empty()) load_state_file(command.load_state, stage, command.options);
    if (command.render.trace) command.render.trace->listen_to(*stage.world);
    for (std::uint64_t i = 0; i < command.steps; ++i)
        systems::step(*stage.world);
    if (!command.save_state.empty()) save_state_file(command.save_state, stage, command.options);
    const nlohmann::json result = common_json(command, stage, command.steps);
    print_result(command.options.json,
                 fmt::format("{} steps, {} entities, state {}\n", command.steps, stage.world->entity_count(),
                             result["state_hash"].get<std::string>()));
    write_json(command.options.json, result);
    return k_done;
}

int draw(WalkCommand& command, Stage& stage) {
    if (stage.walk.empty())
        throw std::invalid_argument{"scene " + command.options.scene + " has no walk to follow"};
    const WalkResult result = render_walk(stage, command.options, command.render);
    print_result(command.options.json, result.text);
    nlohmann::json json = common_json(command, stage, result.steps);
    json.update(result.json);
    write_json(command.options.json, json);
    spdlog::info("Frames, contact sheet and pass table are in {}", command.render.folder.string());
    const bool grew = command.render.stats && result.steadiness.known && !result.steadiness.steady;
    return grew ? k_check_failed : k_done;
}

int compare(WalkCommand& command, Stage& stage) {
    if (command.size_given->count() == 0) command.options.size_px = k_compare_size_px;
    const std::uint32_t frames = command.frames_given->count() > 0 ? command.render.frames : k_compare_frames;
    const CompareMeasures measures = run_compare(stage, command.options, frames);
    print_result(command.options.json, compare_text(measures));
    nlohmann::json json = common_json(command, stage, frames);
    json.update(compare_json(measures));
    write_json(command.options.json, json);
    return k_done;
}

int run(WalkCommand& command) {
    prepare_json(command.options.json);
    const std::unique_ptr<RunTrace> trace = begin_trace(command.options.trace);
    command.render.trace = trace.get();
    const tbb::global_control limit = worker_limit(command.options);
    const auto start = std::chrono::steady_clock::now();
    Stage stage =
        make_stage(command.options.scene, command.options.seed, command.options.time, command.options.origin);
    command.render.generating_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const int exit_code = command.no_render ? simulate(command, stage)
                          : command.compare ? compare(command, stage)
                                            : draw(command, stage);
    if (trace) trace->finish();
    return exit_code;
}

}  // namespace

Command add_walk(CLI::App& program) {
    CLI::App* const line =
        program.add_subcommand("walk", "Walks through a scene along its script, into pictures");
    const auto command = std::make_shared<WalkCommand>();
    Options& options = command->options;
    line->footer(
        "The frames are spread evenly over the whole walk, whatever their number; between two of them the "
        "simulation\n"
        "takes the fixed steps of 1/60 s that lie there. So --frames stretches or thins the film (30 frames "
        "per second\n"
        "of the walk's duration play at its natural speed), and never changes the way.\n"
        "Frames, contact sheet and pass table go to the folder of --out. Timers slow drawing down, so the "
        "walk itself is\n"
        "drawn without; then --profile-frames of it are drawn again with timers, for the table.\n"
        "Opens a window where there is a display, unless --headless.\n");
    add_scene_options(*line, options);
    add_time_option(*line, options);
    add_place_options(*line, options);
    command->frames_given =
        line->add_option("--frames", command->render.frames,
                         fmt::format("How many pictures of the walk (--compare: {})", k_compare_frames))
            ->type_name("N")
            ->transform(whole_number(1, 1'000'000))
            ->capture_default_str();
    CLI::Option* const out = line->add_option("-o,--out", command->render.folder,
                                              "Folder for the results; frames of an earlier walk there go")
                                 ->type_name("DIR")
                                 ->capture_default_str();
    CLI::Option* const format =
        line->add_option("--format", command->render.format,
                         "png shows what a screen shows; exr holds linear light as well")
            ->type_name("png|exr")
            ->check(CLI::IsMember({"png", "exr"}))
            ->capture_default_str();
    line->add_flag("--headless", options.headless, "Draws without a window, even where there is a display");
    CLI::Option* const profile = line->add_option("--profile-frames", command->render.profile_frames,
                                                  "Frames drawn again with timers; 0: no table")
                                     ->type_name("N")
                                     ->transform(whole_number(0, 10'000))
                                     ->capture_default_str();
    CLI::Option* const graph =
        line->add_option("--graph", command->render.graph,
                         "Draws the passes of the first frame and what flows between them")
            ->type_name("FILE.svg");
    CLI::Option* const stats = line->add_flag("--stats", command->render.stats,
                                              "Prints memory and GL objects along the way; ends "
                                              "with 1 if they grow after frame 50");
    CLI::Option* const no_render =
        line->add_flag("--no-render", command->no_render, "Only simulates, --steps of it");
    no_render->excludes(stats);
    line->add_option("--steps", command->steps, "Simulation steps of 1/60 s; with --no-render")
        ->type_name("N")
        ->transform(whole_number())
        ->needs(no_render)
        ->capture_default_str();
    line->add_option("--load-state", command->load_state,
                     "Goes on from a saved state of the same scene, seed, time and origin; with --no-render")
        ->type_name("FILE")
        ->needs(no_render);
    line->add_option("--save-state", command->save_state,
                     "Saves the state after the steps, for --load-state; with --no-render")
        ->type_name("FILE")
        ->needs(no_render);
    add_picture_options(*line, options);
    CLI::Option* const trace = add_trace_option(*line, options);
    add_message_options(*line, options);
    command->size_given = line->get_option("--size");
    CLI::Option* const compare = line->add_flag(
        "--compare", command->compare,
        fmt::format(
            "Measures as other engines are measured: no window, {}x{}, {} frames of which the first fifth is "
            "not counted, each complete before the next begins; every effect that the comparison names is "
            "on; "
            "writes no pictures",
            k_compare_size_px.x, k_compare_size_px.y, k_compare_frames));
    for (CLI::Option* const other :
         {no_render, stats, out, format, profile, graph, trace, line->get_option("--shadows"),
          line->get_option("--aa"), line->get_option("--exposure"), line->get_option("--bloom")})
        compare->excludes(other);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
