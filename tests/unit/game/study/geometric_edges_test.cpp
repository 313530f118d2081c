#include "game/study/geometric_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>

#include "assets/scene.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_size = 8;
constexpr float k_pixel_m = 0.01f;

/// What a pixel sees. Pixels are k_pixel_m apart, 1 m from the eye.
struct Seen {
    std::uint32_t object = 1;
    float farther_m = 0.0f;
    glm::vec3 normal{0.0f, 0.0f, 1.0f};
};

struct Captured {
    explicit Captured(const std::function<Seen(std::uint32_t, std::uint32_t)>& see) {
        objects.width = objects.height = k_size;
        for (assets::Image* image : {&surfaces.positions, &surfaces.normals}) {
            image->width = image->height = k_size;
            image->format = assets::PixelFormat::rgba32f;
        }
        for (std::uint32_t y = 0; y < k_size; ++y) {
            for (std::uint32_t x = 0; x < k_size; ++x) {
                const Seen seen = see(x, y);
                objects.ids.push_back(seen.object);
                add(surfaces.positions, {k_pixel_m * static_cast<float>(x),
                                         -k_pixel_m * static_cast<float>(y), -1.0f - seen.farther_m});
                add(surfaces.normals, glm::normalize(seen.normal));
            }
        }
    }
    static void add(assets::Image& image, glm::vec3 value) {
        const glm::vec4 texel{value, 0.0f};
        const std::size_t size = image.texels.size();
        image.texels.resize(size + sizeof texel);
        std::memcpy(image.texels.data() + size, &texel, sizeof texel);
    }
    [[nodiscard]] std::vector<std::uint8_t> edges(std::uint32_t samples = 1) const {
        return geometric_edges(objects, surfaces, samples);
    }
    render::ObjectImage objects;
    render::SurfaceImages surfaces;
};

const std::vector<std::uint8_t> k_none(std::size_t{k_size} * k_size, 0);

/// Both sides of the line before a column.
std::vector<std::uint8_t> beside(std::uint32_t column, std::uint32_t size = k_size) {
    std::vector<std::uint8_t> mask(std::size_t{size} * size, 0);
    for (std::uint32_t y = 0; y < size; ++y)
        mask[y * size + column] = mask[y * size + column - 1] = 1;
    return mask;
}

TEST(GeometricEdges, AreNotOnAPlaneHoweverItLies) {
    EXPECT_EQ(Captured([](auto, auto) { return Seen{}; }).edges(), k_none);
    // Seen at a grazing angle: 20 times as deep as wide.
    EXPECT_EQ(Captured([](auto, auto y) {
                  return Seen{.farther_m = 20.0f * k_pixel_m * (k_size - static_cast<float>(y)),
                              .normal = {0, 20, 1}};
              }).edges(),
              k_none);
}

TEST(GeometricEdges, AreWhereObjectsMeetAndWhereTheSkyBegins) {
    EXPECT_EQ(Captured([](auto x, auto) { return Seen{.object = x < 3 ? 1u : 2u}; }).edges(), beside(3));
    EXPECT_EQ(Captured([](auto x, auto) { return Seen{.object = x < 3 ? 1u : assets::k_none}; }).edges(),
              beside(3));
    EXPECT_EQ(Captured([](auto x, auto y) {
                  return Seen{.object = assets::k_none, .farther_m = std::fmod(17.0f * x + 5.0f * y, 3.0f)};
              }).edges(),
              k_none)
        << "of the sky captures say nothing";
}

TEST(GeometricEdges, AreWhereOneObjectBendsOrHidesItself) {
    EXPECT_EQ(Captured([](auto x, auto) {
                  const float turned = x < 4 ? 0.0f : 0.5f;  // 29°
                  return Seen{.farther_m = std::tan(turned) * k_pixel_m * (static_cast<float>(x) - 3.5f),
                              .normal = {std::sin(turned), 0, std::cos(turned)}};
              }).edges(),
              beside(4));
    EXPECT_EQ(Captured([](auto x, auto) { return Seen{.farther_m = x < 4 ? 0.0f : 0.5f}; }).edges(),
              beside(4));
}

TEST(GeometricEdges, AreNotOnARoundSurface) {
    // A ball with a radius of ten pixels, of which neighbours bend by 6° in its middle and by 8° here at
    // most.
    constexpr float k_radius_px = 10.0f;
    EXPECT_EQ(Captured([](auto x, auto) {
                  const float across = static_cast<float>(x) / k_radius_px;
                  const float height = std::sqrt(1.0f - across * across);
                  return Seen{.farther_m = -k_radius_px * k_pixel_m * height, .normal = {across, 0, height}};
              }).edges(),
              k_none);
}

TEST(GeometricEdges, OfManySamplesFindWhatIsThinnerThanAPixel) {
    // A pole in the second column of samples of the pixels before column 2 of four.
    const std::vector<std::uint8_t> edges =
        Captured([](auto x, auto) { return Seen{.object = x == 3 ? 2u : 1u}; }).edges(2);
    EXPECT_EQ(edges, beside(2, 4)) << "its rims: within the pixel, and between it and the next";
}

}  // namespace
}  // namespace rambla::game::study
