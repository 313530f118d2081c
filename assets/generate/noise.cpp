#include "assets/generate/noise.h"

#include <cmath>

namespace rambla::assets::generate {

float value_noise(glm::vec2 p, glm::uvec2 cells, std::uint32_t seed) {
    const float x = p.x * static_cast<float>(cells.x);
    const float y = p.y * static_cast<float>(cells.y);
    const float floor_x = std::floor(x);
    const float floor_y = std::floor(y);
    const std::uint32_t x0 = static_cast<std::uint32_t>(static_cast<int>(floor_x)) % cells.x;
    const std::uint32_t y0 = static_cast<std::uint32_t>(static_cast<int>(floor_y)) % cells.y;
    const std::uint32_t x1 = x0 + 1 == cells.x ? 0 : x0 + 1;
    const std::uint32_t y1 = y0 + 1 == cells.y ? 0 : y0 + 1;
    const float fx = x - floor_x;
    const float fy = y - floor_y;
    const float sx = fx * fx * (3.0f - 2.0f * fx);
    const float sy = fy * fy * (3.0f - 2.0f * fy);
    const float bottom = glm::mix(lattice_unit(x0, y0, seed), lattice_unit(x1, y0, seed), sx);
    const float top = glm::mix(lattice_unit(x0, y1, seed), lattice_unit(x1, y1, seed), sx);
    return glm::mix(bottom, top, sy);
}

float fractal_noise(glm::vec2 p, glm::uvec2 cells, int octaves, std::uint32_t seed) {
    float sum = 0.0f;
    float amplitude = 0.5f;
    float total = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += amplitude * value_noise(p, cells, seed + static_cast<std::uint32_t>(octave));
        total += amplitude;
        amplitude *= 0.5f;
        cells *= 2u;
    }
    return sum / total;
}

glm::vec2 cell_noise(glm::vec2 p, glm::uvec2 cells, std::uint32_t seed) {
    const glm::vec2 at = p * glm::vec2{cells};
    const glm::ivec2 home{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
    glm::vec2 nearest{8.0f};  // squared distances; farther than any neighbour can be
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const std::uint32_t x =
                static_cast<std::uint32_t>(home.x + dx + static_cast<int>(cells.x)) % cells.x;
            const std::uint32_t y =
                static_cast<std::uint32_t>(home.y + dy + static_cast<int>(cells.y)) % cells.y;
            const glm::vec2 point{static_cast<float>(home.x + dx) + lattice_unit(x, y, seed),
                                  static_cast<float>(home.y + dy) + lattice_unit(x, y, seed + 77u)};
            const glm::vec2 to = point - at;
            const float d = glm::dot(to, to);
            if (d < nearest.x)
                nearest = {d, nearest.x};
            else if (d < nearest.y)
                nearest.y = d;
        }
    }
    return {std::sqrt(nearest.x), std::sqrt(nearest.y)};
}

}  // namespace rambla::assets::generate
