#include "bench/render/detail.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/render/measure.h"
#include "game/scene_cache.h"
#include "game/statistics.h"

namespace rambla::bench {
namespace {

using game::median;
using render::DetailGrade;

constexpr std::string_view k_pass = "gbuffer";
constexpr int k_reference_steps = 128;

std::vector<DetailCost> grades() {
    const auto grade = [](std::string name, DetailGrade of, int steps = 16) {
        return DetailCost{.name = std::move(name),
                          .detail = {.grade = of, .steps = steps},
                          .surfaces_ms = {},
                          .frame_ms = {},
                          .rms_error = {},
                          .differing = {}};
    };
    return {grade("flat", DetailGrade::flat),
            grade("normal", DetailGrade::normal),
            grade("parallax", DetailGrade::parallax),
            grade("occlusion:steps=8", DetailGrade::occlusion, 8),
            grade("occlusion:steps=16", DetailGrade::occlusion, 16),
            grade("occlusion:steps=32", DetailGrade::occlusion, 32),
            grade("occlusion:steps=128", DetailGrade::occlusion, k_reference_steps)};
}

assets::Image picture(game::Stage& stage, render::RenderThread& thread, const render::Settings& settings,
                      const systems::Eye& eye) {
    return std::move(draw(stage, thread, settings, eye, true).display.value());
}

void compare(DetailCost& cost, const assets::Image& found, const assets::Image& reference) {
    double squared = 0.0;
    std::uint64_t differing = 0;
    for (std::size_t i = 0; i < found.texels.size(); i += 4) {
        int largest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int apart =
                std::to_integer<int>(found.texels[i + c]) - std::to_integer<int>(reference.texels[i + c]);
            squared += apart * apart;
            largest = std::max(largest, std::abs(apart));
        }
        differing += largest > 4 ? 1 : 0;
    }
    const double pixels = static_cast<double>(found.texels.size() / 4);
    cost.rms_error.push_back(std::sqrt(squared / (3.0 * pixels)) / 255.0);
    cost.differing.push_back(static_cast<double>(differing) / pixels);
}

double time_of(const systems::Feedback& feedback) {
    double ms = 0.0;
    for (const systems::PassTiming& pass : feedback.passes)
        if (pass.name == k_pass) ms += pass.gpu_ms;
    return ms;
}

}  // namespace

std::vector<DetailCost> measure_detail(render::RenderThread& thread, glm::uvec2 size_px,
                                       std::uint32_t rounds) {
    game::Stage stage = game::make_stage("street", 1, assets::TimeOfDay{}, {});
    game::hand_over(game::prepare_scene(*stage.scene, thread.device(), true), stage, thread);
    thread.finish();
    std::vector<DetailCost> costs = grades();
    const float walk_s = stage.walk.back().time_s;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        systems::Eye eye =
            game::walk_eye(stage, walk_s * static_cast<float>(round) / static_cast<float>(rounds));
        eye.size_px = size_px;
        render::Settings settings;
        settings.detail = {.grade = DetailGrade::occlusion, .steps = k_reference_steps};
        const assets::Image reference = picture(stage, thread, settings, eye);
        for (DetailCost& cost : costs) {
            settings.detail = cost.detail;
            compare(cost, picture(stage, thread, settings, eye), reference);
        }
        // In another order each time: what runs first after pictures were taken may find other caches.
        std::rotate(costs.begin(), costs.begin() + 1, costs.end());
        for (DetailCost& cost : costs) {
            settings.detail = cost.detail;
            const systems::Feedback feedback = draw(stage, thread, settings, eye, false).feedback;
            cost.surfaces_ms.push_back(time_of(feedback));
            cost.frame_ms.push_back(feedback.gpu_frame_ms);
        }
    }
    const auto turns = static_cast<std::ptrdiff_t>(rounds % costs.size());
    std::rotate(costs.begin(), costs.end() - turns, costs.end());
    return costs;
}

std::string to_text(const std::vector<DetailCost>& costs, glm::uvec2 size_px) {
    std::string text = fmt::format(
        "street, {}x{}, surface detail: medians of {} pictures along the walk; apart from the last\n",
        size_px.x, size_px.y, costs.front().frame_ms.size());
    text += fmt::format("{:<22}{:>12}{:>12}{:>12}{:>12}{:>14}\n", "grade", "gbuffer ms", "/ normal",
                        "frame ms", "RMS apart", "> 4/255");
    const auto normal = std::find_if(costs.begin(), costs.end(),
                                     [](const DetailCost& cost) { return cost.name == "normal"; });
    for (const DetailCost& cost : costs) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < cost.surfaces_ms.size(); ++i)
            ratios.push_back(cost.surfaces_ms[i] / normal->surfaces_ms[i]);
        text += fmt::format("{:<22}{:>12.2f}{:>12.2f}{:>12.2f}{:>12.5f}{:>13.3f}%\n", cost.name,
                            median(cost.surfaces_ms), median(ratios), median(cost.frame_ms),
                            median(cost.rms_error), 100.0 * median(cost.differing));
    }
    return text;
}

nlohmann::json to_json(const DetailCost& cost, glm::uvec2 size_px) {
    return {{"scene", "street"},
            {"detail", cost.name},
            {"width_px", size_px.x},
            {"height_px", size_px.y},
            {"gbuffer_ms", cost.surfaces_ms},
            {"frame_ms", cost.frame_ms},
            {"rms_error", cost.rms_error},
            {"differing", cost.differing}};
}

}  // namespace rambla::bench
