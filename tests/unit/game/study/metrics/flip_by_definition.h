#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "game/study/picture.h"

/// ꟻLIP as the paper writes it, for tests: in double precision, with kernels in the plane, slow. Shares
/// nothing with the implementation but the picture.
namespace rambla::game::study::by_definition {

using Colour = glm::dvec3;
constexpr double k_pi = std::numbers::pi;

/// A picture of whatever; beyond its border the outermost pixel.
template <class Value>
struct Grid {
    int width = 0;
    int height = 0;
    std::vector<Value> values{};

    [[nodiscard]] const Value& at(int x, int y) const {
        return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width +
                                               std::clamp(x, 0, width - 1))];
    }
};

inline Grid<Colour> grid_of(const Picture& picture) {
    Grid<Colour> grid{static_cast<int>(picture.width), static_cast<int>(picture.height)};
    grid.values.assign(picture.texels.begin(), picture.texels.end());
    return grid;
}

/// IEC 61966-2-1, D65.
inline Colour xyz_of(Colour c) {
    return {0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z, 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
            0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z};
}
inline Colour relative_xyz_of(Colour c) {
    return xyz_of(c) / xyz_of({1.0, 1.0, 1.0});
}

inline Colour yycxcz_of(Colour c) {
    const Colour r = relative_xyz_of(c);
    return {116.0 * r.y - 16.0, 500.0 * (r.x - r.y), 200.0 * (r.y - r.z)};
}
inline Colour relative_xyz_of_yycxcz(Colour c) {
    const double y = (c.x + 16.0) / 116.0;
    return {y + c.y / 500.0, y, y - c.z / 200.0};
}
/// By Cramer's rule on the matrix of xyz_of().
inline Colour rgb_of_relative_xyz(Colour relative) {
    const Colour xyz = relative * xyz_of({1.0, 1.0, 1.0});
    const Colour r = xyz_of({1.0, 0.0, 0.0});
    const Colour g = xyz_of({0.0, 1.0, 0.0});
    const Colour b = xyz_of({0.0, 0.0, 1.0});
    const auto determinant = [](Colour u, Colour v, Colour w) {
        return glm::dot(u, glm::cross(v, w));
    };
    return Colour{determinant(xyz, g, b), determinant(r, xyz, b), determinant(r, g, xyz)} /
           determinant(r, g, b);
}

/// CIE 1976 L*a*b* with a* and b* times 0.01 L*.
inline Colour hunt_of(Colour rgb) {
    const auto f = [](double t) {
        return t > std::pow(6.0 / 29.0, 3.0) ? std::pow(t, 1.0 / 3.0) : 841.0 / 108.0 * t + 4.0 / 29.0;
    };
    const Colour r = relative_xyz_of(rgb);
    const double lightness = 116.0 * f(r.y) - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f(r.x) - f(r.y)),
            0.01 * lightness * 200.0 * (f(r.y) - f(r.z))};
}

inline double hyab(Colour a, Colour b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// Of two colours that fill their pictures, for which filters do nothing: their whole ꟻLIP.
inline double colour_difference(Colour rgb_a, Colour rgb_b) {
    const double largest = std::pow(hyab(hunt_of({0.0, 1.0, 0.0}), hunt_of({0.0, 0.0, 1.0})), 0.7);
    const double distance = std::pow(hyab(hunt_of(rgb_a), hunt_of(rgb_b)), 0.7);
    const double bend = 0.4 * largest;
    if (distance < bend) return 0.95 / bend * distance;
    return 0.95 + (distance - bend) / (largest - bend) * (1.0 - 0.95);
}

/// Σ weight(dx, dy) · value(x + dx, y + dy) over a square.
template <class Value>
Value filtered(const Grid<Value>& grid, int x, int y, int radius,
               const std::function<double(int, int)>& weight) {
    Value sum{0.0};
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx)
            sum += weight(dx, dy) * grid.at(x + dx, y + dy);
    return sum;
}

inline double sum_over_square(int radius, const std::function<double(int, int)>& weight) {
    double sum = 0.0;
    for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx)
            sum += weight(dx, dy);
    return sum;
}

/// Spatial contrast sensitivity of the channels Yy, Cx and Cz at a distance of `degrees`.
inline Colour sensitivity(double degrees) {
    const auto term = [&](double a, double b) {
        return a * std::sqrt(k_pi / b) * std::exp(-k_pi * k_pi * degrees * degrees / b);
    };
    return {term(1.0, 0.0047), term(1.0, 0.0053), term(34.1, 0.04) + term(13.5, 0.025)};
}

