#include "assets/trace/samples.h"

#include <algorithm>
#include <cmath>

#include "assets/generate/draws.h"

namespace rambla::assets {
namespace {

constexpr double k_pi = 3.14159265358979323846;

/// Uniform in [0, 1), a multiple of 2⁻⁵³.
double unit(std::uint64_t bits) {
    return static_cast<double>(bits >> 11u) * 0x1p-53;
}

/// The largest divisor whose square is no more.
std::uint32_t lesser_side(std::uint32_t count) {
    auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    while (side > 1 && count % side != 0)
        --side;
    return std::max(side, 1u);
}

}  // namespace

glm::dvec2 stratified_sample(std::uint64_t seed, std::uint64_t pixel, std::uint32_t sample,
                             std::uint32_t count) {
    const std::uint32_t columns = lesser_side(count);
    const std::uint32_t rows = count / columns;
    const std::uint64_t key = generate::key_of(generate::key_of(seed, pixel), sample);
    return {(sample % columns + unit(generate::key_of(key, 0))) / columns,
            (static_cast<double>(sample / columns) + unit(generate::key_of(key, 1))) / rows};
}

glm::dvec2 on_disc(glm::dvec2 square) {
    const glm::dvec2 p = 2.0 * square - 1.0;
    if (p.x == 0.0 && p.y == 0.0) return p;
    const bool flat = std::abs(p.x) > std::abs(p.y);
    const double radius = flat ? p.x : p.y;
    const double angle = flat ? 0.25 * k_pi * p.y / p.x : 0.5 * k_pi - 0.25 * k_pi * p.x / p.y;
    return radius * glm::dvec2{std::cos(angle), std::sin(angle)};
}

glm::dvec3 around_normal(glm::dvec3 normal, glm::dvec2 disc) {
    // Two axes at right angles to the normal: Duff et al. 2017, "Building an orthonormal basis, revisited".
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    const glm::dvec3 across{1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
    const glm::dvec3 along{b, sign + normal.y * normal.y * a, -normal.y};
    const double height = std::sqrt(std::max(0.0, 1.0 - glm::dot(disc, disc)));
    return disc.x * across + disc.y * along + height * normal;
}

}  // namespace rambla::assets
