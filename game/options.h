#pragma once

#include <tbb/global_control.h>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "assets/daylight.h"
#include "render/settings.h"
#include "systems/components.h"

namespace rambla::game {

/// What commands share; each command adds the groups that mean something to it.
struct Options {
    std::string scene = "city";
    std::uint64_t seed = 1;
    assets::TimeOfDay time;
    systems::WorldPosition origin;
    glm::uvec2 size_px{960, 540};
    bool headless = false;
    int threads = 0;  ///< 0: as many as the machine has
    std::string json;
    std::filesystem::path trace;  ///< empty: none
    bool quiet = false;
    render::Settings settings;
    const CLI::Option* time_given = nullptr;  ///< --time, where the command has it
    bool own_exposure = false;                ///< the user has said an EV

    /// The settings, at the exposure that the light wants unless the user has said another.
    [[nodiscard]] render::Settings settings_at(float exposure_ev) const;
};

void add_scene_options(CLI::App& command, Options& options);    ///< --scene --seed
void add_time_option(CLI::App& command, Options& options);      ///< --time
void add_place_options(CLI::App& command, Options& options);    ///< --origin --threads
void add_picture_options(CLI::App& command, Options& options);  ///< --size and every algorithm's own option
/// --trace, for what draws or simulates.
CLI::Option* add_trace_option(CLI::App& command, Options& options);
void add_message_options(CLI::App& command, Options& options);  ///< --json --quiet

/// Holds oneTBB to --threads while it lives.
[[nodiscard]] tbb::global_control worker_limit(const Options& options);
/// How many threads work now.
[[nodiscard]] std::size_t worker_count();

/// For CLI::Option::transform() of every option that counts: digits alone, read as decimal. CLI11 itself
/// lets -1 wrap around to 2^64 - 1 and reads 010 as 8.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least = 0,
                                          std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Runs a parser of option text, and turns std::invalid_argument into a usage error that names the option.
template <class Parse>
auto usage_checked(const std::string& option, Parse&& parse) {
    try {
        return parse();
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError{option, error.what()};
    }
}

}  // namespace rambla::game