inline Grid<Colour> blurred(const Grid<Colour>& rgb, double ppd) {
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * k_pi * k_pi)) * ppd));
    Grid<Colour> opponent = rgb;
    for (Colour& value : opponent.values)
        value = yycxcz_of(value);
    Grid<Colour> result = rgb;
    for (int channel = 0; channel < 3; ++channel) {
        const auto weight = [&](int dx, int dy) {
            return sensitivity(std::hypot(dx, dy) / ppd)[channel];
        };
        const double sum = sum_over_square(radius, weight);
        for (int i = 0; i < rgb.width * rgb.height; ++i)
            result.values[static_cast<std::size_t>(i)][channel] =
                filtered(opponent, i % rgb.width, i / rgb.width, radius, weight)[channel] / sum;
    }
    for (Colour& value : result.values)
        value = glm::clamp(rgb_of_relative_xyz(relative_xyz_of_yycxcz(value)), 0.0, 1.0);
    return result;
}

/// Strength of a feature: length of the responses to a kernel lying along x and along y.
inline Grid<double> strength(const Grid<double>& luminance, double ppd,
                             const std::function<double(double along, double deviation)>& profile) {
    const double deviation = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto raw = [&](double along, double across) {
        return profile(along, deviation) *
               std::exp(-(along * along + across * across) / (2.0 * deviation * deviation));
    };
    const double positive =
        sum_over_square(radius, [&](int dx, int dy) { return std::max(raw(dx, dy), 0.0); });
    const double negative =
        sum_over_square(radius, [&](int dx, int dy) { return std::max(-raw(dx, dy), 0.0); });
    const auto weight = [&](int along, int across) {
        const double value = raw(along, across);
        return value / (value > 0.0 ? positive : negative);
    };
    Grid<double> result = luminance;
    for (int y = 0; y < luminance.height; ++y)
        for (int x = 0; x < luminance.width; ++x)
            result.values[static_cast<std::size_t>(y * luminance.width + x)] =
                std::hypot(filtered(luminance, x, y, radius, weight),
                           filtered(luminance, x, y, radius, [&](int dx, int dy) { return weight(dy, dx); }));
    return result;
}

struct Features {
    Grid<double> edge;
    Grid<double> point;
};

inline Features features(const Grid<Colour>& rgb, double ppd) {
    Grid<double> luminance{rgb.width, rgb.height};
    for (const Colour& value : rgb.values)
        luminance.values.push_back((yycxcz_of(value).x + 16.0) / 116.0);
    return {strength(luminance, ppd, [](double along, double) { return -along; }),
            strength(luminance, ppd, [](double along, double deviation) {
                return along * along / (deviation * deviation) - 1.0;
            })};
}

inline double with_features(double colour, double edges, double points) {
    const double feature = std::sqrt(std::max(std::abs(edges), std::abs(points)) / std::sqrt(2.0));
    return std::pow(colour, 1.0 - feature);
}

/// @param reference, test  linear light in [0, 1]
inline std::vector<double> ldr_flip(const Picture& reference, const Picture& test, double ppd) {
    const Grid<Colour> blurred_reference = blurred(grid_of(reference), ppd);
    const Grid<Colour> blurred_test = blurred(grid_of(test), ppd);
    const Features of_reference = features(grid_of(reference), ppd);
    const Features of_test = features(grid_of(test), ppd);
    std::vector<double> map;
    for (std::size_t i = 0; i < reference.texels.size(); ++i)
        map.push_back(with_features(colour_difference(blurred_reference.values[i], blurred_test.values[i]),
                                    of_reference.edge.values[i] - of_test.edge.values[i],
                                    of_reference.point.values[i] - of_test.point.values[i]));
    return map;
}

/// Narkowicz 2015, after a factor of 2^ev.
inline Picture tone_mapped(Picture picture, double ev) {
    for (glm::vec3& texel : picture.texels)
        for (int c = 0; c < 3; ++c) {
            const double x = std::exp2(ev) * double{texel[c]};
            const double shown = (2.51 * x * x + 0.03 * x) / (2.43 * x * x + 0.59 * x + 0.14);
            texel[c] = static_cast<float>(std::clamp(shown, 0.0, 1.0));
        }
    return picture;
}

}  // namespace rambla::game::study::by_definition
