#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "systems/frame.h"

namespace rambla::render {

/// What moved since the Frame before, apart from the camera, as the shaders want it.
struct MovedThings {
    /// Of the Frame's opaque queue, in its order. Rows count on behind the Frame's own instances.
    std::vector<systems::DrawBatch> batches;
    /// To be uploaded behind the Frame's: first the things as they are now, then, in the same order, as they
    /// were, relative to the eye as it was. Rows of joints and morph terms count on behind the Frame's, too.
    std::vector<systems::Instance> instances;
    std::span<const systems::JointMatrix> joints{};  ///< as they were; empty where nothing that moved has any
    std::span<const systems::MorphTerm> morphs{};    ///< likewise

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(instances.size() / 2); }
};

/// Remembers where the things of the last Frame were, and finds those that have moved: by rows, joints or
/// morph terms, beyond what rounding does to things at rest while the eye moves. A thing is known again by
/// its object, mesh and material; equal ones by their order. What was not in the Frame before has no past and
/// counts as being at rest.
///
/// Keeps its memory: a steady frame allocates nothing.
class MotionHistory {
public:
    /// @param eye_shift_m  where the eye of this Frame is, seen from that of the last one
    /// @return             valid until the next call, and as long as that Frame is not asked for
    [[nodiscard]] const MovedThings& follow(const systems::Frame& frame, glm::dvec3 eye_shift_m);

    /// Nothing has a past in the next Frame.
    void forget();

private:
    /// One thing of a Frame, by what it is known again by.
    struct Thing {
        std::uint32_t object;
        std::uint32_t mesh;
        std::uint32_t material;
        std::uint32_t instance;  ///< row
        std::uint32_t pipeline;
    };
    /// What is remembered of a Frame.
    struct Moment {
        std::vector<Thing> things;  ///< sorted
        std::vector<systems::Instance> instances;
        std::vector<systems::JointMatrix> joints;
        std::vector<systems::MorphTerm> morphs;
        std::vector<std::uint32_t> skins;  ///< first rows of joints, sorted
    };

    void remember(const systems::Frame& frame, Moment& moment);
    void match(const Moment& then, const Moment& now, glm::dvec3 eye_shift_m);
    void collect(const systems::Frame& frame, const Moment& then);
    [[nodiscard]] static bool has_moved(const Moment& then, const Thing& was, const Moment& now,
                                        const Thing& is, glm::dvec3 eye_shift_m);

    std::array<Moment, 2> moments_;
    std::size_t latest_ = 0;
    std::vector<std::uint32_t> past_row_;  ///< by the present instance's: where it was, if it moved
    MovedThings moved_;
};

}  // namespace rambla::render
