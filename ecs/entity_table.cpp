#include "ecs/entity_table.h"

#include <algorithm>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

/// Records committed at a time: at least this many, then 1/32 of what is there, which bounds the unused
/// part.
constexpr std::uint32_t k_first_records = 4096;

}  // namespace

EntityTable::EntityTable(std::uint32_t max_entities)
    : memory_{std::size_t{std::min(max_entities, k_none)} * sizeof(EntityRecord)},
      max_entities_{std::min(max_entities, k_none)} {}

void EntityTable::grow_to(std::uint64_t slots) {
    if (slots > max_entities_) detail::throw_full("entities", max_entities_);
    const std::uint64_t step = std::max(k_first_records, capacity_ / 32);
    const std::uint64_t wanted = std::min<std::uint64_t>(std::max(slots, capacity_ + step), max_entities_);
    memory_.commit(wanted * sizeof(EntityRecord));
    capacity_ = static_cast<std::uint32_t>(wanted);
}

}  // namespace rambla::ecs
