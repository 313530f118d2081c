#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/Option.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "game/app.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/options.h"
#include "game/play_session.h"
#include "game/run_trace.h"
#include "game/window.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

struct PlayCommand {
    Options options;
    std::uint64_t frames = 0;
};

nlohmann::json final_state(const PlayCommand& command, const Stage& stage, const PlaySession& session,
                           std::uint64_t frames) {
    const Player& player = session.player();
    const systems::WorldPosition eye = eye_of(player, player, 1.0f).place;
    const glm::vec3 eye_m = systems::offset_m(stage.origin, eye);
    return {{"schema", "rambla.play/1"},
            {"scene", command.options.scene},
            {"seed", command.options.seed},
            {"time", to_text(command.options.time)},
            {"frames", frames},
            {"steps", session.steps()},
            {"eye_m", {eye_m.x, eye_m.y, eye_m.z}},
            {"yaw_deg", glm::degrees(player.yaw_rad)},
            {"pitch_deg", glm::degrees(player.pitch_rad)},
            {"state_hash", fmt::format("{:016x}", systems::state_hash(*stage.world))}};
}

int run(const PlayCommand& command) {
    const tbb::global_control limit = worker_limit(command.options);
    require_display();
    prepare_json(command.options.json);
    const std::unique_ptr<RunTrace> trace = begin_trace(command.options.trace);
    Stage stage =
        make_stage(command.options.scene, command.options.seed, command.options.time, command.options.origin);
    PlaySession session{stage};
    spdlog::info("F1 shows the keys, Esc quits");
    const std::uint64_t frames = run_app({.title = "Rambla",
                                          .size_px = command.options.size_px,
                                          .walking = true,
                                          .quiet = command.options.quiet,
                                          .frames = command.frames,
                                          .trace = trace.get()},
                                         stage, command.options.settings_at(stage.exposure_ev),
                                         [&session](const Moment& moment) { return session.update(moment); });
    write_json(command.options.json, final_state(command, stage, session, frames));
    if (trace) trace->finish();
    return k_done;
}

}  // namespace

Command add_play(CLI::App& program) {
    CLI::App* const line = program.add_subcommand("play", "Opens a window and lets you walk through a scene");
    const auto command = std::make_shared<PlayCommand>();
    std::string keys = "Keys:\n";
    for (const Control& control : controls()) {
        if (control.scope == ControlScope::viewing) continue;
        keys += fmt::format("    {:<24} {}\n", control.keys_text, control.help);
    }
    line->footer(keys);
    add_scene_options(*line, command->options);
    add_time_option(*line, command->options);
    add_place_options(*line, command->options);
    line->add_option("--frames", command->frames, "Ends after so many pictures (default: when you quit)")
        ->type_name("N")
        ->transform(whole_number());
    add_picture_options(*line, command->options);
    add_trace_option(*line, command->options);
    add_message_options(*line, command->options);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
