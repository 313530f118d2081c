#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "assets/generate/ground.h"
#include "assets/generate/shop_light.h"

namespace rambla::assets::generate {

/// A flat piece of ground before a façade that lies in a rectangle of a light map: s runs along the façade, t
/// away from it, metres.
struct GroundChart {
    Frame frame;  ///< of the ground: x is s, z is t
    float s_min_m = 0.0f;
    float s_max_m = 0.0f;
    glm::uvec2 first{0};  ///< texel whose middle is (s_min, k_first_t_m)
    glm::uvec2 count{
        0};  ///< texels along s and t; the last row is dark, for what faces away from all windows
};

/// Where the pieces of some ground lie in its light map. Texels are square; the middles of a chart's
/// outermost ones lie on its rim or beyond, so that no sample between them reads another chart's.
struct GroundCharts {
    std::vector<GroundChart> charts;
    float texel_m = 0.25f;
    glm::uvec2 size{0};  ///< of the light map, texels
    /// Half of the square beyond which other ground with light of its own lies, so that light fades towards
    /// its rim; 0: there is none.
    float cell_half_m = 0.0f;

    /// The chart that a place lies farthest out of the façade of.
    [[nodiscard]] const GroundChart& chart_at(glm::vec3 place) const;
    /// Texture coordinates of a place in a chart.
    [[nodiscard]] glm::vec2 uv(const GroundChart& chart, glm::vec3 place) const;
};

/// Charts begin below the façade, as the pavement does.
inline constexpr float k_first_t_m = -0.1f;

/// Of build_block_ground: rows for the four sides, and one for the chamfers. It is the last, because the road
/// before a chamfer reaches farther out than any light: coordinates beyond the map are clamped to its edge.
/// @param texel_m  length of a texel's edge
[[nodiscard]] GroundCharts block_ground_charts(const StreetPlan& plan, float texel_m);
/// Of build_edge_ground.
[[nodiscard]] GroundCharts edge_ground_charts(const StreetPlan& plan, float length_m, float texel_m);

/// How far windows of a plan's shops reach: the middle of the street, beyond which other charts lie.
[[nodiscard]] GlowReach glow_reach(const StreetPlan& plan);

/// A light map with what makes its bytes radiance.
struct GroundLight {
    Image image;
    float strength = 0.0f;  ///< the largest value of a texel; 0: no light
};

/// Sums up what windows send onto a piece of ground; on all cores, with the same bytes for any number of
/// them.
/// @param at  the frame of the ground in the world
[[nodiscard]] GroundLight bake_ground(const GroundCharts& charts, const StreetPlan& plan, const Frame& at,
                                      std::span<const ShopWindow> windows);

/// Gives a mesh of the ground texture coordinates in its light map as its second set. Only what faces up has
/// light; vertices must not be shared between faces of different charts.
void add_light_coordinates(Mesh& mesh, const GroundCharts& charts);

}  // namespace rambla::assets::generate
