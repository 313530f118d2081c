#include "systems/pack/queue.h"

#include <limits>

#include "assets/material.h"

namespace rambla::systems {

void append_draw(std::vector<DrawBatch>& queue, std::uint32_t pipeline, std::uint32_t material,
                 std::uint32_t mesh, std::uint32_t instance) {
    if (!queue.empty()) {
        DrawBatch& last = queue.back();
        const bool alike = last.pipeline == pipeline && last.material == material && last.mesh == mesh;
        if (alike && last.first_instance + last.instance_count == instance) {
            ++last.instance_count;
            return;
        }
    }
    queue.push_back({pipeline, material, mesh, instance, 1});
}

bool mirrors(const glm::mat3& linear) {
    // In double: the product of three small scales must not underflow to zero.
    const glm::dmat3 exact{linear};
    return glm::dot(glm::cross(exact[0], exact[1]), exact[2]) < 0.0;
}

void PackQueues::operator()(const Culling& culling, const Observer& observer, glm::vec3 forward,
                            const MaterialFacts& facts, const DeformationSource& deformed, Frame& frame) {
    frame.instances.clear();
    frame.opaque.clear();
    frame.blended.clear();
    CasterColumns& casters = frame.casters;
    for (auto* column : {&casters.centre_x, &casters.centre_y, &casters.centre_z, &casters.half_x,
                         &casters.half_y, &casters.half_z}) {
        column->clear();
    }
    for (auto* column : {&casters.pipeline, &casters.material, &casters.mesh, &casters.instance})
        column->clear();

    deformed_.begin(deformed, frame);
    make_keys(culling, forward, facts, deformed, frame);
    sort_(keys_, rows_);

    const BoxColumns boxes = culling.boxes();
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const std::uint32_t row = rows_[i];
        const LookChunk& chunk = culling.chunks()[chunk_of_row_[row]];
        const Renderable& drawn = chunk.renderables[row - chunk.first_row];
        const std::uint32_t instance = add_instance(culling, observer, row, deformed, frame);
        if (pass_of(keys_[i]) == DrawPass::surfaces) {
            const bool blended = blend_class_of(keys_[i]) == BlendClass::blended;
            append_draw(blended ? frame.blended : frame.opaque, pipeline_of_row_[row], drawn.material,
                        drawn.mesh, instance);
            continue;
        }
        casters.centre_x.push_back(boxes.centre_x[row]);
        casters.centre_y.push_back(boxes.centre_y[row]);
        casters.centre_z.push_back(boxes.centre_z[row]);
        casters.half_x.push_back(boxes.half_x[row]);
        casters.half_y.push_back(boxes.half_y[row]);
        casters.half_z.push_back(boxes.half_z[row]);
        casters.pipeline.push_back(pipeline_of_row_[row]);
        casters.material.push_back(drawn.material);
        casters.mesh.push_back(drawn.mesh);
        casters.instance.push_back(instance);
    }
}

void PackQueues::make_keys(const Culling& culling, glm::vec3 forward, const MaterialFacts& facts,
                           const DeformationSource& deformed, Frame& frame) {
    keys_.clear();
    rows_.clear();
    const std::span<const std::uint32_t> seen_by = culling.seen_by();
    const BoxColumns boxes = culling.boxes();
    chunk_of_row_.resize(seen_by.size());
    instance_of_row_.assign(seen_by.size(), assets::k_none);
    pipeline_of_row_.resize(seen_by.size());
    frame.visible = {};
    frame.needs_emission = false;
    frame.counts.visible = 0;
    frame.counts.casters = 0;
    for (std::uint32_t c = 0; c < culling.chunks().size(); ++c) {
        const LookChunk& chunk = culling.chunks()[c];
        for (std::uint32_t i = 0; i < chunk.entities.size(); ++i) {
            const std::uint32_t row = chunk.first_row + i;
            const bool visible = (seen_by[row] & k_seen_by_camera) != 0;
            const bool casts = chunk.casts_shadows && (seen_by[row] & k_seen_by_sun) != 0;
            if (!visible && !casts) continue;
            // A skin that came after the last step has no pose yet.
            if (!chunk.skins.empty() && deformed.poses.skin(chunk.skins[i].skin) == nullptr) continue;

            const Renderable& drawn = chunk.renderables[i];
            const Pipeline mirror{.mirrored = mirrors(chunk.now[i].linear)};
            const std::uint32_t pipeline = drawn.pipeline | pack(mirror);
            chunk_of_row_[row] = c;
            pipeline_of_row_[row] = pipeline;
            // What lies hidden comes last among equal casters: the visible ones then share consecutive
            // instances with the opaque queue, and merge into as few draws.
            float depth_m = std::numeric_limits<float>::infinity();
            if (visible) {
                const glm::vec3 centre{boxes.centre_x[row], boxes.centre_y[row], boxes.centre_z[row]};
                const glm::vec3 half{boxes.half_x[row], boxes.half_y[row], boxes.half_z[row]};
                frame.visible.expand(assets::Bounds{centre - half, centre + half});
                depth_m = glm::dot(forward, centre);
                const bool blended =
                    unpack_pipeline(pipeline).alpha == static_cast<std::uint8_t>(assets::AlphaMode::blend);
                keys_.push_back(
                    blended
                        ? blended_key(DrawPass::surfaces, 0, depth_m, pipeline, drawn.material)
                        : opaque_key(DrawPass::surfaces, 0, pipeline, drawn.material, drawn.mesh, depth_m));
                rows_.push_back(row);
                ++frame.counts.visible;
                frame.needs_emission |= unpack_pipeline(pipeline).unlit;
                frame.needs_emission |=
                    drawn.material < facts.needs_emission.size() && facts.needs_emission[drawn.material] != 0;
            }
            if (casts) {
                keys_.push_back(
                    opaque_key(DrawPass::shadow_casters, 0, pipeline, drawn.material, drawn.mesh, depth_m));
                rows_.push_back(row);
                ++frame.counts.casters;
            }
        }
    }
}

std::uint32_t PackQueues::add_instance(const Culling& culling, const Observer& observer, std::uint32_t row,
                                       const DeformationSource& deformed, Frame& frame) {
    std::uint32_t& instance = instance_of_row_[row];
    if (instance != assets::k_none) return instance;
    instance = static_cast<std::uint32_t>(frame.instances.size());
    const LookChunk& chunk = culling.chunks()[chunk_of_row_[row]];
    const std::size_t i = row - chunk.first_row;
    const Placement place = chunk.placement_of(i, observer);
    const glm::mat3 rows = glm::transpose(place.linear);
    Instance& made = frame.instances.emplace_back();
    made.row0 = glm::vec4{rows[0], place.translation_m.x};
    made.row1 = glm::vec4{rows[1], place.translation_m.y};
    made.row2 = glm::vec4{rows[2], place.translation_m.z};
    made.material = chunk.renderables[i].material;
    made.object = chunk.entities[i].index;
    if (!chunk.skins.empty()) {
        made.joints =
            deformed_.joints_of(deformed, *deformed.poses.skin(chunk.skins[i].skin), observer, frame);
    }
    if (!chunk.morphs.empty()) {
        made.morphs = deformed_.morphs_of(deformed, chunk.morphs[i], chunk.renderables[i].mesh,
                                          observer.interpolation, frame);
    }
    return instance;
}

}  // namespace rambla::systems
