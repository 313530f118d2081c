#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "ecs/archetype.h"

namespace rambla::ecs {

/// All archetypes of a world in the order of their birth, found by signature or by one step along an edge:
/// the archetype with one component more or less.
class ArchetypeGraph {
public:
    ArchetypeGraph(std::uint32_t max_rows, bool reserves);

    /// Number of a component; the first call gives it one. Throws CapacityExceeded after 65 533 components.
    ComponentId component(const ComponentInfo& info);
    /// Its number, or k_no_component if the world has not met it.
    [[nodiscard]] ComponentId find_component(std::uint32_t type_index) const {
        return type_index < ids_.size() ? ids_[type_index] : k_no_component;
    }

    /// The archetype with exactly these components. Sorts `signature`, which must hold no doubles.
    Archetype& with_signature(std::span<ComponentId> signature);
    /// The archetype that has `component` too if `from` lacks it, or that lacks it if `from` has it.
    Archetype& toggled(Archetype& from, ComponentId component);

    [[nodiscard]] std::size_t size() const { return archetypes_.size(); }
    [[nodiscard]] Archetype& operator[](std::size_t index) const { return *archetypes_[index]; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct Edge {
        ComponentId component;
        std::uint32_t archetype;
    };

    Archetype* find(std::span<const ComponentId> signature) const;
    Archetype& make(std::span<const ComponentId> signature);

    ArchetypeStorage storage_;
    std::vector<const ComponentInfo*> infos_;  ///< by component number
    std::vector<ComponentId> ids_;             ///< by type index
    std::vector<std::unique_ptr<Archetype>> archetypes_;
    std::vector<std::vector<Edge>> edges_;  ///< by archetype, ascending component numbers
    std::unordered_multimap<std::uint64_t, std::uint32_t> by_signature_;
};

}  // namespace rambla::ecs
