#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "systems/frame.h"
#include "systems/look/culling.h"
#include "systems/pack/deformed.h"
#include "systems/pack/radix_sort.h"
#include "systems/pack/sort_key.h"

namespace rambla::systems {

/// Turns what was seen into the Frame's sorted queues. Keeps its memory.
class PackQueues {
public:
    /// Replaces the Frame's instances, joints, morphs, batches, casters, `visible` and `needs_emission`.
    /// @param forward  unit vector along the view: depth is measured along it
    void operator()(const Culling& culling, const Observer& observer, glm::vec3 forward,
                    const MaterialFacts& facts, const DeformationSource& deformed, Frame& frame);

private:
    void make_keys(const Culling& culling, const Observer& observer, glm::vec3 forward,
                   const MaterialFacts& facts, const DeformationSource& deformed, Frame& frame);
    /// Of a row that the camera sees: a key, or one for each of a source's particles.
    void add_surface(const LookChunk& chunk, std::uint32_t row, const Observer& observer, glm::vec3 forward,
                     const MaterialFacts& facts, const LocalBounds& box, Frame& frame);
    void add_particles(const LookChunk& chunk, std::uint32_t row, const Observer& observer, glm::vec3 forward,
                       Frame& frame);
    /// With `fading` where the row is drawn so.
    [[nodiscard]] std::uint32_t surface_pipeline(std::uint32_t row) const;
    std::uint32_t add_instance(const Culling& culling, const Observer& observer, std::uint32_t row,
                               const DeformationSource& deformed, Frame& frame);
    std::uint32_t add_particle_instance(const Culling& culling, std::uint32_t index, Frame& frame);

    /// A ball of haze that is drawn.
    struct Ball {
        glm::vec3 centre_m;  ///< camera-relative
        float radius_m;
        std::uint32_t row;  ///< of its source
        std::uint8_t faded;
    };

    RadixSort sort_;
    PackDeformed deformed_;
    std::vector<SortKey> keys_;
    /// Of keys; those of balls lie behind all rows, in the order of `balls_`.
    std::vector<std::uint32_t> rows_;
    std::vector<Ball> balls_;
    std::vector<std::uint32_t> chunk_of_row_;
    std::vector<std::uint32_t> instance_of_row_;  ///< k_none until written
    std::vector<std::uint32_t> pipeline_of_row_;  ///< with `mirrored`, of rows that are drawn
    std::vector<std::uint8_t> faded_row_;         ///< of rows that are seen
};

/// Appends one drawn thing to a queue: to its last batch if that can take it, else as a new batch.
void append_draw(std::vector<DrawBatch>& queue, std::uint32_t pipeline, std::uint32_t material,
                 std::uint32_t mesh, std::uint32_t instance);

/// Whether an affine map turns the world inside out. Singular maps do not.
[[nodiscard]] bool mirrors(const glm::mat3& linear);

}  // namespace rambla::systems
