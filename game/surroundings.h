#pragma once

#include <memory>
#include <span>
#include <vector>

#include "assets/scene.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "game/collision.h"
#include "systems/components.h"

namespace rambla::game {

/// The triangles around a walker, of all that stands still in a world. Gathered anew only after some metres
/// of way, so its cost follows what is near, not how large the world is. What moves (people, cars, skins) is
/// not solid.
class Surroundings {
public:
    /// Both must outlive this.
    Surroundings(const ecs::World& world, const assets::Scene& scene);

    /// Makes sure that everything within reach of `place` is there.
    void move_to(const systems::WorldPosition& place);

    /// What triangles() count from: places are compared with them as offset_m(anchor(), place).
    [[nodiscard]] const systems::WorldPosition& anchor() const { return anchor_; }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }

private:
    void gather();
    void add_mesh(const assets::Mesh& mesh, const glm::mat3& linear, glm::vec3 translation_m);

    const ecs::World& world_;
    const assets::Scene& scene_;
    ecs::Query<const systems::WorldTransform, const systems::Renderable, const systems::LocalBounds,
               ecs::Without<systems::PreviousWorldTransform>, ecs::Without<systems::Skinned>,
               ecs::Without<systems::ParticleSource>>
        standing_;
    systems::WorldPosition anchor_;
    bool gathered_ = false;
    std::vector<Triangle> triangles_;
};

}  // namespace rambla::game
