#include "assets/generate/form_factor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace rambla::assets::test {
namespace {

using generate::form_factor;
using Quad = std::array<glm::dvec3, 4>;

/// The integral of cos·cos/(π r²) over a parallelogram, by the midpoint rule.
double integrated(const Quad& quad, glm::dvec3 point, glm::dvec3 normal, int steps) {
    const glm::dvec3 along = quad[1] - quad[0], up = quad[3] - quad[0];
    const glm::dvec3 area = glm::cross(along, up);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const glm::dvec3 r = quad[0] + along * ((i + 0.5) / steps) + up * ((j + 0.5) / steps) - point;
            const double received = glm::dot(r, normal), sent = -glm::dot(r, area);
            const double r2 = glm::dot(r, r);
            if (received > 0.0 && sent > 0.0) sum += received * sent / (r2 * r2);
        }
    }
    return sum / (std::numbers::pi * steps * steps);
}

/// Level square of this half size at a height above the origin, which it shines down on.
Quad ceiling(double half, double height) {
    return {{{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}}};
}

TEST(FormFactor, IsTheIntegralOverTheEmitter) {
    std::mt19937 random{3};
    std::uniform_real_distribution<double> uniform{-1.0, 1.0};
    const auto vector = [&] {
        return glm::dvec3{uniform(random), uniform(random), uniform(random)};
    };
    int seen = 0, cut = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 corner = vector() + glm::dvec3{0, 0, 2.5}, along = vector(), up = vector();
        const Quad quad{{corner, corner + along, corner + along + up, corner + up}};
        const glm::dvec3 normal = glm::normalize(vector());
        const double expected = integrated(quad, glm::dvec3{0.0}, normal, 400);
        // The horizon runs through the steps that it cuts: half a step's width of the picture.
        EXPECT_NEAR(form_factor(quad, glm::dvec3{0.0}, normal), expected, 1e-4) << i;
        seen += expected > 0.01 ? 1 : 0;
        int below = 0;
        for (const glm::dvec3 c : quad)
            below += glm::dot(c, normal) < 0.0 ? 1 : 0;
        cut += below > 0 && below < 4 && expected > 0.0 ? 1 : 0;
    }
    EXPECT_GT(seen, 30);
    EXPECT_GT(cut, 20);
}

TEST(FormFactor, OfAnEndlessPlaneIsOne) {
    EXPECT_NEAR(form_factor(ceiling(1e6, 1.0), {0, 0, 0}, {0, 1, 0}), 1.0, 1e-5);
    // One that stands on the ground hides half of the sky.
    const Quad wall{{{-1e6, 0, -1}, {1e6, 0, -1}, {1e6, 1e6, -1}, {-1e6, 1e6, -1}}};
    EXPECT_NEAR(form_factor(wall, {0, 0, 0}, {0, 1, 0}), 0.5, 1e-5);
    // One that reaches below the ground does no more: the horizon cuts it.
    const Quad deep{{{-1e6, -1e6, -1}, {1e6, -1e6, -1}, {1e6, 1e6, -1}, {-1e6, 1e6, -1}}};
    EXPECT_NEAR(form_factor(deep, {0, 0, 0}, {0, 1, 0}), 0.5, 1e-5);
}

// Configuration C-3 of Howell's catalogue, from a point to a parallel rectangle above one of its corners:
// F = 1/2π · (A/√(1+A²) · atan(B/√(1+A²)) + B/√(1+B²) · atan(A/√(1+B²))).
TEST(FormFactor, OfAParallelRectangleIsTheCataloguesOne) {
    const double a = 1.7, b = 0.6, root_a = std::sqrt(1 + a * a), root_b = std::sqrt(1 + b * b);
    const double expected =
        (a / root_a * std::atan(b / root_a) + b / root_b * std::atan(a / root_b)) / (2 * std::numbers::pi);
    const Quad quad{{{0, 2, 0}, {2 * a, 2, 0}, {2 * a, 2, 2 * b}, {0, 2, 2 * b}}};
    EXPECT_NEAR(form_factor(quad, {0, 0, 0}, {0, 1, 0}), expected, 1e-12);
}

TEST(FormFactor, IsNothingFromBehindBelowOrBeside) {
    const Quad quad = ceiling(1.0, 1.0);
    EXPECT_GT(form_factor(quad, {0.3, 0, 0.2}, {0, 1, 0}), 0.1);
    EXPECT_EQ(form_factor(quad, {0.3, 0, 0.2}, {0, -1, 0}), 0.0) << "below the horizon";
    EXPECT_EQ(form_factor(quad, {0.3, 2, 0.2}, {0, -1, 0}), 0.0) << "from behind";
    EXPECT_NEAR(form_factor(quad, {3, 1, 0}, {0, 1, 0}), 0.0, 1e-15) << "in its plane";
    EXPECT_NEAR(form_factor(quad, {3, 1, 0}, glm::normalize(glm::dvec3{-1, 1, 0})), 0.0, 1e-15);
    const std::vector<glm::dvec3> line{{0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    EXPECT_NEAR(form_factor(line, {0.5, 0, 0}, {0, 1, 0}), 0.0, 1e-15) << "no area";
    EXPECT_NEAR(form_factor(std::vector<glm::dvec3>(4, {0, 1, 0}), {0.5, 0, 0}, {0, 1, 0}), 0.0, 1e-15);
    const Quad corner{{{0, 0, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, 0}}};
    EXPECT_TRUE(std::isfinite(form_factor(corner, {0, 0, 0}, {0, 1, 0}))) << "at a corner";
}

TEST(FormFactor, FadesLikeAPointFarAway) {
    // Area · cos · cos / (π r²).
    const Quad quad = ceiling(0.5, 100.0);
    EXPECT_NEAR(form_factor(quad, {0, 0, 0}, {0, 1, 0}) / (1.0 / (std::numbers::pi * 1e4)), 1.0, 1e-4);
    const double grazing = form_factor(quad, {1e4, 0, 0}, {0, 1, 0});
    const double r2 = 1e8 + 1e4;
    EXPECT_NEAR(grazing / (1e4 / (std::numbers::pi * r2 * r2)), 1.0, 1e-3);
}

}  // namespace
}  // namespace rambla::assets::test
