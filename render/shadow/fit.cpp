#include "render/shadow/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/shadow/convex.h"

namespace rambla::render::shadow {
namespace {

/// Texels around the fitted extent: the widest filter reaches two, and snapping moves the corner by up to
/// one.
constexpr double k_border_texels = 3.0;
/// A map of less is a map of a point.
constexpr double k_min_extent_m = 1e-3;
constexpr double k_steps_per_doubling = 8.0;

/// Edge of a FrameView's cell.
constexpr double k_cell_m = 256.0;

/// Right-handed axes of the light's view, in world space: z points at the sun, y along the view as the sun
/// sees it.
struct LightAxes {
    glm::dvec3 x{1.0, 0.0, 0.0};
    glm::dvec3 y{0.0, 1.0, 0.0};
    glm::dvec3 z{0.0, 0.0, 1.0};

    [[nodiscard]] glm::dvec3 from_world(glm::dvec3 p) const {
        return {glm::dot(x, p), glm::dot(y, p), glm::dot(z, p)};
    }
};

/// The first candidate that is not along the light decides. Of three perpendicular ones at least two are not.
LightAxes light_axes(const glm::mat4& view_from_world, glm::dvec3 direction_to_sun) {
    constexpr double k_min_sine = 1e-3;
    const glm::dmat3 world_from_view{glm::transpose(glm::mat3{view_from_world})};
    LightAxes axes;
    axes.z = direction_to_sun;
    for (const glm::dvec3& candidate : {-world_from_view[2], world_from_view[1], world_from_view[0]}) {
        const glm::dvec3 across = candidate - axes.z * glm::dot(candidate, axes.z);
        const double length = glm::length(across);
        if (!(length > k_min_sine)) continue;
        axes.y = across / length;
        break;
    }
    axes.x = glm::cross(axes.y, axes.z);
    return axes;
}

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void expand(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] Interval cut(const Interval& other) const {
        return {std::max(low, other.low), std::min(high, other.high)};
    }
    [[nodiscard]] bool empty() const { return !(low <= high); }
    [[nodiscard]] double length() const { return high - low; }
};

struct Extent {
    Interval x, y, z;

    void expand(glm::dvec3 p) {
        x.expand(p.x);
        y.expand(p.y);
        z.expand(p.z);
    }
};

Extent extent_of(std::span<const glm::vec3> points, const LightAxes& axes) {
    Extent extent;
    for (const glm::vec3& point : points) {
        extent.expand(axes.from_world(glm::dvec3{point}));
    }
    return extent;
}

/// What the casters cover, a little enlarged: a plane that is caster and receiver at once must meet itself.
/// The reach of a box along an axis is Σ |axis_i|·half_i.
Extent extent_of(const systems::CasterColumns& casters, const LightAxes& axes) {
    const LightAxes magnitudes{glm::abs(axes.x), glm::abs(axes.y), glm::abs(axes.z)};
    Extent extent;
    for (std::size_t row = 0; row < casters.size(); ++row) {
        const glm::dvec3 place =
            axes.from_world({casters.centre_x[row], casters.centre_y[row], casters.centre_z[row]});
        const glm::dvec3 reach =
            magnitudes.from_world({casters.half_x[row], casters.half_y[row], casters.half_z[row]}) +
            glm::dvec3{k_min_extent_m};
        extent.expand(place - reach);
        extent.expand(place + reach);
    }
    return extent;
}

/// One axis of the map: where it begins, relative to the eye, and the edge of its texels.
struct MapAxis {
    double begin_m = 0.0;
    double texel_m = 1.0;
};

MapAxis snapped(const Interval& wanted, double eye_m, std::uint32_t size_texels) {
    const double usable = std::max(static_cast<double>(size_texels) - 2.0 * k_border_texels, 1.0);
    const double extent = std::max(wanted.length(), k_min_extent_m);
    const double step = std::ceil(std::log2(extent / usable) * k_steps_per_doubling);
    const double texel = std::exp2(step / k_steps_per_doubling);
    const double first = std::floor((wanted.low + eye_m) / texel) - (k_border_texels - 1.0);
    return {first * texel - eye_m, texel};
}

bool finite(const glm::mat4& m) {
    float sum = 0.0f;
    for (int column = 0; column < 4; ++column)
        sum += glm::dot(m[column], glm::vec4{1.0f});
    return std::isfinite(sum);
}

}  // namespace

