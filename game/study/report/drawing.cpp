#include "game/study/report/drawing.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

/// A hundredth of a unit is less than can be seen.
std::string coordinate(double value) {
    const double rounded = std::round(value * 100.0) / 100.0;
    return fmt::format("{}", rounded == 0.0 ? 0.0 : rounded);  // no "-0"
}

std::string path_through(std::span<const glm::dvec2> points) {
    std::string path;
    for (const glm::dvec2& point : points)
        path += fmt::format("{}{} {}", path.empty() ? 'M' : 'L', coordinate(point.x), coordinate(point.y));
    return path;
}

/// Corners on a circle, the first at an angle from the right, counted clockwise.
std::vector<glm::dvec2> polygon(int corners, double radius, double first_deg) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = (first_deg + 360.0 * i / corners) * std::numbers::pi / 180.0;
        points.push_back(radius * glm::dvec2{std::cos(angle_rad), std::sin(angle_rad)});
    }
    return points;
}

/// A cross of four thick arms, the first in the direction of an angle.
std::vector<glm::dvec2> cross(double radius, double first_deg) {
    constexpr double k_half_arm = 0.36;  // of the radius
    const double corner_deg = std::atan(k_half_arm) * 180.0 / std::numbers::pi;
    const double tip = radius * std::hypot(1.0, k_half_arm);
    const double notch = radius * k_half_arm * std::numbers::sqrt2;
    std::vector<glm::dvec2> points;
    for (int arm = 0; arm < 4; ++arm) {
        const double arm_deg = first_deg + 90.0 * arm;
        points.push_back(polygon(1, tip, arm_deg - corner_deg)[0]);
        points.push_back(polygon(1, tip, arm_deg + corner_deg)[0]);
        points.push_back(polygon(1, notch, arm_deg + 45.0)[0]);
    }
    return points;
}

/// Around the origin, with areas that look alike.
std::string shape_path(std::size_t shape, double r) {
    switch (shape) {
        case 1:
            return path_through(polygon(4, 1.2 * r, 45.0)).append("Z");  // square
        case 2:
            return path_through(polygon(3, 1.25 * r, -90.0)).append("Z");  // triangle, up
        case 3:
            return path_through(polygon(4, 1.25 * r, 0.0)).append("Z");  // diamond
        case 4:
            return path_through(polygon(3, 1.25 * r, 90.0)).append("Z");  // triangle, down
        case 5:
            return path_through(cross(1.1 * r, 0.0)).append("Z");
        case 6:
            return path_through(cross(1.1 * r, 45.0)).append("Z");
        case 7:
            return path_through(polygon(6, 1.1 * r, 0.0)).append("Z");
        default: {
            const std::string size = coordinate(r);
            return fmt::format("M-{0} 0A{0} {0} 0 1 1 {0} 0A{0} {0} 0 1 1-{0} 0Z", size);
        }
    }
}

}  // namespace

void Drawing::text(const glm::dvec2& baseline, Align align, const char* css_class, const std::string& text) {
    constexpr std::array<const char*, 3> k_anchors{"start", "middle", "end"};
    svg_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", css_class,
                        coordinate(baseline.x), coordinate(baseline.y),
                        k_anchors[static_cast<std::size_t>(align)], escaped(text));
}

void Drawing::rectangle(const glm::dvec2& low, const glm::dvec2& high, const char* css_class) {
    svg_ += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", css_class,
                        coordinate(low.x), coordinate(low.y), coordinate(high.x - low.x),
                        coordinate(high.y - low.y));
}

void Drawing::line(const glm::dvec2& from, const glm::dvec2& to, const std::string& css_class) {
    const std::array<glm::dvec2, 2> ends{from, to};
    polyline(ends, css_class);
}

void Drawing::polyline(std::span<const glm::dvec2> points, const std::string& css_class) {
    if (points.size() < 2) return;
    svg_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, path_through(points));
}

void Drawing::marker(const glm::dvec2& at, double radius, std::size_t series, const char* css_class,
                     const std::string& hint) {
    svg_ += fmt::format("<path class=\"{} {}\" transform=\"translate({} {})\" d=\"{}\">", css_class,
                        colour_class(series), coordinate(at.x), coordinate(at.y),
                        shape_path(series % k_series_shapes, radius));
    if (!hint.empty()) svg_ += fmt::format("<title>{}</title>", escaped(hint));
    svg_ += "</path>\n";
}

std::string colour_class(std::size_t series) {
    return fmt::format("s{}", series % k_series_colours);
}

}  // namespace rambla::game::study
