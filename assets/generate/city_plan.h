#pragma once

#include <glm/glm.hpp>

#include "assets/generate/city.h"
#include "assets/generate/ground.h"

namespace rambla::assets::generate {

/// Where everything of a city lies: streets on a grid centred at the origin, streets 0 and n run along the
/// edge.
struct CityPlan {
    StreetPlan street;
    int blocks_x = 3;
    int blocks_z = 3;

    [[nodiscard]] float street_x(int i) const { return along(i, blocks_x); }
    [[nodiscard]] float street_z(int j) const { return along(j, blocks_z); }
    [[nodiscard]] glm::vec2 block_centre(int i, int j) const {
        return {street_x(i) + 0.5f * street.pitch_m(), street_z(j) + 0.5f * street.pitch_m()};
    }
    /// Façade lines of the houses around the city (x, z).
    [[nodiscard]] glm::vec2 edge_min() const {
        return {street_x(0) - 0.5f * street.street_width_m, street_z(0) - 0.5f * street.street_width_m};
    }
    [[nodiscard]] glm::vec2 edge_max() const { return -edge_min(); }

    /// The street along z of the standard walk, and the row of blocks that it starts in.
    [[nodiscard]] int walked_street() const { return blocks_x / 2; }
    [[nodiscard]] int walked_row() const { return blocks_z / 2; }

    /// Middle of the one-way lane beside the street's middle; the other side of the carriageway is for
    /// parking.
    [[nodiscard]] float lane_m() const { return -0.21f * street.carriageway_m(); }

private:
    [[nodiscard]] float along(int i, int blocks) const {
        return (static_cast<float>(i) - 0.5f * static_cast<float>(blocks)) * street.pitch_m();
    }
};

[[nodiscard]] inline CityPlan plan_of(const CityParameters& parameters) {
    CityPlan plan;
    plan.street.street_width_m = parameters.street_width_m;
    plan.blocks_x = parameters.blocks_x;
    plan.blocks_z = parameters.blocks_z;
    return plan;
}

/// Whether the one-way traffic of street i out of n + 1 runs towards +z (or +x): in turn, the last against
/// the first, so that the edge streets close a loop.
[[nodiscard]] inline bool runs_positive(int i, int n, bool first_positive) {
    return i == n ? !first_positive : ((i & 1) != 0) != first_positive;
}

}  // namespace rambla::assets::generate
