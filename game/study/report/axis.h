#pragma once

#include <span>
#include <string>
#include <vector>

namespace rambla::game::study {

/// Widths in a figure's units, which are about the pixels of a small screen. The reader's font is not known:
/// a character counts as the average of a wide one, so that text keeps inside the room that is left for it.
constexpr double k_text_units = 12.0;
constexpr double k_character_units = 7.4;

[[nodiscard]] double text_width(const std::string& text);

struct Tick {
    double value = 0.0;
    std::string label{};  ///< empty: a minor tick
};

enum class Direction { horizontal, vertical };

/// One axis of a figure.
struct Axis {
    bool log = false;
    double low = 0.0;  ///< the value at the lower end; above zero on a logarithmic axis
    double high = 1.0;
    std::vector<Tick> ticks{};  ///< ascending, from low to high

    /// Where a finite value lies: 0 at the lower end, 1 at the upper. What has no logarithm lies at 0.
    [[nodiscard]] double place(double value) const;
};

/// An axis that holds all finite values, with ticks whose labels do not touch: at 1, 2 or 5 times a power of
/// ten on a linear one, at decades with minor ticks between them on a logarithmic one. A linear axis starts
/// at zero where values go down to less than half the largest. On a logarithmic one, values that are not
/// above zero get room below the others and a tick "≤ 0" at the lower end.
/// @param length  of the drawn axis, in units
[[nodiscard]] Axis make_axis(std::span<const double> values, bool log, double length, Direction direction);

}  // namespace rambla::game::study
