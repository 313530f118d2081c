#include "ecs/commands.h"

#include <cstring>

#include "ecs/iteration.h"
#include "ecs/misuse.h"

namespace rambla::ecs {

Playback Commands::apply(World& world) {
    detail::IterationMark::forbid(world, "Commands::apply");
    created_.clear();
    created_.reserve(placeholders_);
    Playback playback;
    std::size_t next = 0;
    try {
        for (; next < commands_.size(); ++next) {
            if (play(world, commands_[next])) {
                ++playback.applied;
            } else {
                end_values(commands_[next]);
                ++playback.dropped;
            }
        }
    } catch (...) {
        forget_from(next);
        throw;
    }
    forget_from(next);
    return playback;
}

void Commands::clear() noexcept {
    forget_from(0);
}

Entity Commands::created(Entity placeholder) const {
    if (placeholder.generation != 0 || placeholder.index >= created_.size()) {
        detail::throw_not_alive("Commands::created", {}, placeholder);
    }
    return created_[placeholder.index];
}

Entity Commands::resolved(Entity entity) const {
    return entity.generation == 0 && entity.index < created_.size() ? created_[entity.index] : entity;
}

bool Commands::play(World& world, const Command& command) {
    if (command.kind == Kind::create) {
        play_create(world, command);
        return true;
    }
    const Entity entity = resolved(command.entity);
    const EntityRecord* record = world.entities_.find(entity);
    if (record == nullptr) return false;
    switch (command.kind) {
        case Kind::add: {
            void* slot = world.slot_for(entity, *command.values->info);
            resolve_values(command);
            relocate(*command.values, slot);
            return true;
        }
        case Kind::remove: {
            const ComponentInfo& info = *command.values->info;
            if (!world.holds(entity, *record, info)) return false;
            world.take_away(entity, info);
            return true;
        }
        default:
            world.destroy(entity);
            return true;
    }
}

void Commands::play_create(World& world, const Command& command) {
    signature_.clear();
    for (std::size_t i = 0; i < command.value_count; ++i) {
        const ComponentInfo& info = *command.values[i].info;
        if (info.storage != Storage::sparse) signature_.push_back(world.graph_.component(info));
    }
    Archetype& archetype = world.graph_.with_signature(signature_);
    const World::Created created = world.create_in(archetype);
    created_.push_back(created.entity);
    resolve_values(command);
    for (std::size_t i = 0; i < command.value_count; ++i) {
        const Value& value = command.values[i];
        if (value.info->storage == Storage::sparse) {
            relocate(value, world.sparse_slot_for(created.entity, *value.info));
            continue;
        }
        if (value.bytes == nullptr) continue;
        const ColumnIndex column = archetype.column_of(world.graph_.find_component(value.info->type_index));
        relocate(value, archetype.columns()[column].at(created.row));
    }
}

void Commands::resolve_values(const Command& command) const {
    for (std::size_t i = 0; i < command.value_count; ++i) {
        const Value& value = command.values[i];
        if (value.resolve != nullptr) value.resolve(*this, value.bytes);
    }
}

void Commands::relocate(const Value& value, void* to) noexcept {
    if (value.bytes == nullptr) return;
    if (value.info->relocate != nullptr) {
        value.info->relocate(to, value.bytes, 1);
    } else {
        std::memcpy(to, value.bytes, value.info->size);
    }
}

void Commands::end_values(const Command& command) noexcept {
    for (std::size_t i = 0; i < command.value_count; ++i) {
        const Value& value = command.values[i];
        if (value.bytes != nullptr && value.info->destroy != nullptr) value.info->destroy(value.bytes, 1);
    }
}

void Commands::forget_from(std::size_t first) noexcept {
    for (std::size_t i = first; i < commands_.size(); ++i)
        end_values(commands_[i]);
    commands_.clear();
    arena_.clear();
    placeholders_ = 0;
}

}  // namespace rambla::ecs
