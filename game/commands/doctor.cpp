#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "assets/cache/cache.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/options.h"
#include "game/pass_table.h"
#include "game/scene_cache.h"
#include "game/schedule_report.h"
#include "game/window.h"
#include "render/gl/context.h"

namespace rambla::game {
namespace {

bool meets(const render::DeviceFeature& feature) {
    return feature.present || !feature.required;
}
bool meets(const render::DeviceLimit& limit) {
    return limit.value >= limit.required;
}

template <class Things>
void add_missing(const Things& things, std::vector<std::string>& advice) {
    for (const auto& thing : things) {
        if (meets(thing)) continue;
        advice.push_back(
            fmt::format("{} is missing or too small: Rambla cannot draw here. Update the graphics driver, "
                        "or use Mesa's software rasteriser (LIBGL_ALWAYS_SOFTWARE=1).",
                        thing.name));
    }
}

std::vector<std::string> advice_for(const render::DeviceInfo& device) {
    std::vector<std::string> advice;
    add_missing(device.features, advice);
    add_missing(device.limits, advice);
    if (device.software) {
        advice.push_back(
            "This is a rasteriser on the CPU: --size 640x360 and --shadows focused:size=1024,taps=4 are "
            "several times as fast; a GPU with OpenGL 4.5 is faster by far.");
    }
    if (!has_display()) {
        advice.push_back(
            "No display: `rambla walk` and `rambla view FILE --out F.png` draw into files; `rambla play` "
            "needs a desktop session or xvfb-run.");
    }
    return advice;
}

/// What is kept of processed scenes.
struct CacheState {
    std::filesystem::path folder = cache_folder();
    std::uint64_t bytes = assets::cache_bytes(folder);
};

std::string to_text(const render::DeviceInfo& device, const CacheState& cache,
                    const std::vector<std::string>& advice) {
    std::string text = fmt::format(
        "OpenGL    {}\nGLSL      {}\nrenderer  {} ({})\nvendor    {}\n"
        "processor {} threads\ndisplay   {}\ntextures  {}block-compressed: {}\n"
        "cache     {}, {} of at most {}\n\nfeatures\n",
        device.version, device.shading_language, device.renderer, device.software ? "software" : "hardware",
        device.vendor, std::thread::hardware_concurrency(), has_display() ? "yes" : "none",
        device.block_compression ? "" : "not ", device.block_compression_reason, cache.folder.string(),
        bytes_text(static_cast<double>(cache.bytes)), bytes_text(static_cast<double>(k_cache_limit_bytes)));
    for (const render::DeviceFeature& feature : device.features) {
        text += fmt::format("  {:<44} {}{}\n", feature.name, feature.present ? "yes" : "no",
                            feature.required ? " (required)" : "");
    }
    text += "\nlimits\n";
    for (const render::DeviceLimit& limit : device.limits) {
        text += fmt::format("  {:<44} {}", limit.name, limit.value);
        text += limit.required > 0 ? fmt::format(" (required: {})\n", limit.required) : "\n";
    }
    text += advice.empty() ? "\nnothing to advise\n" : "\nadvice\n";
    for (const std::string& line : advice)
        text += fmt::format("  - {}\n", line);
    return text;
}

nlohmann::json to_json(const render::DeviceInfo& device, const CacheState& cache,
                       const std::vector<std::string>& advice, bool good) {
    nlohmann::json features = nlohmann::json::array();
    for (const render::DeviceFeature& feature : device.features) {
        features.push_back(
            {{"name", feature.name}, {"present", feature.present}, {"required", feature.required}});
    }
    nlohmann::json limits = nlohmann::json::array();
    for (const render::DeviceLimit& limit : device.limits) {
        limits.push_back({{"name", limit.name}, {"value", limit.value}, {"required", limit.required}});
    }
    return {
        {"schema", "rambla.doctor/1"},
        {"good", good},
        {"version", device.version},
        {"shading_language", device.shading_language},
        {"renderer", device.renderer},
        {"vendor", device.vendor},
        {"software", device.software},
        {"display", has_display()},
        {"block_compression", device.block_compression},
        {"block_compression_reason", device.block_compression_reason},
        {"cache",
         {{"folder", cache.folder.string()}, {"bytes", cache.bytes}, {"limit_bytes", k_cache_limit_bytes}}},
        {"features", features},
        {"limits", limits},
        {"advice", advice}};
}

struct DoctorCommand {
    Options options;
    bool schedule = false;
};

int tell_schedule(const Options& options) {
    const std::vector<NamedPlan> plans = engine_plans();
    print_result(options.json, plans_text(plans));
    write_json(options.json, plans_json(plans));
    return k_done;
}

int run(const DoctorCommand& command) {
    const Options& options = command.options;
    prepare_json(options.json);
    if (command.schedule) return tell_schedule(options);
    const render::DeviceInfo device = render::query_device({});
    const bool good =
        std::all_of(device.features.begin(), device.features.end(), [](const auto& f) { return meets(f); }) &&
        std::all_of(device.limits.begin(), device.limits.end(), [](const auto& l) { return meets(l); });
    const std::vector<std::string> advice = advice_for(device);
    const CacheState cache;
    print_result(options.json, to_text(device, cache, advice));
    write_json(options.json, to_json(device, cache, advice, good));
    return good ? k_done : k_machine_lacks;
}

}  // namespace

Command add_doctor(CLI::App& program) {
    CLI::App* const line =
        program.add_subcommand("doctor", "Says what this machine offers, and what would help");
    const auto command = std::make_shared<DoctorCommand>();
    line->add_flag("--schedule", command->schedule,
                   "Tells instead which systems the engine runs, what they touch, and which wait for which "
                   "and why; needs no GPU");
    add_message_options(*line, command->options);
    return {line, [command] {
                return run(*command);
            }};
}

}  // namespace rambla::game
