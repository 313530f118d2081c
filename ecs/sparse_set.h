#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecs/block_pool.h"
#include "ecs/component.h"

namespace rambla::ecs {

namespace detail {
struct WorldAccess;
}

/// The values of one component that is stored sparse, in a dense order that depends only on the calls: a new
/// value comes last, and the last one closes the gap of one that goes.
///
///     entity index ──► page of 1024 places ──► place ──► entity, version, value
///
/// Values keep their address until they go or close a gap. Every value has its own change version.
class SparseSet {
public:
    static constexpr std::uint32_t k_none = 0xffffffffu;

    /// Memory comes from `pool`, which outlives the set.
    SparseSet(BlockPool& pool, const ComponentInfo& info);
    ~SparseSet();
    SparseSet(const SparseSet&) = delete;
    SparseSet& operator=(const SparseSet&) = delete;

    [[nodiscard]] const ComponentInfo& info() const { return *info_; }
    [[nodiscard]] std::size_t size() const { return entities_.size(); }
    /// Who has a value, in dense order.
    [[nodiscard]] std::span<const Entity> entities() const { return entities_; }

    /// Place of the entity in the dense order, k_none if it has no value.
    [[nodiscard]] std::uint32_t find(Entity entity) const {
        const std::uint32_t place = find_alive(entity.index);
        return place != k_none && entities_[place] == entity ? place : k_none;
    }
    /// The same for an entity known to be alive.
    [[nodiscard]] std::uint32_t find_alive(std::uint32_t index) const {
        const std::size_t page = index / k_page_places;
        if (page >= pages_.size() || pages_[page] == nullptr) return k_none;
        return pages_[page][index % k_page_places];
    }
    /// Null for tags.
    [[nodiscard]] std::byte* value(std::uint32_t place) const {
        if (info_->size == 0) return nullptr;
        return values_[place / k_page_values] + std::size_t{place % k_page_values} * info_->size;
    }
    /// Version of the last write to the value.
    [[nodiscard]] std::uint32_t version(std::uint32_t place) const { return versions_[place]; }
    void stamp(std::uint32_t place, std::uint32_t version) const noexcept { versions_[place] = version; }
    /// Version at which a value came or went last.
    [[nodiscard]] std::uint32_t membership_version() const { return membership_version_; }

    /// Makes a place for an entity that has none. Its value is raw memory that the caller fills at once.
    /// Throws CapacityExceeded or std::bad_alloc and changes nothing.
    std::uint32_t insert(Entity entity, std::uint32_t version);
    /// Ends the value of an entity that has one.
    void erase(std::uint32_t place, std::uint32_t version) noexcept;
    /// Raises all versions older than `oldest` to it.
    void age_versions(std::uint32_t oldest) noexcept;
    /// Gives back memory that holds no value.
    void compact();

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    friend struct detail::WorldAccess;

    static constexpr std::uint32_t k_page_places = 1024;
    static constexpr std::uint32_t k_page_values = 256;

    [[nodiscard]] std::size_t value_page_bytes() const { return std::size_t{k_page_values} * info_->size; }

    BlockPool* pool_;
    const ComponentInfo* info_;
    std::vector<std::uint32_t*> pages_;  ///< by entity index: places
    std::vector<Entity> entities_;       ///< by place
    /// By place. Views hand out values for writing from several threads, each to its own rows.
    mutable std::vector<std::uint32_t> versions_;
    std::vector<std::byte*> values_;  ///< pages of values by place
    std::uint32_t membership_version_ = 0;
};

/// The sparse sets of a world, in the order of their birth.
class SparseSets {
public:
    /// Null while no value of the component was ever there.
    [[nodiscard]] SparseSet* find(ComponentId component) const {
        return component < by_component_.size() ? by_component_[component] : nullptr;
    }
    SparseSet& get_or_make(ComponentId component, BlockPool& pool, const ComponentInfo& info);
    /// Ends all sparse values of an entity that is about to end.
    void erase_all(Entity entity, std::uint32_t version) noexcept {
        for (const auto& set : sets_) {
            const std::uint32_t place = set->find_alive(entity.index);
            if (place != SparseSet::k_none) set->erase(place, version);
        }
    }

    [[nodiscard]] std::span<const std::unique_ptr<SparseSet>> all() const { return sets_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    std::vector<std::unique_ptr<SparseSet>> sets_;
    std::vector<SparseSet*> by_component_;
};

}  // namespace rambla::ecs
