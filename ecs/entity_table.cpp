#include "ecs/entity_table.h"

#include <algorithm>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

/// Records committed at a time: at least this many, then an eighth of what is there, which bounds the unused
/// part.
constexpr std::uint32_t k_first_records = 4096;

constexpr std::uint32_t k_last_generation = 0xffffffffu;

}  // namespace

EntityTable::EntityTable(std::uint32_t max_entities)
    : memory_{std::size_t{std::min(max_entities, k_none)} * sizeof(EntityRecord)},
      max_entities_{std::min(max_entities, k_none)} {}

void EntityTable::grow() {
    if (capacity_ == max_entities_) detail::throw_full("entities", max_entities_);
    const std::uint64_t step = std::max(k_first_records, capacity_ / 8);
    const std::uint64_t wanted = std::min<std::uint64_t>(capacity_ + step, max_entities_);
    memory_.commit(wanted * sizeof(EntityRecord));
    capacity_ = static_cast<std::uint32_t>(wanted);
}

Entity EntityTable::take(std::uint32_t archetype, std::uint32_t row) noexcept {
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

void EntityTable::give_back(std::uint32_t index) noexcept {
    EntityRecord& record = records()[index];
    record.archetype = k_no_archetype;
    --alive_;
    if (record.generation == k_last_generation) return;
    ++record.generation;
    record.row = first_free_;
    first_free_ = index;
}

}  // namespace rambla::ecs
