#include "game/study/metrics/flip_kernels.h"

#include <cmath>
#include <numbers>

namespace rambla::game::study::flip {
namespace {

constexpr double k_pi = std::numbers::pi;

/// A term a · √(π/b) · exp(−π² d² / b) of a blur, d in degrees: Andersson et al. 2020, on spatial filtering.
/// They fit measured contrast sensitivity functions, whose Fourier transforms these are.
struct Sensitivity {
    double a;
    double b;
};
constexpr Sensitivity k_luminance{1.0, 0.0047};
constexpr Sensitivity k_red_green{1.0, 0.0053};
constexpr Sensitivity k_blue_yellow_1{34.1, 0.04};
constexpr Sensitivity k_blue_yellow_2{13.5, 0.025};
constexpr double k_widest_b = k_blue_yellow_1.b;

constexpr double k_feature_width_deg = 0.082;  // what the eye detects edges by; twice the deviation
constexpr double k_deviations = 3.0;           // kernels end there

template <class Weight>
std::vector<double> sample(int radius, Weight weight) {
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i)
        values.push_back(weight(static_cast<double>(i)));
    return values;
}

double sum_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum;
}

Kernel scaled(const std::vector<double>& values, double scale) {
    Kernel kernel;
    for (const double value : values)
        kernel.push_back(static_cast<float>(value * scale));
    return kernel;
}

/// Positive weights that sum to 1, negative ones to −1.
Kernel balanced(std::vector<double> values) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double value : values)
        (value > 0.0 ? positive : negative) += std::abs(value);
    for (double& value : values)
        value /= value > 0.0 ? positive : negative;
    return scaled(values, 1.0);
}

/// A Gaussian in the plane is the product of two along the axes, exp(−c(x² + y²)) = exp(−cx²) · exp(−cy²),
/// and its weights sum to the square of what one of them sums to. So the factor of the plane's kernel,
/// divided by what the channel's terms sum to together, is applied as its root along each axis.
class Blur {
public:
    explicit Blur(double pixels_per_degree)
        : pixels_per_degree_{pixels_per_degree},
          radius_{static_cast<int>(
              std::ceil(k_deviations * std::sqrt(k_widest_b / (2.0 * k_pi * k_pi)) * pixels_per_degree))} {}

    [[nodiscard]] double sum(Sensitivity s) const {
        const double along_axis = sum_of(weights(s));
        return factor(s) * along_axis * along_axis;
    }
    [[nodiscard]] Kernel kernel(Sensitivity s, double sum_of_channel) const {
        return scaled(weights(s), std::sqrt(factor(s) / sum_of_channel));
    }

private:
    [[nodiscard]] static double factor(Sensitivity s) { return s.a * std::sqrt(k_pi / s.b); }
    [[nodiscard]] std::vector<double> weights(Sensitivity s) const {
        return sample(radius_, [&](double i) {
            const double degrees = i / pixels_per_degree_;
            return std::exp(-k_pi * k_pi * degrees * degrees / s.b);
        });
    }

    double pixels_per_degree_;
    int radius_;
};

}  // namespace

Kernels kernels_for(double pixels_per_degree) {
    const Blur blur{pixels_per_degree};
    const double blue_yellow = blur.sum(k_blue_yellow_1) + blur.sum(k_blue_yellow_2);
    const double deviation = 0.5 * k_feature_width_deg * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(k_deviations * deviation));
    const auto gaussian = [&](double i) {
        return std::exp(-i * i / (2.0 * deviation * deviation));
    };
    const std::vector<double> across = sample(radius, gaussian);
    return {.blur = {{{0, blur.kernel(k_luminance, blur.sum(k_luminance))},
                      {1, blur.kernel(k_red_green, blur.sum(k_red_green))},
                      {2, blur.kernel(k_blue_yellow_1, blue_yellow)},
                      {2, blur.kernel(k_blue_yellow_2, blue_yellow)}}},
            .gaussian = scaled(across, 1.0 / sum_of(across)),
            .edge = balanced(sample(radius, [&](double i) { return i * gaussian(i); })),
            .point = balanced(sample(
                radius, [&](double i) { return (i * i / (deviation * deviation) - 1.0) * gaussian(i); }))};
}

}  // namespace rambla::game::study::flip