std::array<glm::vec3, 8> frustum_slice(const systems::FrameView& view, float distance_m) {
    const glm::mat4& p = view.clip_from_view;
    const glm::mat3 world_from_view = glm::transpose(glm::mat3{view.view_from_world});
    // z = −near where depth is 1; the other plane is the distance's, or an orthographic far plane before it.
    const float near_z = view.orthographic ? (1.0f - p[3][2]) / p[2][2] : -p[3][2] / (1.0f + p[2][2]);
    const float far_z = view.orthographic ? std::max(-p[3][2] / p[2][2], -distance_m) : -distance_m;
    constexpr std::array<glm::vec2, 4> k_corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::array<glm::vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        const float z = i < 4 ? near_z : std::min(far_z, near_z);
        const glm::vec2 ndc = k_corners[i % 4];
        const glm::vec2 scale{p[0][0], p[1][1]};
        const glm::vec2 xy =
            view.orthographic ? (ndc - glm::vec2{p[3]}) / scale : -z * (ndc + glm::vec2{p[2]}) / scale;
        corners[i] = world_from_view * glm::vec3{xy, z};
    }
    return corners;
}

SunFit fit_sun_map(const FitInput& input, const systems::CasterColumns& casters) {
    const double sun_length = glm::length(glm::dvec3{input.direction_to_sun});
    if (!(sun_length > 0.5) || !std::isfinite(sun_length) || casters.size() == 0) return {};
    const LightAxes axes =
        light_axes(input.view.view_from_world, glm::dvec3{input.direction_to_sun} / sun_length);
    const ConvexPoints seen = intersect(frustum_slice(input.view, input.distance_m), input.receivers);
    if (seen.count == 0) return {};

    const Extent receivers = extent_of(seen.span(), axes);
    const Extent throwers = extent_of(casters, axes);
    const Interval across_x = receivers.x.cut(throwers.x);
    const Interval across_y = receivers.y.cut(throwers.y);
    const bool casters_lie_behind = throwers.z.high < receivers.z.low;
    if (across_x.empty() || across_y.empty() || casters_lie_behind) return {};

    const glm::dvec3 eye =
        axes.from_world(glm::dvec3{input.view.eye_cell} * k_cell_m + glm::dvec3{input.view.eye_local_m});
    const MapAxis x = snapped(across_x, eye.x, input.size_texels);
    const MapAxis y = snapped(across_y, eye.y, input.size_texels);
    // Receivers are looked up a few texels off their surfaces.
    const double margin = 4.0 * std::max(x.texel_m, y.texel_m) + k_min_extent_m;
    const double low = receivers.z.low - margin;
    const double depth = receivers.z.high + margin - low;

    SunFit fit;
    const glm::dvec2 scale =
        2.0 / (static_cast<double>(input.size_texels) * glm::dvec2{x.texel_m, y.texel_m});
    const glm::dvec3 row_x = axes.x * scale.x, row_y = axes.y * scale.y, row_z = axes.z / depth;
    fit.clip_from_world =
        glm::mat4{glm::vec4{row_x.x, row_y.x, row_z.x, 0.0}, glm::vec4{row_x.y, row_y.y, row_z.y, 0.0},
                  glm::vec4{row_x.z, row_y.z, row_z.z, 0.0},
                  glm::vec4{-x.begin_m * scale.x - 1.0, -y.begin_m * scale.y - 1.0, -low / depth, 1.0}};
    fit.texel_m = glm::vec2{x.texel_m, y.texel_m};
    fit.depth_m = static_cast<float>(depth);
    fit.empty = false;
    return finite(fit.clip_from_world) ? fit : SunFit{};
}

}  // namespace rambla::render::shadow
