#include "systems/simulate/transform.h"

#include <algorithm>
#include <cmath>

#include "systems/position.h"

namespace rambla::systems {
namespace {

glm::mat3 linear_of(const LocalTransform& local) {
    const glm::mat3 rotation = glm::mat3_cast(local.rotation);
    return {rotation[0] * local.scale.x, rotation[1] * local.scale.y, rotation[2] * local.scale.z};
}

}  // namespace

glm::quat renormalised(const glm::quat& rotation) {
    const float norm = glm::dot(rotation, rotation);
    // Within 1/16 of unit, the step leaves at most 3/8 · (1/16)² of the error, and far less from one step to
    // the next.
    if (std::fabs(norm - 1.0f) < 0.0625f) return rotation * (1.5f - 0.5f * norm);
    const float largest = std::max(std::max(std::fabs(rotation.x), std::fabs(rotation.y)),
                                   std::max(std::fabs(rotation.z), std::fabs(rotation.w)));
    if (!(largest > 0.0f) || !std::isfinite(largest)) return {1.0f, 0.0f, 0.0f, 0.0f};
    const glm::quat scaled{rotation.w / largest, rotation.x / largest, rotation.y / largest,
                           rotation.z / largest};
    return scaled * (1.0f / std::sqrt(glm::dot(scaled, scaled)));
}

WorldTransform root_transform(const Cell& cell, const LocalTransform& local) {
    return {cell.value, linear_of(local), local.translation_m};
}

WorldTransform child_transform(const WorldTransform& parent, const LocalTransform& local) {
    return {parent.cell, parent.linear * linear_of(local),
            parent.linear * local.translation_m + parent.translation_m};
}

void TransformPropagation::operator()(ecs::World& world) {
    for (auto [now, previous] : moved_.chunks(world, copied_)) {
        for (std::size_t i = 0; i < now.size(); ++i)
            previous[i].value = now[i];
    }
    copied_.version = world.version() - 1;  // what is written from here on may still have this version
    propagate_(
        world,
        [](LocalTransform& local, Cell* cell) {
            local.rotation = renormalised(local.rotation);
            if (cell == nullptr) return root_transform({}, local);
            const WorldPosition place = normalised({cell->value, local.translation_m});
            cell->value = place.cell;
            local.translation_m = place.local_m;
            return root_transform(*cell, local);
        },
        [](const WorldTransform& parent, LocalTransform& local, const Cell*) {
            local.rotation = renormalised(local.rotation);
            return child_transform(parent, local);
        });
}

void settle(ecs::World& world) {
    TransformPropagation propagate;
    propagate(world);
    propagate(world);
}

}  // namespace rambla::systems
