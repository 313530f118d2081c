#include "game/study/report/axis.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

constexpr int k_most_labels = 7;
constexpr double k_gap_units = 10.0;   ///< between labels beside each other
constexpr double k_line_units = 18.0;  ///< between the middles of labels above each other
constexpr double k_smallest_share =
    1e-9;  ///< of a value, that an axis spans: finer steps have no short label
constexpr double k_steps_below_decades =
    5;  ///< a factor below which a logarithmic axis has the ticks of a linear one

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return low > high; }
};

bool labels_fit(const Axis& axis, double length, Direction direction) {
    const Tick* last = nullptr;
    for (const Tick& tick : axis.ticks) {
        if (tick.label.empty()) continue;
        if (last != nullptr) {
            const double distance = (axis.place(tick.value) - axis.place(last->value)) * length;
            const double widths = (text_width(tick.label) + text_width(last->label)) / 2;
            if (distance < (direction == Direction::horizontal ? widths + k_gap_units : k_line_units))
                return false;
        }
        last = &tick;
    }
    return true;
}

std::ptrdiff_t labels_in(const std::vector<Tick>& ticks) {
    return std::count_if(ticks.begin(), ticks.end(), [](const Tick& tick) { return !tick.label.empty(); });
}

int exponent_of(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

/// A multiple of the step, with the digits that tell it from its neighbours.
std::string step_label(double value, double step, double largest) {
    constexpr double k_plain_below = 1e7;
    constexpr double k_plain_from = 1e-3;
    constexpr int k_most_decimals = 6;
    if (value == 0.0) return "0";
    const int step_exponent = exponent_of(step * 1.0001);
    std::string text;
    if (largest < k_plain_below && largest >= k_plain_from && -step_exponent <= k_most_decimals) {
        text = fmt::format("{:.{}f}", value, std::max(0, -step_exponent));
    } else {
        const std::string all =
            fmt::format("{:.{}e}", value, std::max(0, exponent_of(std::abs(value)) - step_exponent));
        const std::size_t e = all.find('e');
        text = fmt::format("{}·10{}", all.substr(0, e), superscript(std::atoi(all.c_str() + e + 1)));
    }
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

/// Multiples of a step of 1, 2 or 5 times a power of ten, about `count` of them.
std::vector<Tick> steps(const Axis& axis, int count) {
    // Divided before it is subtracted, since the difference of the largest doubles is infinite.
    const double wanted = axis.high / count - axis.low / count;
    const double power = std::pow(10.0, exponent_of(wanted));
    const double share = wanted / power;
    const double step = power * (share <= 1.0 ? 1.0 : share <= 2.0 ? 2.0 : share <= 5.0 ? 5.0 : 10.0);
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    std::vector<Tick> ticks;
    // The tolerance takes in an end that is a multiple but for its rounding.
    constexpr double k_tolerance = 1e-6;
    const double last = std::floor(axis.high / step + k_tolerance);
    for (double i = std::ceil(axis.low / step - k_tolerance); i <= last; i += 1.0)
        ticks.push_back({i * step, step_label(i * step, step, largest)});
    return ticks;
}

void set_steps(Axis& axis, double length, Direction direction) {
    for (int count = k_most_labels; count > 0; --count) {
        axis.ticks = steps(axis, count);
        if (labels_fit(axis, length, direction)) return;
    }
}

/// Which ticks of a logarithmic axis have labels: multiples of every stride-th power of ten.
struct DecadeLabels {
    std::array<bool, 10> digits;
    int stride;
};

/// "0.02", "5000"; "10⁻⁷" and "2·10⁻⁷" on an axis that goes beyond plain numbers.
std::string multiple_of_power(int digit, int exponent, bool plain) {
    const std::string ten = exponent == 1 ? "10" : fmt::format("10{}", superscript(exponent));
    if (plain) return fmt::format("{:.{}f}", digit * std::pow(10.0, exponent), std::max(0, -exponent));
    if (exponent == 0) return std::to_string(digit);
    return digit == 1 ? ten : fmt::format("{}·{}", digit, ten);
}

std::vector<Tick> decades(const Axis& axis, const DecadeLabels& labels) {
    constexpr double k_tolerance = 1.0 + 1e-9;
    const bool plain = axis.low >= 0.8e-3 && axis.high <= 5e4;
    std::vector<Tick> ticks;
    for (int exponent = exponent_of(axis.low); exponent <= exponent_of(axis.high); ++exponent) {
        const double decade = std::pow(10.0, exponent);
        const bool labelled = exponent % labels.stride == 0;
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * decade;
            const bool minor = !labelled || !labels.digits[static_cast<std::size_t>(digit)];
            if (value * k_tolerance < axis.low || value > axis.high * k_tolerance) continue;
            if (minor && labels.stride > 1) continue;
            std::string text;
            if (!minor) text = multiple_of_power(digit, exponent, plain);
            ticks.push_back({value, text});
        }
    }
    return ticks;
}

void set_log_ticks(Axis& axis, bool has_floor, double length, Direction direction) {
    constexpr std::array<bool, 10> k_ones{false, true};
    constexpr std::array<bool, 10> k_ones_twos_fives{false, true, true, false, false, true};
    constexpr std::array<DecadeLabels, 9> k_choices{{{k_ones_twos_fives, 1},
                                                     {k_ones, 1},
                                                     {k_ones, 2},
                                                     {k_ones, 3},
                                                     {k_ones, 5},
                                                     {k_ones, 10},
                                                     {k_ones, 20},
                                                     {k_ones, 50},
                                                     {k_ones, 100}}};
    const std::vector<Tick> floor(has_floor ? 1 : 0, Tick{axis.low, "≤ 0"});
    if (axis.high / axis.low >= k_steps_below_decades || has_floor) {
        for (const DecadeLabels& choice : k_choices) {
            axis.ticks = floor;
            for (Tick& tick : decades(axis, choice)) {
                // A number so near the lower end would be taken for the value there.
                if (has_floor && axis.place(tick.value) * length < k_line_units) tick.label.clear();
                axis.ticks.push_back(std::move(tick));
            }
            const std::ptrdiff_t count = labels_in(axis.ticks);
            if (count >= 2 && count <= k_most_labels && labels_fit(axis, length, direction)) return;
        }
    }
    set_steps(axis, length, direction);
}

/// Opens a range that is a single value, or nearly.
Range opened(Range range) {
    if (range.empty()) return {0.0, 1.0};
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    // Below this, a share of a value would be a denormal number.
    constexpr double k_tiny = 1e-290;
    if (range.high / 2 - range.low / 2 > std::max(size * k_smallest_share, k_tiny)) return range;
    constexpr double k_share = 0.05;
    const double margin = size > k_tiny ? size * k_share : 0.5;
    return {range.low - margin, range.high + margin};
}

Axis linear_axis(const Range& values, double length, Direction direction) {
    constexpr double k_margin = 0.06;
    Range range = opened(values);
    const bool from_zero = values.low >= 0.0 && values.low <= values.high / 2;
    const double margin = (range.high / 2 - range.low / 2) * 2 * k_margin;
    constexpr double k_largest = std::numeric_limits<double>::max() / 1.01;
    if (std::isfinite(margin)) {
        range.low -= margin;
        range.high += margin;
    }
    if (from_zero) range.low = 0.0;
    Axis axis{false, std::max(range.low, -k_largest), std::min(range.high, k_largest)};
    set_steps(axis, length, direction);
    return axis;
}

/// @param positive   of the values
/// @param has_floor  whether there are others
Axis log_axis(const Range& positive, bool has_floor, double length, Direction direction) {
    const double low = positive.empty() ? -1.0 : std::log10(positive.low);
    const double high = positive.empty() ? 0.0 : std::log10(positive.high);
    const double margin = std::max(0.05, 0.05 * (high - low));
    const double floor = has_floor ? std::max(0.4, 0.12 * (high - low)) : 0.0;
    // Powers of ten that are neither denormal numbers nor infinite.
    constexpr double k_smallest = -307.0;
    constexpr double k_largest = 308.25;
    const double lower = std::max(low - margin - floor, k_smallest);
    const double upper = std::min(std::max(high, lower) + margin, k_largest);
    Axis axis{true, std::pow(10.0, lower), std::pow(10.0, upper)};
    set_log_ticks(axis, has_floor, length, direction);
    return axis;
}

}  // namespace

double text_width(const std::string& text) {
    return static_cast<double>(rambla::game::study::length(text)) * k_character_units;
}

double Axis::place(double value) const {
    if (!log) return std::clamp((value / 2 - low / 2) / (high / 2 - low / 2), 0.0, 1.0);
    if (value <= low) return 0.0;
    return std::min(1.0, (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low)));
}

Axis make_axis(std::span<const double> values, bool log, double length, Direction direction) {
    Range drawn;
    bool has_floor = false;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        if (log && value <= 0.0)
            has_floor = true;
        else
            drawn.add(value);
    }
    return log ? log_axis(drawn, has_floor, length, direction) : linear_axis(drawn, length, direction);
}

}  // namespace rambla::game::study
