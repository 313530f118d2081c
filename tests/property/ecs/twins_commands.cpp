#include <algorithm>
#include <string>
#include <utility>

#include "property/ecs/twins.h"

namespace rambla::ecs::property {

void Twins::record(const Operation& operation) {
    // Asked for in one order, with keys in another: playback goes by the keys, the places in recordings_.
    static constexpr std::uint32_t k_order_of_asking[k_recordings]{2, 0, 1};
    if (recordings_[0].commands == nullptr) {
        for (const std::uint32_t place : k_order_of_asking)
            recordings_[place].commands = &queue_.recording({place / 2, place % 2});
    }
    const std::uint32_t place = operation.a % k_recordings;
    Recording& recording = recordings_[place];
    say("in recording " + std::to_string(place) + ":");
    const std::optional<Entity> existing = target(operation);
    const std::vector<Entity>& placeholders = recording.placeholders;
    if (!existing || operation.b % 8 == 0) return record_create(recording, operation);
    const bool on_placeholder = operation.b % 8 == 1 && !placeholders.empty();
    const Entity entity = on_placeholder ? placeholders[operation.c % placeholders.size()] : *existing;
    switch (operation.b / 8 % 8) {
        case 0:
            return record_destroy(recording, entity);
        case 1:
        case 2:
        case 3:
            return record_remove(recording, entity, operation);
        default:
            return record_add(recording, entity, operation);
    }
}

template <class... Cs>
void Twins::record_create_with(Recording& recording, std::uint32_t n) {
    const Entity placeholder = recording.commands->create(make_part<Cs>(n)...);
    recording.placeholders.push_back(placeholder);
    recording.effects.emplace_back([=, this](const Commands& commands) {
        ModelEntity state = newborn();
        ((state.parts[part_number<Cs>()] = value_of<Cs>(n)), ...);
        model_.born(commands.created(placeholder), state);
        return true;
    });
}

void Twins::record_create(Recording& recording, const Operation& operation) {
    say("  create " + std::to_string(operation.c % 4));
    switch (operation.c % 4) {
        case 0:
            return record_create_with<>(recording, operation.c);
        case 1:
            return record_create_with<Owner, SparseAnchored, Light>(recording, operation.c);
        case 2:
            return record_create_with<Parent, Position, Burning>(recording, operation.c);
        default:
            return record_create_with<Health, Anchored>(recording, operation.c);
    }
}

namespace {

/// The entity that a command speaks about, once its recording is played.
Entity real(const Commands& commands, Entity entity) {
    return entity.generation == 0 ? commands.created(entity) : entity;
}

}  // namespace

void Twins::record_add(Recording& recording, Entity entity, const Operation& operation) {
    const std::uint32_t n = operation.c;
    if (operation.c % k_part_count == part_number<Parent>() && !recording.placeholders.empty()) {
        const Entity to = recording.placeholders[n % recording.placeholders.size()];
        say("  add Parent of " + to_string(to) + " to " + to_string(entity));
        recording.commands->add(entity, Parent{to});
        recording.effects.emplace_back([this, entity, to](const Commands& commands) {
            ModelEntity* state = model_.find(real(commands, entity));
            if (state == nullptr) return false;
            set(*state, part_number<Parent>(), key_of(commands.created(to)));
            return true;
        });
        return;
    }
    with_part(n % k_part_count, [&]<class C>() {
        if (!uses<C>()) return;
        say("  add<" + std::string{type_name<C>()} + "> to " + to_string(entity));
        recording.commands->add(entity, make_part<C>(n));
        recording.effects.emplace_back([this, entity, n](const Commands& commands) {
            ModelEntity* state = model_.find(real(commands, entity));
            if (state == nullptr) return false;
            set(*state, part_number<C>(), value_of<C>(n));
            return true;
        });
    });
}

void Twins::record_remove(Recording& recording, Entity entity, const Operation& operation) {
    with_part(operation.c % k_part_count, [&]<class C>() {
        if (!uses<C>()) return;
        say("  remove<" + std::string{type_name<C>()} + "> from " + to_string(entity));
        recording.commands->remove<C>(entity);
        recording.effects.emplace_back([this, entity](const Commands& commands) {
            ModelEntity* state = model_.find(real(commands, entity));
            if (state == nullptr || !state->has(part_number<C>())) return false;
            unset(*state, part_number<C>());
            return true;
        });
    });
}

void Twins::record_destroy(Recording& recording, Entity entity) {
    say("  destroy " + to_string(entity));
    recording.commands->destroy(entity);
    recording.effects.emplace_back([this, entity](const Commands& commands) {
        const Entity ending = real(commands, entity);
        if (model_.find(ending) == nullptr) return false;
        model_.died(ending);
        return true;
    });
}

void Twins::apply(const Operation& operation) {
    if (operation.a % 16 == 0) {
        say("forget the recordings");
        queue_.clear();
        recordings_.assign(k_recordings, {});
        return;
    }
    apply_all();
}

void Twins::apply_all() {
    say("apply");
    const Playback playback = queue_.apply(world_);
    std::size_t applied = 0;
    std::size_t dropped = 0;
    for (Recording& recording : std::exchange(recordings_, std::vector<Recording>(k_recordings))) {
        for (const auto& effect : recording.effects)
            ++(effect(*recording.commands) ? applied : dropped);
    }
    for (auto& [key, entity] : model_.entities())
        settle(entity);
    expect(playback.applied == applied && playback.dropped == dropped, "what a playback says it did");
}

}  // namespace rambla::ecs::property
