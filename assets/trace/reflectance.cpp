#include "assets/trace/reflectance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rambla::assets {
namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_least_roughness = 0.045;
constexpr double k_least_n_dot_v = 1e-4;
constexpr double k_least_distance_m = 0.01;
constexpr glm::dvec3 k_dielectric_f0{0.04};

glm::dvec3 f0_of(const ReflectingPoint& point) {
    return glm::mix(k_dielectric_f0, point.base_colour, point.metalness);
}

glm::dvec3 diffuse_of(const ReflectingPoint& point) {
    return point.base_colour * (1.0 - point.metalness);
}

double alpha_of(const ReflectingPoint& point) {
    return std::pow(std::max(point.roughness, k_least_roughness), 2.0);
}

/// Between two opposite directions there is none: the normal stands for it.
glm::dvec3 half_vector(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l) {
    const glm::dvec3 sum = v + l;
    return glm::length(sum) > 1e-6 ? glm::normalize(sum) : point.normal;
}

glm::dvec3 fresnel(const ReflectingPoint& point, double v_dot_h) {
    const glm::dvec3 f0 = f0_of(point);
    return f0 + (1.0 - f0) * std::pow(std::clamp(1.0 - v_dot_h, 0.0, 1.0), 5.0);
}

}  // namespace

glm::dvec3 reflected_ggx(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l) {
    const glm::dvec3& n = point.normal;
    const double n_dot_l = glm::dot(n, l);
    if (n_dot_l <= 0.0) return glm::dvec3{0.0};
    const double n_dot_v = std::max(glm::dot(n, v), k_least_n_dot_v);
    const double a = alpha_of(point);
    const glm::dvec3 h = half_vector(point, v, l);
    const double n_dot_h = glm::dot(n, h);
    // tan² is written by the angle between n and h, which no cancellation spoils.
    const double tan2 = std::pow(glm::length(glm::cross(n, h)) / std::max(n_dot_h, 1e-12), 2.0);
    const double d = a * a / (k_pi * std::pow(n_dot_h, 4.0) * std::pow(a * a + tan2, 2.0));
    const auto lambda = [&](double cosine) {
        const double t2 = (1.0 - cosine * cosine) / (cosine * cosine);
        return 0.5 * (std::sqrt(1.0 + a * a * t2) - 1.0);
    };
    const double g = 1.0 / (1.0 + lambda(n_dot_l) + lambda(n_dot_v));
    const glm::dvec3 f = fresnel(point, glm::dot(v, h));
    return ((1.0 - f) * diffuse_of(point) / k_pi + f * (d * g / (4.0 * n_dot_l * n_dot_v))) * n_dot_l;
}

glm::dvec3 reflected_blinn(const ReflectingPoint& point, glm::dvec3 v, glm::dvec3 l) {
    const double n_dot_l = glm::dot(point.normal, l);
    if (n_dot_l <= 0.0) return glm::dvec3{0.0};
    const glm::dvec3 h = half_vector(point, v, l);
    const double a = alpha_of(point);
    const double exponent = 2.0 / (a * a) - 2.0;
    const double lobe = std::pow(std::clamp(glm::dot(point.normal, h), 0.0, 1.0), exponent);
    const glm::dvec3 f = fresnel(point, glm::dot(v, h));
    return ((1.0 - f) * diffuse_of(point) / k_pi + f * ((exponent + 8.0) / (8.0 * k_pi) * lobe)) * n_dot_l;
}

glm::dvec3 reflected_lambert(const ReflectingPoint& point, glm::dvec3, glm::dvec3 l) {
    return (diffuse_of(point) + f0_of(point)) / k_pi * std::max(glm::dot(point.normal, l), 0.0);
}

double lamp_attenuation(double distance_m, double radius_m) {
    if (!(distance_m < radius_m)) return 0.0;
    const double window = std::pow(1.0 - std::pow(distance_m / radius_m, 4.0), 2.0);
    return window / std::pow(std::max(distance_m, k_least_distance_m), 2.0);
}

}  // namespace rambla::assets
