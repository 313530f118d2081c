#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <span>

#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/look/culling.h"
#include "systems/pipeline.h"

namespace rambla::test {

/// What farthest_outside() found.
struct Outside {
    double distance_m = -std::numeric_limits<double>::infinity();  ///< negative: all are inside
    std::size_t vertices = 0;                                      ///< looked at
};

/// How far deformed vertices lie outside the boxes that were culled, at most. Looks at what a Frame draws and
/// moves its vertices in double precision by the Frame's own joints and morph terms, by the formulas of
/// glTF 2.0, 3.7.
inline Outside farthest_outside(ecs::World& world, const assets::Scene& scene, const systems::Eye& eye,
                                float interpolation) {
    systems::Frame frame;
    systems::build_frame(world, eye, interpolation, frame);
    const systems::Culling& culling = world.resource<systems::Culling>();
    std::map<std::uint32_t, std::size_t> row_of_object;
    for (const systems::LookChunk& chunk : culling.chunks()) {
        for (std::size_t i = 0; i < chunk.entities.size(); ++i)
            row_of_object[chunk.entities[i].index] = chunk.first_row + i;
    }
    std::map<std::uint32_t, const assets::MorphTarget*> targets;
    for (const assets::Mesh& mesh : scene.meshes) {
        for (const assets::MorphTarget& target : mesh.morphs)
            targets.emplace(static_cast<std::uint32_t>(targets.size()), &target);
    }

    Outside found;
    const auto moved = [](glm::vec4 row0, glm::vec4 row1, glm::vec4 row2, const glm::dvec4& p) {
        return glm::dvec3{glm::dot(glm::dvec4{row0}, p), glm::dot(glm::dvec4{row1}, p),
                          glm::dot(glm::dvec4{row2}, p)};
    };
    const auto look_at = [&](const systems::Instance& instance, const assets::Mesh& mesh, bool skinned,
                             bool morphed) {
        const systems::BoxColumns boxes = culling.boxes();
        const std::size_t row = row_of_object.at(instance.object);
        const glm::dvec3 centre{boxes.centre_x[row], boxes.centre_y[row], boxes.centre_z[row]};
        const glm::dvec3 half{boxes.half_x[row], boxes.half_y[row], boxes.half_z[row]};
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            glm::dvec4 p{mesh.positions[v], 1.0};
            for (std::size_t t = instance.morphs; morphed && frame.morphs[t].weight != 0.0f; ++t) {
                const auto& deltas = targets.at(frame.morphs[t].target)->positions;
                if (!deltas.empty())
                    p += glm::dvec4{static_cast<double>(frame.morphs[t].weight) * glm::dvec3{deltas[v]}, 0.0};
            }
            glm::dvec3 placed{0.0};
            for (int i = 0; skinned && i < 4; ++i) {
                const systems::JointMatrix& m = frame.joints[instance.joints + mesh.joints[v][i]];
                placed += static_cast<double>(mesh.weights[v][i]) * moved(m.row0, m.row1, m.row2, p);
            }
            if (!skinned) placed = moved(instance.row0, instance.row1, instance.row2, p);
            const glm::dvec3 beyond = glm::abs(placed - centre) - half;
            found.distance_m = std::max({found.distance_m, beyond.x, beyond.y, beyond.z});
            ++found.vertices;
        }
    };
    for (const auto* queue : {&frame.opaque, &frame.blended}) {
        for (const systems::DrawBatch& batch : *queue) {
            const systems::Pipeline pipeline = systems::unpack_pipeline(batch.pipeline);
            if (!pipeline.skinned && !pipeline.morphed) continue;
            for (std::uint32_t i = 0; i < batch.instance_count; ++i) {
                look_at(frame.instances[batch.first_instance + i], scene.meshes[batch.mesh], pipeline.skinned,
                        pipeline.morphed);
            }
        }
    }
    return found;
}

}  // namespace rambla::test
