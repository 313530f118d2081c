#include <algorithm>
#include <string>

#include "ecs/misuse.h"
#include "ecs/snapshot_parse.h"
#include "ecs/world_access.h"

namespace rambla::ecs::detail {
namespace {

/// Which slots a stream takes from what they were (rows, free) and what it gives to them.
class SlotMarks {
public:
    SlotMarks(std::uint32_t old_slots, std::uint32_t slots, std::size_t offset)
        : marks_(slots, k_untouched), open_{slots - old_slots}, offset_{offset} {
        std::fill(marks_.begin() + old_slots, marks_.end(), k_taken);
    }

    /// The slot was something that ends.
    void take(std::uint32_t slot) {
        marks_[slot] = k_taken;
        ++open_;
    }
    /// The slot becomes something.
    void give(std::uint32_t slot, std::uint32_t generation) {
        const bool open = slot < marks_.size() && marks_[slot] == k_taken && generation != 0;
        if (!open) {
            throw SnapshotError{
                offset_, "slot " + std::to_string(slot) + " of generation " + std::to_string(generation),
                "every slot once: alive, free or retired"};
        }
        marks_[slot] = k_given;
        --open_;
    }
    [[nodiscard]] std::uint64_t open() const { return open_; }

private:
    static constexpr std::uint8_t k_untouched = 0;
    static constexpr std::uint8_t k_taken = 1;
    static constexpr std::uint8_t k_given = 2;

    std::vector<std::uint8_t> marks_;
    std::uint64_t open_;
    std::size_t offset_;  ///< for messages
};

}  // namespace

std::vector<std::uint32_t> free_slots(const World& world) {
    const EntityTable& table = WorldAccess::entities(world);
    std::vector<std::uint32_t> free;
    for (std::uint32_t slot = WorldAccess::first_free(table); slot != WorldAccess::k_no_slot;
         slot = WorldAccess::record(table, slot).row)
        free.push_back(slot);
    std::reverse(free.begin(), free.end());
    return free;
}

void check_slots(const ParsedStream& parsed, const World& world, std::size_t offset) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const EntityTable& table = WorldAccess::entities(world);
    const std::uint32_t old_slots = WorldAccess::slots(table);
    if (parsed.slots > WorldAccess::max_slots(table)) throw_full("entities", WorldAccess::max_slots(table));
    std::uint64_t given = parsed.free.size() + parsed.retired.size();
    for (const ParsedStream::Rows& rows : parsed.rows) {
        for (const ParsedStream::Run& run : rows.entities)
            given += run.rows;
    }
    if (parsed.slots < old_slots || parsed.slots - old_slots > given) {
        throw SnapshotError{offset, std::to_string(parsed.slots) + " slots",
                            std::to_string(old_slots) + " to " + std::to_string(old_slots + given)};
    }
    SlotMarks marks{old_slots, parsed.slots, offset};
    for (const ParsedStream::Rows& rows : parsed.rows) {
        if (rows.archetype >= parsed.known_archetypes) continue;
        const Archetype& archetype = graph[rows.archetype];
        const auto take = [&](std::uint32_t first, std::uint64_t last) {
            for (std::uint64_t row = first; row < std::min<std::uint64_t>(last, archetype.rows()); ++row)
                marks.take(archetype.entities()[row].index);
        };
        for (const ParsedStream::Run& run : rows.entities)
            take(run.first, std::uint64_t{run.first} + run.rows);
        take(rows.rows, archetype.rows());
    }
    const std::vector<std::uint32_t> free = free_slots(world);
    if (parsed.free_kept > free.size()) {
        throw SnapshotError{offset, std::to_string(parsed.free_kept) + " free slots kept",
                            "at most " + std::to_string(free.size())};
    }
    for (std::size_t i = parsed.free_kept; i < free.size(); ++i)
        marks.take(free[i]);

    for (const ParsedStream::Rows& rows : parsed.rows) {
        for (const ParsedStream::Run& run : rows.entities) {
            for (std::uint32_t row = 0; row < run.rows; ++row) {
                const Entity entity = entity_at(run.values, row);
                marks.give(entity.index, entity.generation);
            }
        }
    }
    for (const Entity& slot : parsed.free)
        marks.give(slot.index, slot.generation);
    for (std::uint32_t slot : parsed.retired)
        marks.give(slot, 1);
    if (marks.open() != 0) {
        throw SnapshotError{offset, std::to_string(marks.open()) + " slots that are nothing",
                            "every slot once: alive, free or retired"};
    }
}

}  // namespace rambla::ecs::detail
