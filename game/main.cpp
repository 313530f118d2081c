#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets/error.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "render/gl/context.h"

namespace {

using namespace rambla;

/// Standard output belongs to results: every message goes to standard error.
void set_up_messages() {
    spdlog::set_default_logger(spdlog::stderr_color_mt("rambla"));
    spdlog::set_pattern("%^%l%$: %v");
}

int fail(int exit_code, const std::exception& error) {
    spdlog::error("{}", error.what());
    return exit_code;
}

int run(const game::Command& command) {
    try {
        return command.run();
    } catch (const assets::Error& error) {
        return fail(game::k_bad_input, error);
    } catch (const std::invalid_argument& error) {
        return fail(game::k_bad_input, error);
    } catch (const game::MachineLacks& error) {
        return fail(game::k_machine_lacks, error);
    } catch (const render::MissingFeature& error) {
        return fail(game::k_machine_lacks, error);
    } catch (const std::bad_alloc&) {
        return fail(game::k_machine_lacks, std::runtime_error{"out of memory"});
    } catch (const std::exception& error) {
        return fail(game::k_check_failed, error);
    }
}

}  // namespace

int main(int argc, char** argv) {
    set_up_messages();
    CLI::App program{"Rambla: walks through large places full of people", "rambla"};
    program.set_version_flag("--version", RAMBLA_VERSION);
    program.require_subcommand(1);
    program.footer(
        "`rambla COMMAND --help` explains a command.\n"
        "Exit codes: 0 done, 1 failed check, 2 wrong usage or bad input, 3 this machine lacks something.\n");
    const std::vector<game::Command> commands{game::add_walk(program),    game::add_play(program),
                                              game::add_view(program),    game::add_generate(program),
                                              game::add_inspect(program), game::add_study(program),
                                              game::add_doctor(program)};
    const auto is_named = [&](const game::Command& command) {
        return command.line->get_name() == argv[1];
    };
    if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_named)) {
        return fail(game::k_bad_input, std::runtime_error{std::string{"there is no command '"} + argv[1] +
                                                          "' (rambla --help lists them)"});
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help and --version
        return fail(game::k_bad_input,
                    std::runtime_error{std::string{error.what()} + " (see rambla --help)"});
    }
    for (const game::Command& command : commands) {
        if (command.line->parsed()) return run(command);
    }
    return game::k_bad_input;
}
