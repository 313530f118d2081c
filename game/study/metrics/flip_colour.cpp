#include "game/study/metrics/flip_colour.h"

#include <cmath>

namespace rambla::game::study::flip {
namespace {

constexpr float k_large_compression = 0.7f;  // q_c: differences of large size are seen alike
constexpr float k_lower_part = 0.4f;         // p_c of the range …
constexpr float k_lower_result = 0.95f;      // … are mapped to p_t of the result

/// CIE XYZ of linear RGB, D65, each relative to white: the rows of IEC 61966-2-1:1999, divided by their sums.
glm::dmat3 white_xyz_from_rgb() {
    glm::dmat3 rows{0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505};
    for (int i = 0; i < 3; ++i)
        rows[i] /= rows[i].x + rows[i].y + rows[i].z;
    return glm::transpose(rows);
}

/// (Y, X − Y, Y − Z) of (X, Y, Z).
glm::dmat3 opponent_from_xyz() {
    return glm::transpose(glm::dmat3{0.0, 1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 1.0, -1.0});
}

const glm::mat3 k_xyz_from_rgb{white_xyz_from_rgb()};
const glm::mat3 k_opponent_from_rgb{opponent_from_xyz() * white_xyz_from_rgb()};
const glm::mat3 k_rgb_from_opponent{glm::inverse(opponent_from_xyz() * white_xyz_from_rgb())};

/// Lightness curve of CIE 1976 L*a*b*: a cube root, near black its tangent.
float lightness_curve(float t) {
    constexpr float k_delta = 6.0f / 29.0f;
    return t > k_delta * k_delta * k_delta ? std::cbrt(t) : t / (3.0f * k_delta * k_delta) + 4.0f / 29.0f;
}

/// HyAB: lightness and chroma are judged apart.
float compressed_distance(glm::vec3 a, glm::vec3 b) {
    const glm::vec3 d = a - b;
    return std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), k_large_compression);
}

/// Of colours of the display: green against blue.
const float k_largest_distance =
    compressed_distance(hunt_lab_from_rgb({0.0f, 1.0f, 0.0f}), hunt_lab_from_rgb({0.0f, 0.0f, 1.0f}));

}  // namespace

glm::vec3 opponent_from_rgb(glm::vec3 rgb) {
    return k_opponent_from_rgb * rgb;
}

glm::vec3 rgb_from_opponent(glm::vec3 opponent) {
    return k_rgb_from_opponent * opponent;
}

glm::vec3 hunt_lab_from_rgb(glm::vec3 rgb) {
    const glm::vec3 xyz = k_xyz_from_rgb * rgb;
    const float x = lightness_curve(xyz.x);
    const float y = lightness_curve(xyz.y);
    const float z = lightness_curve(xyz.z);
    const float lightness = 116.0f * y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

float colour_difference(glm::vec3 a, glm::vec3 b) {
    const float distance = compressed_distance(a, b) / k_largest_distance;
    if (distance < k_lower_part) return distance * (k_lower_result / k_lower_part);
    // Blur and rounding can overshoot the largest distance of two colours by a hair.
    return glm::min(
        k_lower_result + (distance - k_lower_part) / (1.0f - k_lower_part) * (1.0f - k_lower_result), 1.0f);
}

}  // namespace rambla::game::study::flip
