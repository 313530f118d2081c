#include <algorithm>
#include <string>
#include <vector>

#include "ecs/snapshot_parse.h"
#include "ecs/world_access.h"

namespace rambla::ecs::detail {
namespace {

/// By slot: the generation of the entity that will live there, 0 where none will.
std::vector<std::uint32_t> generations_after(const ParsedStream& parsed, const World& world) {
    const EntityTable& table = WorldAccess::entities(world);
    std::vector<std::uint32_t> generations(parsed.slots);
    for (std::uint32_t slot = 0; slot < WorldAccess::slots(table); ++slot) {
        const EntityRecord& record = WorldAccess::record(table, slot);
        if (record.archetype != k_no_archetype) generations[slot] = record.generation;
    }
    for (const Entity& slot : parsed.free)
        generations[slot.index] = 0;
    for (const std::uint32_t slot : parsed.retired)
        generations[slot] = 0;
    for (const ParsedStream::Rows& rows : parsed.rows) {
        for (const ParsedStream::Run& run : rows.entities) {
            for (std::uint32_t row = 0; row < run.rows; ++row) {
                const Entity entity = entity_at(run.values, row);
                generations[entity.index] = entity.generation;
            }
        }
    }
    return generations;
}

void check_alive(Entity entity, const std::vector<std::uint32_t>& generations, std::size_t offset) {
    const bool alive = entity.index < generations.size() && entity.generation != 0 &&
                       generations[entity.index] == entity.generation;
    if (!alive) throw SnapshotError{offset, to_string(entity) + " in a sparse set", "a living entity"};
}

}  // namespace

void check_sparse(const ParsedStream& parsed, const World& world, std::size_t offset) {
    const SparseSets& sets = WorldAccess::graph(world).sparse();
    if (parsed.sparse.empty() && sets.all().empty()) return;
    const std::vector<std::uint32_t> generations = generations_after(parsed, world);
    std::vector<std::uint32_t> members;
    for (const ParsedStream::Sparse& set : parsed.sparse) {
        members.clear();
        for (std::uint32_t place = 0; place < set.size; ++place) {
            const Entity entity = entity_at(set.entities, place);
            check_alive(entity, generations, offset);
            members.push_back(entity.index);
        }
        std::sort(members.begin(), members.end());
        if (std::adjacent_find(members.begin(), members.end()) != members.end())
            throw SnapshotError{offset, "an entity twice in a sparse set", "each once"};
    }
    for (const auto& set : sets.all()) {
        const bool replaced =
            std::any_of(parsed.sparse.begin(), parsed.sparse.end(), [&](const ParsedStream::Sparse& told) {
                const ComponentType* type = parsed.components[told.component].type;
                return type != nullptr && type->info->type_index == set->info().type_index;
            });
        for (std::size_t place = 0; !replaced && place < set->size(); ++place)
            check_alive(set->entities()[place], generations, offset);
    }
}

}  // namespace rambla::ecs::detail
