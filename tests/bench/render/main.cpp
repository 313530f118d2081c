// Times of the renderer's passes, by lighting path, size of the picture and number of lights, or by grade of
// surface detail.
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "bench/harness/machine.h"
#include "bench/render/detail.h"
#include "bench/render/measure.h"
#include "bench/render/table.h"
#include "game/scene_cache.h"
#include "game/size.h"

namespace {

using namespace rambla;

struct Options {
    std::vector<std::string> sizes{"480x270", "960x540", "1280x720", "1920x1080"};
    std::vector<std::uint32_t> lights{1, 16, 64, 256, 1024};
    std::uint32_t rounds = 5;
    bool quick = false;
    bool detail = false;
    std::string json;
};

/// What is drawn with so many lights: from above, and where lights are 64, also from below and with two suns.
std::vector<bench::Setting> settings_of(std::uint32_t lights, glm::uvec2 size_px) {
    using bench::View;
    std::vector<bench::Setting> settings{
        {.view = View::above, .size_px = size_px, .lights = lights, .costs = {}}};
    if (lights == 64) {
        settings.push_back(
            {.view = View::above, .size_px = size_px, .lights = lights, .suns = 2, .costs = {}});
        settings.push_back({.view = View::below, .size_px = size_px, .lights = lights, .costs = {}});
    }
    return settings;
}

void measure(bench::Setting& setting, render::RenderThread& thread, std::uint32_t rounds) {
    game::Stage stage = bench::blocks_with_lights(setting.lights, setting.suns);
    game::hand_over(game::prepare_scene(*stage.scene, thread.device(), true), stage, thread);
    thread.finish();
    setting.costs =
        bench::measure(stage, thread, bench::ways(setting.lights), setting.view, setting.size_px, rounds);
}

/// Opened before anything is measured, which takes minutes.
std::ofstream opened(const std::string& path) {
    std::ofstream file{path};
    if (!path.empty() && !file) throw std::runtime_error{"cannot write '" + path + "'"};
    return file;
}

void write_json(std::ofstream& file, const nlohmann::json& settings, const bench::Machine& machine) {
    nlohmann::json json{{"schema", "rambla.bench.render/1"}, {"settings", settings}};
    for (const auto& [name, value] : machine)
        json["machine"][name] = value;
    file << json.dump(1) << '\n';
    file.close();
    if (!file) throw std::runtime_error{"the results cannot be written"};
}

nlohmann::json measure_lights(const Options& options, render::RenderThread& thread) {
    std::vector<bench::Setting> measured;
    for (const std::string& size : options.sizes) {
        for (const std::uint32_t lights : options.lights) {
            for (bench::Setting& setting : settings_of(lights, game::parse_size(size))) {
                measure(setting, thread, options.rounds);
                std::fputs((bench::to_text(setting) + "\n").c_str(), stdout);
                std::fflush(stdout);
                measured.push_back(std::move(setting));
            }
        }
    }
    std::fputs(bench::verdict(measured).c_str(), stdout);
    nlohmann::json json = nlohmann::json::array();
    for (const bench::Setting& setting : measured)
        json.push_back(bench::to_json(setting));
    return json;
}

nlohmann::json measure_detail(const Options& options, render::RenderThread& thread) {
    nlohmann::json json = nlohmann::json::array();
    for (const std::string& text : options.sizes) {
        const glm::uvec2 size_px = game::parse_size(text);
        const std::vector<bench::DetailCost> costs = bench::measure_detail(thread, size_px, options.rounds);
        std::fputs((bench::to_text(costs, size_px) + "\n").c_str(), stdout);
        std::fflush(stdout);
        for (const bench::DetailCost& cost : costs)
            json.push_back(bench::to_json(cost, size_px));
    }
    return json;
}

int run(const Options& options) {
    std::ofstream file = opened(options.json);
    const bench::Machine machine = bench::this_machine(static_cast<int>(std::thread::hardware_concurrency()));
    render::RenderThread thread{
        {.window = {}, .shaders = {}, .gl_errors_throw = false, .compile_ahead = false, .compile_for = {}}};
    std::fputs(bench::to_text(machine).c_str(), stdout);
    std::fputs(fmt::format("\nrenderer          {}\n\n", thread.device().renderer).c_str(), stdout);
    const nlohmann::json measured =
        options.detail ? measure_detail(options, thread) : measure_lights(options, thread);
    if (!options.json.empty()) write_json(file, measured, machine);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{
        "Milliseconds per pass of the scene `blocks`, for each lighting path, or of the street, for each "
        "grade "
        "of surface detail."};
    app.add_option("--size", options.sizes, "Sizes of the picture.")->delimiter(',')->capture_default_str();
    app.add_option("--lights", options.lights, "Numbers of point lights.")
        ->delimiter(',')
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    app.add_option("--rounds", options.rounds, "Pictures that are measured each way.")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_flag("--detail", options.detail,
                 "Grades of surface detail in the street instead: their cost, and how far their pictures are "
                 "from those of the finest.")
        ->excludes("--lights");
    app.add_flag("--quick", options.quick,
                 "Three rounds of 480x270 and 1280x720, where nothing else is asked for.");
    app.add_option("--json", options.json, "Writes all values to this file, too.");
    try {
        app.parse(argc, argv);
        if (options.quick) {
            if (app.count("--rounds") == 0) options.rounds = 3;
            if (app.count("--size") == 0) options.sizes = {"480x270", "1280x720"};
        }
        return run(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
