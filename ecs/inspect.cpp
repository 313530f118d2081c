#include "ecs/inspect.h"

#include "ecs/misuse.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

using detail::WorldAccess;

namespace {

const EntityRecord& record_of(const World& world, Entity entity, const char* operation) {
    const EntityRecord* const record = WorldAccess::entities(world).find(entity);
    if (record == nullptr) throw Misuse{std::string{"ecs: "} + operation + ": the entity has ended"};
    return *record;
}

bool writable(const ComponentInfo& info) {
    return info.size > 0 && info.storage != Storage::shared && !info.is_companion;
}

/// Looks for one component of a living entity. @return  whether it is there, its value in `component`
bool find(const World& world, const EntityRecord& record, Entity entity, InspectedComponent& component) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const ComponentInfo& info = *component.type->info;
    const ComponentId id = graph.find_component(info.type_index);
    if (id == k_no_component) return false;
    component.writable = writable(info);
    if (info.storage == Storage::sparse) {
        const SparseSet* const set = graph.sparse().find(id);
        const std::uint32_t place = set == nullptr ? SparseSet::k_none : set->find(entity);
        if (place == SparseSet::k_none) return false;
        component.value = set->value(place);
        return true;
    }
    const Archetype& archetype = graph[record.archetype];
    if (info.storage == Storage::shared) {
        const SharedValue* const value = archetype.shared(id);
        component.value = value == nullptr ? nullptr : value->bytes;
        return value != nullptr;
    }
    const ColumnIndex column = archetype.column_of(id);
    if (column == k_no_column) return false;
    component.value = column == k_tag_column ? nullptr : archetype.columns()[column].at(record.row);
    return true;
}

}  // namespace

std::span<const Entity> entities_of_archetype(const World& world, std::size_t archetype) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    if (archetype >= graph.size()) throw Misuse{"ecs: entities_of_archetype: there is no such archetype"};
    return {graph[archetype].entities(), graph[archetype].rows()};
}

std::vector<InspectedComponent> components_of(const World& world, const TypeRegistry& registry,
                                              Entity entity) {
    const EntityRecord& record = record_of(world, entity, "components_of");
    std::vector<InspectedComponent> components;
    for (const ComponentType& type : registry.components()) {
        InspectedComponent component{.type = &type};
        if (find(world, record, entity, component)) components.push_back(component);
    }
    return components;
}

void* component_for_writing(World& world, const ComponentType& type, Entity entity) {
    const EntityRecord& record = record_of(world, entity, "component_for_writing");
    InspectedComponent component{.type = &type};
    if (!find(world, record, entity, component) || !component.writable) return nullptr;
    ArchetypeGraph& graph = WorldAccess::graph(world);
    const ComponentId id = graph.find_component(type.info->type_index);
    if (type.info->storage == Storage::sparse) {
        const SparseSet& set = *graph.sparse().find(id);
        set.stamp(set.find(entity), world.version());
    } else {
        Archetype& archetype = graph[record.archetype];
        archetype.stamp_row(archetype.column_of(id), record.row, world.version());
    }
    return const_cast<void*>(component.value);
}

}  // namespace rambla::ecs
