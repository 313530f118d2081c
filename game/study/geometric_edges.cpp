#include "game/study/geometric_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/glm.hpp>

#include "assets/assert.h"
#include "assets/scene.h"

namespace rambla::game::study {
namespace {

/// cos and sin of 20°: neighbouring pixels of curved surfaces in the street differ by a few degrees, corners
/// by 30 and more.
constexpr float k_same_surface_cos = 0.94f;
constexpr float k_same_surface_sin = 0.34f;

glm::vec3 texel(const assets::Image& image, std::size_t i) {
    glm::vec3 value;
    std::memcpy(&value, image.texels.data() + i * sizeof(glm::vec4), sizeof value);
    return value;
}

class EdgeFinder {
public:
    EdgeFinder(const render::ObjectImage& objects, const render::SurfaceImages& surfaces)
        : objects_{objects}, surfaces_{surfaces} {}

    [[nodiscard]] bool between(std::size_t a, std::size_t b) const {
        if (objects_.ids[a] != objects_.ids[b]) return true;
        if (objects_.ids[a] == assets::k_none) return false;
        const glm::vec3 normal_a = texel(surfaces_.normals, a);
        const glm::vec3 normal_b = texel(surfaces_.normals, b);
        if (!(glm::dot(normal_a, normal_b) > k_same_surface_cos)) return true;
        const glm::vec3 way = texel(surfaces_.positions, b) - texel(surfaces_.positions, a);
        // Along a surface the way from one pixel to the next lies in it.
        const float out_of_plane =
            std::max(std::abs(glm::dot(normal_a, way)), std::abs(glm::dot(normal_b, way)));
        return out_of_plane > k_same_surface_sin * glm::length(way);
    }

private:
    const render::ObjectImage& objects_;
    const render::SurfaceImages& surfaces_;
};

}  // namespace

std::vector<std::uint8_t> geometric_edges(const render::ObjectImage& objects,
                                          const render::SurfaceImages& surfaces, std::uint32_t samples) {
    const std::size_t width = objects.width;
    RAMBLA_ASSERT(surfaces.normals.width == objects.width && surfaces.normals.height == objects.height,
                  "captures of one picture have one size");
    RAMBLA_ASSERT(objects.width % samples == 0 && objects.height % samples == 0, "whole pixels are shown");
    const std::size_t shown_width = width / samples;
    const EdgeFinder edge{objects, surfaces};
    std::vector<std::uint8_t> is_edge(shown_width * (objects.height / samples), 0);
    const auto mark = [&](std::size_t x, std::size_t y) {
        is_edge[(y / samples) * shown_width + x / samples] = 1;
    };
    for (std::size_t y = 0; y < objects.height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            if (x + 1 < width && edge.between(i, i + 1)) {
                mark(x, y);
                mark(x + 1, y);
            }
            if (y + 1 < objects.height && edge.between(i, i + width)) {
                mark(x, y);
                mark(x, y + 1);
            }
        }
    }
    return is_edge;
}

}  // namespace rambla::game::study
