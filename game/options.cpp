#include "game/options.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <tbb/info.h>

#include <CLI/Error.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <span>
#include <string_view>

#include "game/origin.h"
#include "game/parameters.h"
#include "game/size.h"
#include "game/time_of_day.h"

namespace rambla::game {
namespace {

/// --NAME CHOICE:field=value,… for all of a struct; the fields are explained at the end of --help.
template <class Struct, std::size_t Count>
void add_method_option(CLI::App& command, const std::string& name,
                       const std::array<Parameter<Struct>, Count>& table, Struct& object) {
    const std::vector<BoundParameter> parameters = bind(table, object);
    const bool has_fields = parameters.size() > 1;
    command
        .add_option_function<std::string>(
            name,
            [name, parameters](const std::string& text) {
                usage_checked(name, [&] { set_from_method_text(parameters, text); });
            },
            fmt::format("{} ({}; default {})", parameters.front().help, expected_text(parameters.front()),
                        value_text(parameters.front())))
        ->type_name(has_fields ? "METHOD[:name=value,...]" : "METHOD")
        ->group("Algorithms");
    if (!has_fields) return;
    command.footer(fmt::format("{}{} METHOD:name=value,... knows these names:\n{}", command.get_footer(),
                               name, help_text(std::span{parameters}.subspan(1))));
}

/// --NAME field=value,… for a struct that is no choice of a method.
template <class Struct, std::size_t Count>
void add_fields_option(CLI::App& command, const std::string& name, std::string_view help,
                       const std::array<Parameter<Struct>, Count>& table, Struct& object) {
    const std::vector<BoundParameter> parameters = bind(table, object);
    command
        .add_option_function<std::string>(
            name,
            [name, parameters](const std::string& text) {
                usage_checked(name, [&] { set_from_method_text(parameters, text); });
            },
            std::string{help})
        ->type_name("name=value,...")
        ->group("Algorithms");
    command.footer(fmt::format("{}{} name=value,... knows these names:\n{}", command.get_footer(), name,
                               help_text(parameters)));
}

/// What --exposure says, where a number alone stands for `fixed:ev=` that number.
std::string exposure_method_text(const std::string& text) {
    const std::string_view number = std::string_view{text}.substr(text.starts_with('+') ? 1 : 0);
    double ev = 0.0;
    const char* const end = number.data() + number.size();
    if (!number.empty() && std::from_chars(number.data(), end, ev).ptr == end) {
        return fmt::format("fixed:ev={}", number);
    }
    const std::string_view method = std::string_view{text}.substr(0, text.find(':'));
    const auto& modes = render::k_exposure_modes;
    const bool is_method = std::find(modes.begin(), modes.end(), method) != modes.end();
    if (is_method || method.find('=') != std::string_view::npos) return text;
    throw std::invalid_argument{
        fmt::format("exposure is '{}', expected a number of EV or one of: {}", text, fmt::join(modes, ", "))};
}

/// --exposure EV, or as any other method.
void add_exposure_option(CLI::App& command, Options& options) {
    add_method_option(command, "--exposure", render::k_exposure_parameters, options.settings.exposure);
    command.get_option("--exposure")
        ->type_name("EV|METHOD[:name=value,...]")
        ->transform(CLI::Validator{[&options](std::string& text) {
                                       try {
                                           text = exposure_method_text(text);
                                       } catch (const std::invalid_argument& error) {
                                           return std::string{error.what()};
                                       }
                                       if (text.find("ev=") != std::string::npos) options.own_exposure = true;
                                       return std::string{};
                                   },
                                   ""});
}

}  // namespace

render::Settings Options::settings_at(float exposure_ev) const {
    render::Settings chosen = settings;
    if (!own_exposure) chosen.exposure.ev = exposure_ev;
    return chosen;
}

void add_scene_options(CLI::App& command, Options& options) {
    command
        .add_option("--scene", options.scene,
                    "What is generated, with its parameters: city, city:blocks=2x2, street; or, to compare "
                    "engines with, "
                    "blocks, agents")
        ->type_name("SCENE")
        ->capture_default_str();
    command
        .add_option("--seed", options.seed, "Chooses among the places and crowds that the scene describes")
        ->type_name("N")
        ->transform(whole_number())
        ->capture_default_str();
}

void add_time_option(CLI::App& command, Options& options) {
    options.time_given =
        command
            .add_option_function<std::string>(
                "--time",
                [&options](const std::string& text) {
                    options.time = usage_checked("--time", [&] { return parse_time(text); });
                },
                fmt::format("Time of day, in solar time of a day in early June: dusk is {}, night {}, and "
                            "12:00 has the "
                            "sun where it stands then, noon (the default) where it draws good shadows",
                            to_text(assets::k_dusk), to_text(assets::k_night)))
            ->type_name("noon|dusk|night|HH:MM");
}

void add_place_options(CLI::App& command, Options& options) {
    command
        .add_option_function<std::string>(
            "--origin",
            [&options](const std::string& text) {
                options.origin = usage_checked("--origin", [&] { return parse_origin(text); });
            },
            "Puts the whole scene that far from (0,0,0), in metres: the picture stays the same, up to shadow "
            "texels at shadow edges and, unless X, Y and Z are multiples of 256, rounding at other edges")
        ->type_name("X,Y,Z");
    command
        .add_option("--threads", options.threads,
                    "Threads that simulate, pack and encode (default: all cores)")
        ->type_name("N")
        ->transform(whole_number(1, 1024));
}

void add_picture_options(CLI::App& command, Options& options) {
    command
        .add_option_function<std::string>(
            "--size",
            [&options](const std::string& text) {
                options.size_px = usage_checked("--size", [&] { return parse_size(text); });
            },
            fmt::format("Size of the picture in pixels (default {}x{})", options.size_px.x,
                        options.size_px.y))
        ->type_name("WIDTHxHEIGHT");
    add_method_option(command, "--lighting", render::k_lighting_parameters, options.settings.lighting);
    add_method_option(command, "--gbuffer", render::k_gbuffer_parameters, options.settings.gbuffer);
    add_method_option(command, "--detail", render::k_detail_parameters, options.settings.detail);
    add_method_option(command, "--brdf", render::k_brdf_parameters, options.settings.brdf);
    add_method_option(command, "--shadows", render::k_shadow_parameters, options.settings.shadows);
    add_exposure_option(command, options);
    add_method_option(command, "--tonemap", render::k_tone_parameters, options.settings.tone);
    add_method_option(command, "--bloom", render::k_bloom_parameters, options.settings.bloom);
    add_method_option(command, "--aa", render::k_anti_aliasing_parameters, options.settings.anti_aliasing);
    add_method_option(command, "--debug-view", render::k_debug_parameters, options.settings.debug);
    add_fields_option(command, "--textures", "How much of the scene's textures is on the graphics card",
                      render::k_texture_budget_parameters, options.settings.textures);
}

CLI::Option* add_trace_option(CLI::App& command, Options& options) {
    return command
        .add_option("--trace", options.trace,
                    "Writes when each system and each pass ran, and on which thread or the GPU; open it in "
                    "ui.perfetto.dev or chrome://tracing")
        ->type_name("FILE.json");
}

void add_message_options(CLI::App& command, Options& options) {
    command.add_option("--json", options.json, "Writes the results as one JSON object; - is standard output")
        ->type_name("FILE");
    command.add_flag("--quiet", options.quiet, "Says nothing but warnings, errors and results");
    command.parse_complete_callback([&options] {
        if (options.quiet) spdlog::set_level(spdlog::level::warn);
    });
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
    const bool open = most == std::numeric_limits<std::uint64_t>::max();
    const std::string expected = open ? fmt::format("a whole number >= {}", least)
                                      : fmt::format("a whole number from {} to {}", least, most);
    return CLI::Validator{[least, most, expected](std::string& text) {
                              std::uint64_t value = 0;
                              const char* const end = text.data() + text.size();
                              const auto [stop, error] = std::from_chars(text.data(), end, value);
                              if (error != std::errc{} || stop != end || value < least || value > most) {
                                  return fmt::format("found '{}', expected {}", text, expected);
                              }
                              text = std::to_string(value);
                              return std::string{};
                          },
                          ""};
}

tbb::global_control worker_limit(const Options& options) {
    const auto threads = options.threads > 0 ? static_cast<std::size_t>(options.threads)
                                             : static_cast<std::size_t>(tbb::info::default_concurrency());
    return tbb::global_control{tbb::global_control::max_allowed_parallelism, threads};
}

std::size_t worker_count() {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace rambla::game
