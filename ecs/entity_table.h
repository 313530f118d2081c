#pragma once

#include <cstddef>
#include <cstdint>

#include "ecs/entity.h"
#include "ecs/memory.h"

namespace rambla::ecs {

namespace detail {
struct WorldAccess;
}

inline constexpr std::uint32_t k_no_archetype = 0xffffffffu;

/// Where an entity's row is. Free slots have no archetype and keep the next free slot in `row`.
struct EntityRecord {
    std::uint32_t generation;
    std::uint32_t archetype;
    std::uint32_t row;
};
static_assert(sizeof(EntityRecord) <= 16);

/// All entity slots of a world. The slot freed last is used first: the order depends on nothing but the
/// calls.
class EntityTable {
public:
    /// @param max_entities  slots ever in use at one time; at most 2³² − 1
    explicit EntityTable(std::uint32_t max_entities);

    /// Makes sure that the next take() has a slot. Throws CapacityExceeded.
    void reserve_one() {
        if (first_free_ == k_none && size_ == capacity_) grow();
    }
    /// Makes sure that the next `count` take() have slots. Throws CapacityExceeded.
    void reserve(std::uint64_t count) {
        if (alive_ + std::uint64_t{retired_} + count > capacity_) grow_to(alive_ + retired_ + count);
    }
    /// Uses a slot; reserve_one() came before.
    Entity take(std::uint32_t archetype, std::uint32_t row) noexcept {
        ++alive_;
        if (first_free_ == k_none) {
            records()[size_] = {1, archetype, row};
            return {size_++, 1};
        }
        const std::uint32_t index = first_free_;
        EntityRecord& record = records()[index];
        first_free_ = record.row;
        record.archetype = archetype;
        record.row = row;
        return {index, record.generation};
    }
    /// Frees the slot of a living entity. A slot whose generations are used up is never used again.
    void give_back(std::uint32_t index) noexcept {
        EntityRecord& record = records()[index];
        --alive_;
        if (record.generation == k_last_generation) {
            record.archetype = k_no_archetype;
            ++retired_;
            return;
        }
        record = {record.generation + 1, k_no_archetype, first_free_};
        first_free_ = index;
    }

    /// Whether give_back() will free the slot for others.
    [[nodiscard]] static bool is_reusable(Entity entity) { return entity.generation != k_last_generation; }

    /// The record of a living entity, else null.
    [[nodiscard]] EntityRecord* find(Entity entity) noexcept {
        return const_cast<EntityRecord*>(static_cast<const EntityTable*>(this)->find(entity));
    }
    [[nodiscard]] const EntityRecord* find(Entity entity) const noexcept {
        if (entity.index >= size_) return nullptr;
        const EntityRecord& record = records()[entity.index];
        return record.generation == entity.generation && record.archetype != k_no_archetype ? &record
                                                                                            : nullptr;
    }
    /// Asks for the record to be in the cache soon. Any handle will do.
    void prefetch(Entity entity) const noexcept {
        if (entity.index < size_) __builtin_prefetch(records() + entity.index);
    }
    [[nodiscard]] EntityRecord& operator[](std::uint32_t index) noexcept { return records()[index]; }

    /// Says where the row of a living entity is now.
    void place(std::uint32_t index, std::uint32_t archetype, std::uint32_t row) noexcept {
        records()[index].archetype = archetype;
        records()[index].row = row;
    }
    /// Fetches the record ahead of its use; any index will do.
    void prefetch(std::uint32_t index) const noexcept { __builtin_prefetch(records() + index); }

    /// Gives back memory behind the last slot ever used.
    void compact() {
        memory_.decommit(std::size_t{size_} * sizeof(EntityRecord));
        if (ReservedMemory::grows_in_place) capacity_ = size_;
    }

    [[nodiscard]] std::size_t alive_count() const { return alive_; }
    [[nodiscard]] std::size_t memory_bytes() const { return memory_.committed_bytes(); }

private:
    friend struct detail::WorldAccess;

    static constexpr std::uint32_t k_none = 0xffffffffu;
    static constexpr std::uint32_t k_last_generation = 0xffffffffu;

    void grow() { grow_to(std::uint64_t{capacity_} + 1); }
    void grow_to(std::uint64_t slots);
    [[nodiscard]] EntityRecord* records() const noexcept {
        return reinterpret_cast<EntityRecord*>(memory_.data());
    }

    ReservedMemory memory_;
    std::uint32_t max_entities_;
    std::uint32_t capacity_ = 0;
    std::uint32_t size_ = 0;  ///< slots ever used
    std::uint32_t alive_ = 0;
    std::uint32_t retired_ = 0;  ///< slots that are never used again
    std::uint32_t first_free_ = k_none;
};

}  // namespace rambla::ecs
