#include "bench/render/table.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

#include "game/statistics.h"

namespace rambla::bench {
namespace {

using game::median;
using Series = std::vector<double> WayCost::*;

constexpr double k_wanted_of_tiled = 3.0;

const WayCost* find(const Setting& setting, std::string_view name) {
    const auto found = std::find_if(setting.costs.begin(), setting.costs.end(),
                                    [&](const WayCost& cost) { return cost.name == name; });
    return found == setting.costs.end() ? nullptr : &*found;
}

/// Median over the rounds of a / b: rounds show the same picture both ways.
double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i)
        ratios.push_back(b[i] > 0.0 ? a[i] / b[i] : 0.0);
    return median(ratios);
}

std::string line(const Setting& setting, std::string_view what,
                 const std::function<std::optional<double>(const WayCost&)>& value) {
    std::string text = fmt::format("{:<26}", what);
    for (const WayCost& cost : setting.costs) {
        const std::optional<double> found = value(cost);
        text += found ? fmt::format("{:>16.2f}", *found) : fmt::format("{:>16}", "-");
    }
    return text + "\n";
}

std::string sum_line(const Setting& setting, std::string_view what, Series series) {
    return line(setting, what, [&](const WayCost& cost) { return median(cost.*series); });
}

std::string ratio_line(const Setting& setting, std::string_view what, Series series) {
    const WayCost* const tiled = find(setting, "tiled");
    if (tiled == nullptr) return "";
    return line(setting, what, [&](const WayCost& cost) -> std::optional<double> {
        if (&cost == tiled) return std::nullopt;
        const double ratio = median_ratio(cost.*series, tiled->*series);
        return ratio > 0.0 ? std::optional{ratio} : std::nullopt;
    });
}

/// @return  the lighting of fullscreen / that of tiled
std::optional<double> gain_of_tiled(const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) {
        const bool meant = setting.view == View::above && setting.size_px == glm::uvec2{1280, 720} &&
                           setting.lights == 64 && setting.suns == 1;
        const WayCost* const tiled = find(setting, "tiled");
        const WayCost* const fullscreen = find(setting, "fullscreen");
        if (meant && tiled != nullptr && fullscreen != nullptr)
            return median_ratio(fullscreen->lighting, tiled->lighting);
    }
    return std::nullopt;
}

}  // namespace

std::string to_text(const Setting& setting) {
    std::string text =
        fmt::format("blocks, {}, {}x{}, {} lights, {} {}: ms, medians of {} pictures\n",
                    to_text(setting.view), setting.size_px.x, setting.size_px.y, setting.lights, setting.suns,
                    setting.suns == 1 ? "sun" : "suns", setting.costs.front().frame.size());
    text += fmt::format("{:<26}", "pass");
    std::set<std::string> names;
    for (const WayCost& cost : setting.costs) {
        text += fmt::format("{:>16}", cost.name);
        for (const auto& [name, ms] : cost.passes)
            names.insert(name);
    }
    text += "\n";
    for (const std::string& name : names) {
        text += line(setting, name, [&](const WayCost& cost) -> std::optional<double> {
            const auto found = cost.passes.find(name);
            return found == cost.passes.end() ? std::nullopt : std::optional{median(found->second)};
        });
    }
    text += sum_line(setting, "(missing)", &WayCost::missing);
    text += sum_line(setting, "frame", &WayCost::frame);
    text += sum_line(setting, "of it: lighting alone", &WayCost::lighting);
    text += sum_line(setting, "of it: geometry + lighting", &WayCost::surfaces);
    text += sum_line(setting, "CPU of the render thread", &WayCost::cpu);
    text += ratio_line(setting, "lighting / tiled", &WayCost::lighting);
    text += ratio_line(setting, "geometry+lighting / tiled", &WayCost::surfaces);
    text += ratio_line(setting, "frame / tiled", &WayCost::frame);
    return text;
}

nlohmann::json to_json(const Setting& setting) {
    nlohmann::json json{{"scene", "blocks"},
                        {"view", to_text(setting.view)},
                        {"width_px", setting.size_px.x},
                        {"height_px", setting.size_px.y},
                        {"lights", setting.lights},
                        {"suns", setting.suns},
                        {"ways", nlohmann::json::array()}};
    for (const WayCost& cost : setting.costs)
        json["ways"].push_back({{"name", cost.name},
                                {"passes_ms", cost.passes},
                                {"lighting_ms", cost.lighting},
                                {"surfaces_ms", cost.surfaces},
                                {"frame_ms", cost.frame},
                                {"missing_ms", cost.missing},
                                {"cpu_ms", cost.cpu}});
    return json;
}

std::string verdict(const std::vector<Setting>& settings) {
    const std::optional<double> gain = gain_of_tiled(settings);
    if (!gain) return "";
    return fmt::format(
        "lighting of blocks from above, 64 lights, 1280x720: tiled is {:.2f} times as fast as fullscreen, "
        "wanted "
        "{:.1f}: {}\n",
        *gain, k_wanted_of_tiled, *gain >= k_wanted_of_tiled ? "holds" : "MISSED");
}

}  // namespace rambla::bench
