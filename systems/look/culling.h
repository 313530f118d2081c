#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ecs/query.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/look/cull_kernel.h"
#include "systems/look/observer.h"

namespace rambla::systems {

/// Bits of the visibility masks.
inline constexpr std::uint32_t k_seen_by_camera = 1u;
inline constexpr std::uint32_t k_seen_by_sun = 2u;  ///< may throw a shadow into the picture

/// Renderables of one chunk, and the place of its first row in the columns of all.
struct LookChunk {
    std::span<const ecs::Entity> entities;
    std::span<const WorldTransform> now;
    std::span<const PreviousWorldTransform> before;  ///< empty: at rest
    std::span<const Renderable> renderables;
    std::span<const LocalBounds> bounds;
    std::span<const Skinned> skins;           ///< empty: rigid
    std::span<const Morphed> morphs;          ///< empty: not morphed
    std::span<const Opacity> opacities;       ///< empty: whole
    std::span<const NearFade> near_fades;     ///< empty: as whole near the eye as anywhere
    std::span<const ParticleSource> sources;  ///< empty: meshes
    bool casts_shadows = true;
    std::uint32_t first_row = 0;
    std::uint32_t broken_bounds = 0;  ///< NaN or infinite

    [[nodiscard]] Placement placement_of(std::size_t row, const Observer& observer) const {
        return before.empty() ? placement(now[row], observer)
                              : placement(before[row].value, now[row], observer);
    }
};

/// Gathers the camera-relative boxes of all renderables into columns and culls them against all views in one
/// sweep. Rows stand in the order of the world's chunks, whatever the number of threads. Keeps its memory.
class Culling {
public:
    /// @param volumes  at most k_max_cull_volumes, camera-relative
    void operator()(ecs::World& world, const Observer& observer, std::span<const CullVolume> volumes);

    [[nodiscard]] std::span<const LookChunk> chunks() const { return chunks_; }
    [[nodiscard]] BoxColumns boxes() const;
    [[nodiscard]] std::span<const std::uint32_t> seen_by() const { return seen_by_; }
    [[nodiscard]] std::uint32_t broken_bounds() const;

private:
    template <class Filter>
    using Drawn = ecs::Query<ecs::Entity, const WorldTransform, const Renderable, const LocalBounds,
                             ecs::Optional<const PreviousWorldTransform>, ecs::Optional<const Skinned>,
                             ecs::Optional<const Morphed>, ecs::Optional<const Opacity>,
                             ecs::Optional<const NearFade>, ecs::Optional<const ParticleSource>, Filter>;

    template <class Query>
    void collect(ecs::World& world, Query& query, bool casts_shadows);
    void gather(LookChunk& chunk, const Observer& observer);

    Drawn<ecs::Without<NoShadow>> casters_;
    Drawn<ecs::With<NoShadow>> shadowless_;
    std::vector<LookChunk> chunks_;
    std::uint32_t rows_ = 0;
    std::vector<float> centre_x_, centre_y_, centre_z_;
    std::vector<float> half_x_, half_y_, half_z_;
    std::vector<std::uint32_t> seen_by_;
};

/// The camera-relative box of a box under a placement. Encloses the exact image of the box: half extents are
/// widened by the rounding of what they were computed from.
[[nodiscard]] LocalBounds enclosing_box(const LocalBounds& bounds, const Placement& placement);

}  // namespace rambla::systems
