#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "systems/components.h"

namespace rambla::systems {

/// Moves whole cells from `local_m` to `cell`, so that every coordinate lies in [0, k_cell_m). Exact where
/// the local coordinates are below 2²⁴ cells' worth; the place itself never moves by more than the rounding
/// of one float.
[[nodiscard]] inline WorldPosition normalised(WorldPosition place) {
    for (int axis = 0; axis < 3; ++axis) {
        float& local = place.local_m[axis];
        if (local >= 0.0f && local < k_cell_m) continue;
        const float cells = std::floor(local / k_cell_m);
        if (!(std::fabs(cells) < 2147483648.0f)) continue;
        place.cell[axis] += static_cast<int>(cells);
        local -= cells * k_cell_m;
        // A tiny negative number rounds up to the far border, which belongs to the next cell.
        if (local >= k_cell_m) {
            ++place.cell[axis];
            local = 0.0f;
        }
    }
    return place;
}

/// The place `offset_m` away from `from`, normalised; keeps double precision until the place inside the cell.
[[nodiscard]] inline WorldPosition moved(const WorldPosition& from, const glm::dvec3& offset_m) {
    const glm::dvec3 local = glm::dvec3{from.local_m} + offset_m;
    const glm::dvec3 cells = glm::floor(local / static_cast<double>(k_cell_m));
    const glm::vec3 rest{local - cells * static_cast<double>(k_cell_m)};
    return normalised({from.cell + glm::ivec3{cells}, rest});
}

/// From the corner of one cell to the corner of another. The difference is taken in integers: exact up to 2²⁴
/// cells, and equal wherever in the world both are.
[[nodiscard]] inline glm::vec3 cell_offset_m(glm::ivec3 from, glm::ivec3 to) {
    const glm::i64vec3 cells = glm::i64vec3{to} - glm::i64vec3{from};
    return glm::vec3{cells} * k_cell_m;
}

/// The vector from one place to another.
[[nodiscard]] inline glm::vec3 offset_m(const WorldPosition& from, const WorldPosition& to) {
    return cell_offset_m(from.cell, to.cell) + (to.local_m - from.local_m);
}

}  // namespace rambla::systems
