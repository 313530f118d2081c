#include "game/study/metrics/flip.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "game/statistics.h"
#include "game/study/metrics/flip_kernels.h"
#include "game/study/metrics/flip_view.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

constexpr double k_fewest_pixels_per_degree = 1.0;      // below, the weights beside the middle underflow
constexpr double k_most_pixels_per_degree = 10'000.0;   // kernels of 2700 weights
constexpr double k_shown_light = 0.85;                  // t of Andersson et al. 2021: just below saturation
constexpr double k_darkest_median = 1.0 / (1u << 23u);  // of the largest luminance

void require_comparable(const Picture& reference, const Picture& test, double pixels_per_degree) {
    require_same_size(reference, test);
    if (pixels_per_degree >= k_fewest_pixels_per_degree && pixels_per_degree <= k_most_pixels_per_degree)
        return;
    throw std::invalid_argument(fmt::format("FLIP at {} pixels per degree; {} to {} are possible",
                                            pixels_per_degree, k_fewest_pixels_per_degree,
                                            k_most_pixels_per_degree));
}

/// Narkowicz 2015: (2.51 x² + 0.03 x) / (2.43 x² + 0.59 x + 0.14), from 0 at 0 to 1 and a little above it.
struct ToneCurve {
    double a = 2.51;
    double b = 0.03;
    double c = 2.43;
    double d = 0.59;
    double e = 0.14;

    /// @param light  ≥ 0
    [[nodiscard]] float shown(double light) const {
        constexpr double k_white = 1e4;  // far above where the curve passes 1; keeps squares finite
        const double x = std::min(light, k_white);
        return static_cast<float>(std::min(x * (a * x + b) / (x * (c * x + d) + e), 1.0));
    }
    /// Light that is shown as t in (0, 1): the positive root of (a − tc) x² + (b − td) x − te = 0, of which
    /// there is one, for the product of both roots is −te / (a − tc) < 0.
    [[nodiscard]] double light_shown_as(double t) const {
        const double quadratic = a - t * c;
        const double linear = b - t * d;
        return (-linear + std::sqrt(linear * linear + 4.0 * quadratic * t * e)) / (2.0 * quadratic);
    }
};

template <class Shown>
Picture shown_picture(const Picture& picture, Shown shown) {
    Picture result{.width = picture.width, .height = picture.height, .texels = {}};
    result.texels.resize(picture.texels.size());
    tbb::parallel_for(std::size_t{0}, picture.texels.size(), [&](std::size_t i) {
        const glm::vec3 light = finite_or_black(picture.texels[i]);
        result.texels[i] = {shown(light.x), shown(light.y), shown(light.z)};
    });
    return result;
}

Picture displayed(const Picture& picture) {
    return shown_picture(picture, [](float light) { return std::clamp(light, 0.0f, 1.0f); });
}

Picture tone_mapped(const Picture& picture, double exposure_ev) {
    const double factor = std::exp2(exposure_ev);
    return shown_picture(
        picture, [&](float light) { return ToneCurve{}.shown(factor * std::max(double{light}, 0.0)); });
}

/// Raises a map to the differences of two pictures where these are larger.
void raise(std::vector<float>& map, const Picture& reference, const Picture& test,
           const flip::Kernels& kernels) {
    const std::vector<flip::Seen> of_reference = flip::see(reference, kernels);
    const std::vector<flip::Seen> of_test = flip::see(test, kernels);
    tbb::parallel_for(std::size_t{0}, map.size(), [&](std::size_t i) {
        map[i] = std::max(map[i], flip::difference(of_reference[i], of_test[i]));
    });
}

/// With what is as wrong as can be: texels that are not finite in one picture alone.
Flip finish(std::vector<float> map, const Picture& reference, const Picture& test) {
    double sum = 0.0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (is_finite(reference.texels[i]) != is_finite(test.texels[i])) map[i] = 1.0f;
        sum += double{map[i]};
    }
    const double mean = map.empty() ? 0.0 : sum / static_cast<double>(map.size());
    return {.width = reference.width, .height = reference.height, .map = std::move(map), .mean = mean};
}

std::vector<double> finite_luminances(const Picture& picture) {
    std::vector<double> values;
    values.reserve(picture.texels.size());
    for (const glm::vec3& texel : picture.texels)
        if (is_finite(texel)) values.push_back(luminance(glm::max(glm::dvec3{texel}, 0.0)));
    return values;
}

bool has_light(const Picture& picture) {
    return std::any_of(picture.texels.begin(), picture.texels.end(), [](glm::vec3 texel) {
        return is_finite(texel) && (texel.x > 0.0f || texel.y > 0.0f || texel.z > 0.0f);
    });
}

}  // namespace

Flip ldr_flip(const Picture& reference, const Picture& test, double pixels_per_degree) {
    require_comparable(reference, test, pixels_per_degree);
    std::vector<float> map(reference.texels.size(), 0.0f);
    raise(map, displayed(reference), displayed(test), flip::kernels_for(pixels_per_degree));
    return finish(std::move(map), reference, test);
}

FlipExposures flip_exposures(const Picture& reference) {
    if (!has_light(reference)) return {};
    const std::vector<double> luminances = finite_luminances(reference);
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    const double middle = std::max(median(luminances), k_darkest_median * largest);
    const double shown = ToneCurve{}.light_shown_as(k_shown_light);
    const double start_ev = std::log2(shown / largest);
    const double stops = std::log2(largest / middle);  // of the ratio: 3 for 8, not 3 and a rounding error
    return {.start_ev = start_ev,
            .stop_ev = start_ev + stops,
            .count = static_cast<std::uint32_t>(std::max(std::ceil(stops), 2.0))};
}

Flip hdr_flip(const Picture& reference, const Picture& test, double pixels_per_degree) {
    require_comparable(reference, test, pixels_per_degree);
    const FlipExposures exposures = flip_exposures(has_light(reference) ? reference : test);
    const flip::Kernels kernels = flip::kernels_for(pixels_per_degree);
    std::vector<float> map(reference.texels.size(), 0.0f);
    for (std::uint32_t i = 0; i < exposures.count; ++i)
        raise(map, tone_mapped(reference, exposures.ev(i)), tone_mapped(test, exposures.ev(i)), kernels);
    return finish(std::move(map), reference, test);
}

}  // namespace rambla::game::study
