#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/hierarchy_nodes.h"
#include "ecs/hierarchy_order.h"

namespace rambla::ecs::detail {

/// Which members a propagation has to visit: the part of Propagation that does not depend on its types.
class PropagationChanges {
public:
    static constexpr std::uint32_t k_none = HierarchyNodes::k_none;

    /// What a member passes on to its children, by slot.
    enum State : std::uint8_t {
        clean = 0,
        changed = 1,  ///< its result is another one than before
        resting = 2,  ///< hangs from a parent outside that has no result
        forced = 4,   ///< a parent above got its result back: results below may be older than their locals
    };
    /// How much of a segment there is to do.
    enum class Work { none, some, all };

    /// @param required  components of the members
    /// @param inputs    those of them, and optional ones, whose change makes a result out of date
    PropagationChanges(std::vector<const ComponentInfo*> required, std::vector<const ComponentInfo*> inputs)
        : nodes_{std::move(required)}, inputs_{std::move(inputs)} {}

    /// Follows the world's structure and finds the chunks whose inputs were written.
    void update(World& world);
    /// Says what became of a parent outside since the last time.
    void note_outside(std::uint32_t slot, bool has_result, bool differs);
    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] Work work(const HierarchyOrder::Segment& segment) const;

    [[nodiscard]] bool is_dirty(std::uint32_t slot) const { return (chunks_[slot / k_chunk_rows] & 1u) != 0; }
    [[nodiscard]] std::uint8_t& state(std::uint32_t slot) { return states_[slot]; }
    /// Notes that results of a chunk were written; from any thread.
    void wrote(std::uint32_t chunk) { note(chunk, k_wrote); }
    /// Notes that a Local of a chunk was given another value: it counts as written again. From any thread.
    void wrote_local(std::uint32_t chunk) { note(chunk, k_wrote_local); }
    /// Stamps chunks: `local` (null: none) where locals were written, `outputs` where results were. Ends the
    /// world's version unless it is shared with other systems.
    void finish(World& world, const ComponentInfo* local, std::span<const ComponentInfo* const> outputs);

    [[nodiscard]] const HierarchyNodes& nodes() const { return nodes_; }
    [[nodiscard]] const HierarchyOrder& order() const { return order_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    static constexpr std::uint8_t k_wrote = 1;
    static constexpr std::uint8_t k_wrote_local = 2;

    void note(std::uint32_t chunk, std::uint8_t what);
    [[nodiscard]] bool inputs_written(const ArchetypeGraph& graph, const HierarchyNodes::Chunk& chunk) const;

    HierarchyNodes nodes_;
    HierarchyOrder order_;
    std::vector<const ComponentInfo*> inputs_;
    std::vector<std::uint8_t> chunks_;  ///< bit 0: there is something to do; bit 1: not for all rows
    std::vector<std::uint8_t> states_;  ///< by slot
    std::vector<std::uint8_t>
        written_;              ///< by chunk: k_wrote, k_wrote_local; the latter stays till the next update
    std::uint32_t since_ = 0;  ///< first version whose writes were not seen
    bool any_ = false;
    bool unfinished_ = false;  ///< the last propagation threw: results are partly new
};

}  // namespace rambla::ecs::detail
