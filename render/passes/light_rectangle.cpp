#include "render/passes/light_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rambla::render {
namespace {

/// Sky has depth 0; a rectangle that lies before it, however far away, rejects it.
constexpr float k_min_depth = 1e-30f;
/// Widens bounds against rounding in the projection of pixels and rectangles: a thousandth of a pixel of
/// 1000.
constexpr float k_slack_ndc = 2e-6f;

constexpr double k_unbounded = std::numeric_limits<double>::infinity();

struct Slopes {
    double low = -k_unbounded;
    double high = k_unbounded;
};

/// Tangents from the eye to a circle at (across, ahead), as across/ahead.
Slopes tangent_slopes(double across, double ahead, double radius) {
    const double t2 = across * across + ahead * ahead - radius * radius;
    if (!(t2 > 0.0)) return {};
    const double t = std::sqrt(t2);
    const double high_ahead = ahead * t - across * radius;
    const double low_ahead = ahead * t + across * radius;
    return {low_ahead > 0.0 ? (across * t - ahead * radius) / low_ahead : -k_unbounded,
            high_ahead > 0.0 ? (across * t + ahead * radius) / high_ahead : k_unbounded};
}

float clamped(double ndc) {
    return static_cast<float>(std::clamp(ndc, -1.0, 1.0));
}

}  // namespace

double near_plane_z(const systems::FrameView& view) {
    const glm::mat4& p = view.clip_from_view;
    return view.orthographic ? (1.0 - p[3][2]) / p[2][2] : -p[3][2] / (1.0 + p[2][2]);
}

std::optional<ScreenRectangle> sphere_rectangle(const systems::FrameView& view, glm::vec3 centre_m,
                                                float radius_m) {
    const glm::mat4& p = view.clip_from_view;
    const glm::dvec3 centre{glm::mat3{view.view_from_world} * centre_m};
    const double radius = radius_m;
    const double nearest = centre.z + radius;
    const double farthest = centre.z - radius;
    if (farthest > near_plane_z(view)) return std::nullopt;

    ScreenRectangle rectangle;
    for (int axis = 0; axis < 2; ++axis) {
        const double a = p[axis][axis];
        Slopes ndc;
        if (view.orthographic) {
            ndc = {(centre[axis] - radius) * a + p[3][axis], (centre[axis] + radius) * a + p[3][axis]};
        } else {
            const Slopes slopes = tangent_slopes(centre[axis], -centre.z, radius);
            ndc = {slopes.low * a - p[2][axis], slopes.high * a - p[2][axis]};
        }
        rectangle.min[axis] = clamped(ndc.low - k_slack_ndc);
        rectangle.max[axis] = clamped(ndc.high + k_slack_ndc);
        if (rectangle.min[axis] >= rectangle.max[axis]) return std::nullopt;
    }
    if (view.orthographic && p[2][2] * nearest + p[3][2] < 0.0) return std::nullopt;  // beyond the far plane
    const double depth =
        view.orthographic ? p[2][2] * farthest + p[3][2] : (p[2][2] * farthest + p[3][2]) / -farthest;
    rectangle.depth = std::clamp(static_cast<float>(depth), k_min_depth, 1.0f);
    rectangle.nearest_m = static_cast<float>(std::max(0.0, -nearest));
    rectangle.farthest_m = static_cast<float>(std::max(0.0, -farthest));
    return rectangle;
}

}  // namespace rambla::render
