#include "render/post/picture_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rambla::render {
namespace {

constexpr double k_largest_half = 65504.0;

double luminance(const glm::dvec3& light) {
    return glm::dot(light, glm::dvec3{0.2126, 0.7152, 0.0722});
}

double seen(const glm::vec3& texel) {
    const bool is_number = std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z);
    return is_number ? std::clamp(luminance(glm::dvec3{texel}), 0.0, k_largest_half) : 0.0;
}

double reinhard(double x) {
    return x / (1.0 + x);
}

double extended(double x, double white) {
    return x < white ? x * (1.0 + x / (white * white)) / (1.0 + x) : 1.0;
}

/// Hable 2010, "Uncharted 2: HDR lighting".
double filmic_shape(double x) {
    constexpr double a = 0.15, b = 0.50, c = 0.10, d = 0.20, e = 0.02, f = 0.30;
    return (x * (a * x + c * b) + d * e) / (x * (a * x + b) + d * f) - e / f;
}

double filmic(double x, double white) {
    constexpr double k_scale = 4.0;  // of tone_curves.glsl
    return x < white ? filmic_shape(k_scale * x) / filmic_shape(k_scale * white) : 1.0;
}

/// Narkowicz 2015, "ACES filmic tone mapping curve".
double aces(double x) {
    return std::min(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

/// The half of the sigmoid on one side of the pivot, as lengths from it. Sobotka 2022, AgX; the
/// pivot is as in tone_curves.glsl.
double agx_half(double from_pivot, double run, double rise, double power) {
    constexpr double k_slope = 2.0;
    const double a = std::pow(k_slope * run, -power);
    const double b = std::pow(k_slope * run / rise, power) - 1.0;
    const double scale = std::pow(a * b, -1.0 / power);
    const double t = k_slope * from_pivot / scale;
    return scale * t / std::pow(1.0 + std::pow(t, power), 1.0 / power);
}

double agx_sigmoid(double x) {
    constexpr double k_pivot = 10.0 / 16.5;
    const double grey = std::pow(0.18, 1.0 / 2.2);
    return x < k_pivot ? grey - agx_half(k_pivot - x, k_pivot, grey, 3.0)
                       : grey + agx_half(x - k_pivot, 1.0 - k_pivot, 1.0 - grey, 3.25);
}

/// With the matrices of the configuration, in columns.
glm::dvec3 agx(const glm::dvec3& scene) {
    const glm::dmat3 together{0.842479062253094,  0.0423282422610123, 0.0423756549057051,
                              0.0784335999999992, 0.878468636469772,  0.0784336,
                              0.0792237451477643, 0.0791661274605434, 0.879142973793104};
    glm::dvec3 light = together * scene;
    for (int i = 0; i < 3; ++i) {
        const double stops = light[i] > 0.0 ? std::log2(light[i] / 0.18) : -10.0;
        light[i] = agx_sigmoid(std::clamp((stops + 10.0) / 16.5, 0.0, 1.0));
    }
    light = glm::inverse(together) * light;
    for (int i = 0; i < 3; ++i)
        light[i] = std::pow(std::clamp(light[i], 0.0, 1.0), 2.2);
    return light;
}

glm::dvec3 on_channels(const glm::dvec3& scene, ToneCurve curve, double white) {
    const auto each = [&](auto&& of) {
        return glm::dvec3{of(scene.x), of(scene.y), of(scene.z)};
    };
    switch (curve) {
        case ToneCurve::reinhard:
            return each([](double x) { return reinhard(x); });
        case ToneCurve::extended:
            return each([&](double x) { return extended(x, white); });
        case ToneCurve::filmic:
            return each([&](double x) { return filmic(x, white); });
        case ToneCurve::aces:
            return each([](double x) { return aces(x); });
        case ToneCurve::agx:
            break;
    }
    return agx(scene);
}

}  // namespace

double log_average_luminance(std::span<const glm::vec3> image, double delta) {
    double sum = 0.0;
    for (const glm::vec3& texel : image)
        sum += std::log(delta + seen(texel));
    return std::exp(sum / static_cast<double>(image.size()));
}

double luminance_percentile(std::span<const glm::vec3> image, double share) {
    std::vector<double> luminances;
    for (const glm::vec3& texel : image)
        luminances.push_back(seen(texel));
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(image.size() - 1) + 0.5);
    const auto found = luminances.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(luminances.begin(), found, luminances.end());
    return *found;
}

EstimatedCurve estimate_curve(double average, double darkest, double brightest) {
    const double low = std::log2(darkest);
    const double high = std::log2(brightest);
    const double exponent =
        high > low ? std::clamp((2.0 * std::log2(average) - low - high) / (high - low), -1.0, 1.0) : 0.0;
    const double key = 0.18 * std::pow(4.0, exponent);
    return {.key = key,
            .white = std::max({1.5 * std::exp2(high - low - 5.0), key * brightest / average, 1.0})};
}

glm::dvec3 tone_mapped(const glm::dvec3& scene, ToneCurve curve, ToneOn on, double white) {
    if (on == ToneOn::channels) return on_channels(scene, curve, white);
    const double from = luminance(scene);
    if (!(from > 0.0)) return glm::dvec3{0.0};
    const double to = on_channels(glm::dvec3{from}, curve, white).y;
    const glm::dvec3 scaled = scene * (to / from);
    const double most = std::max({scaled.x, scaled.y, scaled.z});
    return most > 1.0 ? glm::mix(scaled, glm::dvec3{to}, (most - 1.0) / (most - to)) : scaled;
}

double srgb_encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

}  // namespace rambla::render
