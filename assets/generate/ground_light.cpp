#include "assets/generate/ground_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "assets/generate/building.h"
#include "assets/process/srgb.h"

namespace rambla::assets::generate {

namespace {

std::uint32_t texels(float length_m, float texel_m) {
    return static_cast<std::uint32_t>(std::ceil(length_m / texel_m)) + 1;
}

/// Rows of a chart that reaches so far from the façade, and one more that stays dark.
std::uint32_t depth_texels(float depth_m, float texel_m) {
    return texels(depth_m - k_first_t_m, texel_m) + 1;
}

/// How much of the light is kept at a place of the ground.
double kept(const GroundCharts& charts, const StreetPlan& plan, glm::vec3 place) {
    if (charts.cell_half_m == 0.0f) return 1.0;
    const double to_rim = charts.cell_half_m - std::max(std::abs(place.x), std::abs(place.z));
    const double width = 0.5 * plan.street_width_m;
    return glow_fade(width - to_rim, width);
}

/// Sums up what reaches a place of the world.
glm::dvec3 glow_at(glm::vec3 place, std::span<const ShopWindow> windows, const GlowReach& reach) {
    glm::dvec3 sum{0.0};
    for (const ShopWindow& window : windows)
        sum += glow_on_ground(window, place, reach);
    return sum;
}

}  // namespace

const GroundChart& GroundCharts::chart_at(glm::vec3 place) const {
    const auto distance = [&](const GroundChart& chart) {
        return chart.frame.local(place).z;
    };
    return *std::max_element(charts.begin(), charts.end(), [&](const GroundChart& a, const GroundChart& b) {
        return distance(a) < distance(b);
    });
}

glm::vec2 GroundCharts::uv(const GroundChart& chart, glm::vec3 place) const {
    const glm::vec3 local = chart.frame.local(place);
    const glm::vec2 texel = glm::vec2{local.x - chart.s_min_m, local.z - k_first_t_m} / texel_m;
    return (glm::vec2{chart.first} + 0.5f + texel) / glm::vec2{size};
}

GroundCharts block_ground_charts(const StreetPlan& plan, float texel_m) {
    GroundCharts result{.charts = {}, .texel_m = texel_m, .size = {}, .cell_half_m = 0.5f * plan.pitch_m()};
    constexpr float k_quarter_rad = 1.57079633f;
    const float half = 0.5f * plan.block_m;
    const float side_m = plan.pitch_m();
    // As far as the gutter, a chamfer widens by tan(22.5°) at both ends; the road beyond narrows to a point.
    const float chamfer_m = std::sqrt(2.0f) * k_chamfer_m + 0.83f * (plan.pavement_m() + k_gutter_m);
    const glm::uvec2 side{texels(side_m, texel_m), depth_texels(0.5f * plan.street_width_m, texel_m)};
    // The windows of both sides light the corner as far as their reach ahead and beside.
    const GlowReach reach = glow_reach(plan);
    const float corner_m = std::sqrt(0.5f) * (reach.ahead_m + reach.beside_m);
    const glm::uvec2 chamfer{texels(chamfer_m, texel_m), depth_texels(corner_m, texel_m)};
    result.size = {std::max(side.x, 4 * chamfer.x), 4 * side.y + chamfer.y};
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Frame turn = turned({0.0f, 0.0f, 0.0f}, k_quarter_rad * static_cast<float>(i));
        result.charts.push_back({.frame = turn * turned({0.0f, 0.0f, half}, 0.0f),
                                 .s_min_m = -0.5f * side_m,
                                 .s_max_m = 0.5f * side_m,
                                 .first = {0, i * side.y},
                                 .count = side});
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Frame turn = turned({0.0f, 0.0f, 0.0f}, k_quarter_rad * static_cast<float>(i));
        const float middle = half - 0.5f * k_chamfer_m;
        result.charts.push_back({.frame = turn * turned({middle, 0.0f, middle}, 0.5f * k_quarter_rad),
                                 .s_min_m = -0.5f * chamfer_m,
                                 .s_max_m = 0.5f * chamfer_m,
                                 .first = {i * chamfer.x, 4 * side.y},
                                 .count = chamfer});
    }
    return result;
}

GroundCharts edge_ground_charts(const StreetPlan& plan, float length, float texel_m) {
    const glm::uvec2 size{texels(length, texel_m), depth_texels(0.5f * plan.street_width_m, texel_m)};
    return {.charts = {{.frame = {}, .s_min_m = 0.0f, .s_max_m = length, .first = {}, .count = size}},
            .texel_m = texel_m,
            .size = size,
            .cell_half_m = 0.0f};
}

GlowReach glow_reach(const StreetPlan& plan) {
    constexpr float k_most_m = 6.0f;
    return {.ahead_m = std::min(0.5f * plan.street_width_m, k_most_m), .beside_m = k_most_m};
}

GroundLight bake_ground(const GroundCharts& charts, const StreetPlan& plan, const Frame& at,
                        std::span<const ShopWindow> windows) {
    const GlowReach reach = glow_reach(plan);
    std::vector<glm::vec3> light(std::size_t{charts.size.x} * charts.size.y, glm::vec3{0.0f});
    for (const GroundChart& chart : charts.charts) {
        const Frame world = at * chart.frame;
        tbb::parallel_for(std::uint32_t{0}, chart.count.y - 1, [&](std::uint32_t y) {
            const float t = k_first_t_m + charts.texel_m * static_cast<float>(y);
            const float height = t < plan.pavement_m() ? k_kerb_height_m : 0.0f;
            for (std::uint32_t x = 0; x < chart.count.x; ++x) {
                const float s = chart.s_min_m + charts.texel_m * static_cast<float>(x);
                const double weight = kept(charts, plan, chart.frame.point({s, height, t}));
                if (weight == 0.0) continue;
                light[std::size_t{chart.first.y + y} * charts.size.x + chart.first.x + x] =
                    glm::vec3{weight * glow_at(world.point({s, height, t}), windows, reach)};
            }
        });
    }
    GroundLight result;
    for (const glm::vec3 value : light)
        result.strength = std::max({result.strength, value.x, value.y, value.z});
    result.image.name = "shop-glow";
    result.image.width = charts.size.x;
    result.image.height = charts.size.y;
    result.image.texels.resize(4 * light.size(), std::byte{255});
    if (result.strength == 0.0f) return result;
    for (std::size_t i = 0; i < light.size(); ++i)
        for (int c = 0; c < 3; ++c)
            result.image.texels[4 * i + static_cast<std::size_t>(c)] =
                std::byte{byte_from_unit(srgb_from_linear(light[i][c] / result.strength))};
    return result;
}

void add_light_coordinates(Mesh& mesh, const GroundCharts& charts) {
    mesh.uv1.assign(mesh.positions.size(), glm::vec2{0.0f});
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* const corners = &mesh.indices[i];
        glm::vec3 middle{0.0f};
        for (int k = 0; k < 3; ++k)
            middle += mesh.positions[corners[k]] / 3.0f;
        const GroundChart& chart = charts.chart_at(middle);
        for (int k = 0; k < 3; ++k) {
            glm::vec3 place = mesh.positions[corners[k]];
            // The kerb's side looks away from all windows: it reads the chart's dark row.
            if (mesh.normals[corners[k]].y < 0.5f)
                place += chart.frame.out * (k_first_t_m - chart.frame.local(place).z +
                                            charts.texel_m * static_cast<float>(chart.count.y - 1));
            mesh.uv1[corners[k]] = charts.uv(chart, place);
        }
    }
}

}  // namespace rambla::assets::generate
