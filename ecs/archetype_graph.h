#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "ecs/archetype.h"
#include "ecs/sparse_set.h"

namespace rambla::ecs {

namespace detail {
struct WorldAccess;
}

/// All that a world stores of its entities: archetypes in the order of their birth, sparse sets and shared
/// values likewise. Archetypes are found by signature, or by one step along an edge: the archetype with one
/// component more or less.
class ArchetypeGraph {
public:
    /// @param oldest_version  what was never written has it
    /// @param memory          of the pool; null: the heap
    ArchetypeGraph(std::uint32_t max_rows, bool reserves, std::uint32_t oldest_version,
                   std::pmr::memory_resource* memory);

    /// Number of a component; the first call gives it one. Throws CapacityExceeded after 65 533 components.
    ComponentId component(const ComponentInfo& info);
    /// Its number, or k_no_component if the world has not met it.
    [[nodiscard]] ComponentId find_component(std::uint32_t type_index) const {
        return type_index < ids_.size() ? ids_[type_index] : k_no_component;
    }

    /// What the component with this number is.
    [[nodiscard]] const ComponentInfo& info(ComponentId component) const { return *infos_[component]; }
    [[nodiscard]] std::size_t component_count() const { return infos_.size(); }

    /// The archetype with exactly these components, none of them sparse. Sorts `signature`, which must hold
    /// no doubles. EnableStates come and go with their components, whether they are listed or not. `shared`
    /// has the values of those that are shared, by ascending components; throws Misuse if one is missing.
    Archetype& with_signature(std::span<ComponentId> signature,
                              std::span<const SharedValue* const> shared = {});
    /// The archetype that has `component`, which is not shared, too if `from` lacks it, or that lacks it if
    /// `from` has it.
    Archetype& toggled(Archetype& from, ComponentId component);
    /// The archetype that differs from `from` in having this value, added or in place of another.
    Archetype& sharing(Archetype& from, const SharedValue& value);

    /// The value of a shared component that is the same as `value`.
    const SharedValue& intern(const ComponentInfo& info, const void* value) {
        return shared_.intern(component(info), info, value);
    }
    [[nodiscard]] const SharedValues& shared() const { return shared_; }

    /// The set of a sparse component.
    SparseSet& sparse_set(const ComponentInfo& info) {
        return sparse_.get_or_make(component(info), storage_.pool, info);
    }
    [[nodiscard]] const SparseSets& sparse() const { return sparse_; }
    [[nodiscard]] SparseSets& sparse() { return sparse_; }

    [[nodiscard]] std::size_t size() const { return archetypes_.size(); }
    [[nodiscard]] Archetype& operator[](std::size_t index) const { return *archetypes_[index]; }
    /// Raises all change versions older than `oldest` to it.
    void age_versions(std::uint32_t oldest) noexcept;
    /// Gives back memory that holds nothing.
    void compact();
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    friend struct detail::WorldAccess;

    struct Edge {
        ComponentId component;
        std::uint32_t archetype;
    };

    /// The signature with the EnableStates that belong to it; lives until the next call.
    std::span<const ComponentId> with_companions(std::span<const ComponentId> signature);
    void require_values(std::span<const ComponentId> signature,
                        std::span<const SharedValue* const> shared) const;
    Archetype* find(std::span<const ComponentId> signature, std::span<const SharedValue* const> shared) const;
    Archetype& make(std::span<const ComponentId> signature, std::span<const SharedValue* const> shared);

    ArchetypeStorage storage_;
    SparseSets sparse_;
    SharedValues shared_{storage_.pool};
    std::vector<const ComponentInfo*> infos_;  ///< by component number
    std::vector<ComponentId> ids_;             ///< by type index
    std::vector<ComponentId> completed_;       ///< what with_companions() returned
    std::vector<ComponentId> neighbour_;       ///< signature of one step from another archetype
    std::vector<const SharedValue*> neighbours_values_;
    bool has_companions_ = false;  ///< some component has an EnableState
    bool has_shared_ = false;      ///< some component is shared
    std::vector<std::unique_ptr<Archetype>> archetypes_;
    std::vector<std::vector<Edge>> edges_;  ///< by archetype, ascending component numbers
    std::unordered_multimap<std::uint64_t, std::uint32_t> by_signature_;
};

}  // namespace rambla::ecs
