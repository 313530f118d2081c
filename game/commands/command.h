#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>

namespace rambla::game {

/// A sub-command: its part of the command line, and what it does once that is read. `run` returns the exit
/// code.
struct Command {
    CLI::App* line = nullptr;
    std::function<int()> run;
};

[[nodiscard]] Command add_walk(CLI::App& program);
[[nodiscard]] Command add_play(CLI::App& program);
[[nodiscard]] Command add_view(CLI::App& program);
[[nodiscard]] Command add_generate(CLI::App& program);
[[nodiscard]] Command add_inspect(CLI::App& program);
[[nodiscard]] Command add_study(CLI::App& program);
[[nodiscard]] Command add_doctor(CLI::App& program);

}  // namespace rambla::game
