#include "systems/look/culling.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "assets/assert.h"
#include "systems/pack/particles.h"

namespace rambla::systems {
namespace {

/// Fewer rows than this are culled in less time than it takes to wake other threads.
constexpr std::uint32_t k_parallel_rows = 4096;

}  // namespace

LocalBounds enclosing_box(const LocalBounds& bounds, const Placement& placement) {
    // A coordinate of the centre sums four terms, each rounded at most five times; what went into the
    // translation was rounded before, relative to cell and place, which are at most a cell's edge apart from
    // the result.
    constexpr float k_rounding = 8.0f / 16777216.0f;
    const glm::mat3& linear = placement.linear;
    const glm::mat3 magnitude{glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])};
    const glm::vec3 half = magnitude * bounds.half_extents_m;
    const glm::vec3 turned = magnitude * glm::abs(bounds.centre_m);
    const glm::vec3 slack = (turned + half + glm::abs(placement.translation_m) + k_cell_m) * k_rounding;
    return {linear * bounds.centre_m + placement.translation_m, half + slack};
}

void Culling::operator()(ecs::World& world, const Observer& observer, std::span<const CullVolume> volumes) {
    RAMBLA_ASSERT(volumes.size() <= k_max_cull_volumes, "a mask has a bit per volume");
    chunks_.clear();
    rows_ = 0;
    collect(world, casters_, true);
    collect(world, shadowless_, false);
    for (auto* column : {&centre_x_, &centre_y_, &centre_z_, &half_x_, &half_y_, &half_z_})
        column->resize(rows_);
    seen_by_.resize(rows_);

    const auto look = [&](std::size_t i) {
        LookChunk& chunk = chunks_[i];
        gather(chunk, observer);
        const std::size_t rows = chunk.entities.size();
        const auto part = [&](const std::vector<float>& column) {
            return std::span{column}.subspan(chunk.first_row, rows);
        };
        cull({part(centre_x_), part(centre_y_), part(centre_z_), part(half_x_), part(half_y_), part(half_z_)},
             volumes, std::span{seen_by_}.subspan(chunk.first_row, rows));
    };
    if (rows_ < k_parallel_rows) {
        for (std::size_t i = 0; i < chunks_.size(); ++i)
            look(i);
    } else {
        tbb::parallel_for(std::size_t{0}, chunks_.size(), look);
    }
}

BoxColumns Culling::boxes() const {
    return {centre_x_, centre_y_, centre_z_, half_x_, half_y_, half_z_};
}

std::uint32_t Culling::broken_bounds() const {
    std::uint32_t broken = 0;
    for (const LookChunk& chunk : chunks_)
        broken += chunk.broken_bounds;
    return broken;
}

template <class Query>
void Culling::collect(ecs::World& world, Query& query, bool casts_shadows) {
    for (auto [entities, now, renderables, bounds, before, skins, morphs, opacities, near_fades, sources] :
         query.chunks(world)) {
        chunks_.push_back({entities, now, before, renderables, bounds, skins, morphs, opacities, near_fades,
                           sources, casts_shadows, rows_, 0});
        rows_ += static_cast<std::uint32_t>(entities.size());
    }
}

void Culling::gather(LookChunk& chunk, const Observer& observer) {
    for (std::size_t i = 0; i < chunk.entities.size(); ++i) {
        // Of a source that somebody has changed, the bounds that it was made with say nothing.
        const LocalBounds local = chunk.sources.empty() ? chunk.bounds[i] : particle_bounds(chunk.sources[i]);
        const LocalBounds box = enclosing_box(local, chunk.placement_of(i, observer));
        const std::size_t row = chunk.first_row + i;
        centre_x_[row] = box.centre_m.x;
        centre_y_[row] = box.centre_m.y;
        centre_z_[row] = box.centre_m.z;
        half_x_[row] = box.half_extents_m.x;
        half_y_[row] = box.half_extents_m.y;
        half_z_[row] = box.half_extents_m.z;
        // Zero times a number is zero, and NaN for what is none; infinities of either sign cannot cancel.
        const glm::vec3 probe = box.centre_m * 0.0f + box.half_extents_m * 0.0f;
        if (!(probe.x == 0.0f && probe.y == 0.0f && probe.z == 0.0f)) ++chunk.broken_bounds;
    }
}

}  // namespace rambla::systems
