#include "systems/pack/queue.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assets/material.h"
#include "systems/pack/fading.h"
#include "systems/pack/particles.h"

namespace rambla::systems {
namespace {

bool is_blended(std::uint32_t pipeline) {
    return unpack_pipeline(pipeline).alpha == static_cast<std::uint8_t>(assets::AlphaMode::blend);
}

/// By what a space of this map scales balls, which stay balls in it: no more than any of its axes or any axis
/// of the world, so that the box of a box around a ball encloses it.
float ball_scale(const glm::mat3& linear) {
    const glm::mat3 rows = glm::transpose(linear);
    float least = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        least = std::min({least, glm::length(linear[axis]), glm::length(rows[axis])});
    return least;
}

}  // namespace

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
    make_keys(culling, observer, forward, facts, deformed, frame);
    sort_(keys_, rows_);

    const BoxColumns boxes = culling.boxes();
    const auto row_count = static_cast<std::uint32_t>(culling.seen_by().size());
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const std::uint32_t row = rows_[i];
        if (row >= row_count) {
            const std::uint32_t source = balls_[row - row_count].row;
            const LookChunk& of_source = culling.chunks()[chunk_of_row_[source]];
            // Not mirrored: what stands for a ball faces the eye in any space.
            const Renderable& haze = of_source.renderables[source - of_source.first_row];
            append_draw(frame.blended, haze.pipeline, haze.material, assets::k_none,
                        add_particle_instance(culling, row - row_count, frame));
            continue;
        }
        const LookChunk& chunk = culling.chunks()[chunk_of_row_[row]];
        const Renderable& drawn = chunk.renderables[row - chunk.first_row];
        const std::uint32_t instance = add_instance(culling, observer, row, deformed, frame);
        if (pass_of(keys_[i]) == DrawPass::surfaces) {
            const bool blended = blend_class_of(keys_[i]) == BlendClass::blended;
            append_draw(blended ? frame.blended : frame.opaque, surface_pipeline(row), drawn.material,
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

void PackQueues::make_keys(const Culling& culling, const Observer& observer, glm::vec3 forward,
                           const MaterialFacts& facts, const DeformationSource& deformed, Frame& frame) {
    keys_.clear();
    rows_.clear();
    balls_.clear();
    const std::span<const std::uint32_t> seen_by = culling.seen_by();
    const BoxColumns boxes = culling.boxes();
    chunk_of_row_.resize(seen_by.size());
    instance_of_row_.assign(seen_by.size(), assets::k_none);
    pipeline_of_row_.resize(seen_by.size());
    faded_row_.resize(seen_by.size());
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
            faded_row_[row] = 0;
            // What lies hidden comes last among equal casters: the visible ones then share consecutive
            // instances with the opaque queue, and merge into as few draws.
            float depth_m = std::numeric_limits<float>::infinity();
            if (visible) {
                const LocalBounds box{{boxes.centre_x[row], boxes.centre_y[row], boxes.centre_z[row]},
                                      {boxes.half_x[row], boxes.half_y[row], boxes.half_z[row]}};
                depth_m = glm::dot(forward, box.centre_m);
                add_surface(chunk, row, observer, forward, facts, box, frame);
            }
            if (casts && chunk.sources.empty()) {
                keys_.push_back(
                    opaque_key(DrawPass::shadow_casters, 0, pipeline, drawn.material, drawn.mesh, depth_m));
                rows_.push_back(row);
                ++frame.counts.casters;
            }
        }
    }
}

std::uint32_t PackQueues::surface_pipeline(std::uint32_t row) const {
    const std::uint32_t pipeline = pipeline_of_row_[row];
    const bool whole = faded_row_[row] == 0 || is_blended(pipeline);
    return whole ? pipeline : pipeline | pack(Pipeline{.fading = true});
}

void PackQueues::add_surface(const LookChunk& chunk, std::uint32_t row, const Observer& observer,
                             glm::vec3 forward, const MaterialFacts& facts, const LocalBounds& box,
                             Frame& frame) {
    const std::size_t i = row - chunk.first_row;
    const std::uint8_t gone = faded(chunk, i, box);
    faded_row_[row] = gone;
    if (gone == k_faded_away) return;
    frame.visible.expand(
        assets::Bounds{box.centre_m - box.half_extents_m, box.centre_m + box.half_extents_m});
    ++frame.counts.visible;
    if (!chunk.sources.empty()) {
        add_particles(chunk, row, observer, forward, frame);
        return;
    }
    const Renderable& drawn = chunk.renderables[i];
    const std::uint32_t pipeline = surface_pipeline(row);
    const float depth_m = glm::dot(forward, box.centre_m);
    const bool blended = is_blended(pipeline) || unpack_pipeline(pipeline).fading;
    keys_.push_back(blended
                        ? blended_key(DrawPass::surfaces, 0, depth_m, pipeline, drawn.material)
                        : opaque_key(DrawPass::surfaces, 0, pipeline, drawn.material, drawn.mesh, depth_m));
    rows_.push_back(row);
    frame.needs_emission |= unpack_pipeline(pipeline).unlit;
    frame.needs_emission |=
        drawn.material < facts.needs_emission.size() && facts.needs_emission[drawn.material] != 0;
}

void PackQueues::add_particles(const LookChunk& chunk, std::uint32_t row, const Observer& observer,
                               glm::vec3 forward, Frame& frame) {
    const std::size_t i = row - chunk.first_row;
    const ParticleSource& source = chunk.sources[i];
    const Renderable& drawn = chunk.renderables[i];
    const Placement place = chunk.placement_of(i, observer);
    const float scale = ball_scale(place.linear);
    const float left = 1.0f - static_cast<float>(faded_row_[row]) / 255.0f;
    const auto row_count = static_cast<std::uint32_t>(faded_row_.size());
    for (std::uint32_t number = 0; number < source.count; ++number) {
        const Particle particle = particle_at(source, number, frame.time_s);
        const std::uint8_t gone = faded(particle.opacity * left);
        if (gone == k_faded_away) continue;
        const Ball ball{place.linear * particle.centre_m + place.translation_m, scale * particle.radius_m,
                        row, gone};
        const float depth_m = glm::dot(forward, ball.centre_m);
        const bool is_somewhere = std::isfinite(depth_m) && std::isfinite(ball.radius_m);
        if (!is_somewhere || depth_m + ball.radius_m < 0.0f) continue;
        keys_.push_back(blended_key(DrawPass::surfaces, 0, depth_m, drawn.pipeline, drawn.material));
        rows_.push_back(row_count + static_cast<std::uint32_t>(balls_.size()));
        balls_.push_back(ball);
    }
}

std::uint32_t PackQueues::add_particle_instance(const Culling& culling, std::uint32_t index, Frame& frame) {
    const Ball& ball = balls_[index];
    const LookChunk& chunk = culling.chunks()[chunk_of_row_[ball.row]];
    const std::size_t i = ball.row - chunk.first_row;
    Instance& made = frame.instances.emplace_back();
    made.row0 = {ball.radius_m, 0.0f, 0.0f, ball.centre_m.x};
    made.row1 = {0.0f, ball.radius_m, 0.0f, ball.centre_m.y};
    made.row2 = {0.0f, 0.0f, ball.radius_m, ball.centre_m.z};
    made.material = instance_material(chunk.renderables[i].material, ball.faded);
    made.object = chunk.entities[i].index;
    return static_cast<std::uint32_t>(frame.instances.size() - 1);
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
    made.material = instance_material(chunk.renderables[i].material, faded_row_[row]);
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
