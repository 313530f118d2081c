#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>

namespace rambla::game::study {

constexpr std::size_t k_series_colours = 7;
constexpr std::size_t k_series_shapes = 8;

enum class Align { start, middle, end };

/// Elements of an SVG, in a figure's units with y downwards. Classes are those of plot_style(); texts are
/// given as they are read and escaped here.
class Drawing {
public:
    void text(const glm::dvec2& baseline, Align align, const char* css_class, const std::string& text);
    void rectangle(const glm::dvec2& low, const glm::dvec2& high, const char* css_class);
    void line(const glm::dvec2& from, const glm::dvec2& to, const std::string& css_class);
    /// Points joined by straight lines. Fewer than two draw nothing.
    void polyline(std::span<const glm::dvec2> points, const std::string& css_class);
    /// A marker in the shape and colour of a series. The two repeat after different numbers of series, so
    /// that 56 can be told apart, and the shape alone tells 8 for those who do not see colours.
    /// @param hint  shown by a browser under the pointer; may be empty
    void marker(const glm::dvec2& at, double radius, std::size_t series, const char* css_class,
                const std::string& hint);

    [[nodiscard]] const std::string& svg() const { return svg_; }

private:
    std::string svg_;
};

/// "s3", the class of a series' colour.
[[nodiscard]] std::string colour_class(std::size_t series);

}  // namespace rambla::game::study
