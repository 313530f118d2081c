#include <cmath>

#include "assets/generate/builder.h"

namespace rambla::assets::generate {

void Builder::sheet(std::span<const glm::vec3> points, std::size_t columns, std::span<const Surface> surfaces,
                    float crease_rad) {
    const std::size_t rows = points.size() / columns;
    const std::size_t cell_columns = columns - 1;
    const std::size_t cell_rows = rows - 1;
    const auto point = [&](std::size_t r, std::size_t c) {
        return points[r * columns + c];
    };

    // Area-weighted cell normals; where neighbours bend less than the crease, a corner averages them.
    std::vector<glm::vec3> cells(cell_rows * cell_columns);
    for (std::size_t r = 0; r < cell_rows; ++r)
        for (std::size_t c = 0; c < cell_columns; ++c)
            cells[r * cell_columns + c] =
                glm::cross(point(r + 1, c + 1) - point(r, c), point(r + 1, c) - point(r, c + 1));
    const float limit = std::cos(crease_rad);
    const auto corner_normal = [&](std::size_t cell_r, std::size_t cell_c, std::size_t r, std::size_t c) {
        const glm::vec3 own = glm::normalize(cells[cell_r * cell_columns + cell_c]);
        glm::vec3 sum{0.0f};
        for (std::size_t nr = r == 0 ? 0 : r - 1; nr <= r && nr < cell_rows; ++nr) {
            for (std::size_t nc = c == 0 ? 0 : c - 1; nc <= c && nc < cell_columns; ++nc) {
                const glm::vec3 neighbour = cells[nr * cell_columns + nc];
                const float length = glm::length(neighbour);
                if (length > 1e-9f && glm::dot(neighbour, own) >= limit * length) sum += neighbour;
            }
        }
        return glm::normalize(sum);
    };
    for (std::size_t r = 0; r < cell_rows; ++r) {
        for (std::size_t c = 0; c < cell_columns; ++c) {
            if (glm::length(cells[r * cell_columns + c]) < 1e-8f) continue;
            const Surface surface = surfaces[r * cell_columns + c];
            const std::array<glm::vec3, 4> corners{point(r, c), point(r, c + 1), point(r + 1, c + 1),
                                                   point(r + 1, c)};
            const std::array<glm::vec3, 4> normals{corner_normal(r, c, r, c), corner_normal(r, c, r, c + 1),
                                                   corner_normal(r, c, r + 1, c + 1),
                                                   corner_normal(r, c, r + 1, c)};
            const float scale = 1.0f / (stretch * metres_per_repeat(surface));
            const glm::vec3 across = corners[1] - corners[0];
            const glm::vec3 u = glm::length(across) > 1e-6f ? across : corners[2] - corners[3];
            const glm::vec3 along = glm::normalize(u);
            const glm::vec3 v = glm::cross(glm::normalize(cells[r * cell_columns + c]), along);
            std::array<glm::vec2, 4> uv;
            for (std::size_t i = 0; i < 4; ++i)
                uv[i] = glm::vec2{glm::dot(corners[i], along), -glm::dot(corners[i], v)} * scale;
            emit_quad(surface, corners, normals, u, uv);
        }
    }
}

}  // namespace rambla::assets::generate
