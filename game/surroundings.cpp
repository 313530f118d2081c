#include "game/surroundings.h"

#include <cmath>
#include <limits>

#include "systems/position.h"

namespace rambla::game {
namespace {

/// Triangles within this distance (in plan) of the anchor are kept; a walker may come within a metre of its
/// rim.
constexpr float k_reach_m = 6.0f;
constexpr float k_roam_m = 5.0f;

bool within_reach(glm::vec3 centre_m, glm::vec3 half_m) {
    return std::abs(centre_m.x) - half_m.x <= k_reach_m && std::abs(centre_m.z) - half_m.z <= k_reach_m;
}

}  // namespace

Surroundings::Surroundings(const ecs::World& world, const assets::Scene& scene)
    : world_{world}, scene_{scene} {}

void Surroundings::move_to(const systems::WorldPosition& place) {
    const glm::vec3 way = systems::offset_m(anchor_, place);
    const bool near = std::abs(way.x) < k_roam_m && std::abs(way.z) < k_roam_m;
    if (gathered_ && near) return;
    anchor_ = place;
    gathered_ = true;
    gather();
}

void Surroundings::gather() {
    triangles_.clear();
    standing_.each(world_, [this](const systems::WorldTransform& transform,
                                  const systems::Renderable& renderable, const systems::LocalBounds& bounds) {
        const glm::vec3 translation_m = systems::cell_offset_m(anchor_.cell, transform.cell) +
                                        (transform.translation_m - anchor_.local_m);
        const glm::mat3& linear = transform.linear;
        const glm::mat3 magnitude{glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])};
        const glm::vec3 centre_m = linear * bounds.centre_m + translation_m;
        if (!within_reach(centre_m, magnitude * bounds.half_extents_m)) return;
        add_mesh(scene_.meshes[renderable.mesh], linear, translation_m);
    });
}

void Surroundings::add_mesh(const assets::Mesh& mesh, const glm::mat3& linear, glm::vec3 translation_m) {
    if (mesh.topology != assets::Topology::triangles) return;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle triangle;
        glm::vec3 low{std::numeric_limits<float>::infinity()};
        glm::vec3 high{-std::numeric_limits<float>::infinity()};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle[corner] = linear * mesh.positions[mesh.indices[i + corner]] + translation_m;
            low = glm::min(low, triangle[corner]);
            high = glm::max(high, triangle[corner]);
        }
        if (within_reach(0.5f * (low + high), 0.5f * (high - low))) triangles_.push_back(triangle);
    }
}

}  // namespace rambla::game
