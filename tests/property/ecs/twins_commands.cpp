#include <algorithm>
#include <string>
#include <utility>

#include "property/ecs/twins.h"

namespace rambla::ecs::property {

Twins::Recording& Twins::recording(const Operation& operation) {
    // Asked for in one order, with keys in another: playback goes by the keys, the places in recordings_.
    static constexpr std::uint32_t k_order_of_asking[k_recordings]{2, 0, 1};
    if (recordings_[0].commands == nullptr) {
        for (const std::uint32_t place : k_order_of_asking)
            recordings_[place].commands = &queue_.recording({place / 2, place % 2});
    }
    const std::uint32_t place = operation.a % k_recordings;
    say("in recording " + std::to_string(place) + ":");
    return recordings_[place];
}

void Twins::record(const Operation& operation) {
    Recording& recording = this->recording(operation);
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
        case 4:  // goes, and comes again as another
            record_remove(recording, entity, operation);
            return record_add(recording, entity, operation);
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
            return record_create_with<Owner, SparseAnchored, Light, Material>(recording, operation.c);
        case 2:
            return record_create_with<Parent, Position, Burning, Score>(recording, operation.c);
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
        recording.commands->add(entity, Parent{to, policy_of(n)});
        recording.effects.emplace_back([this, entity, to, n](const Commands& commands) {
            ModelEntity* state = model_.find(real(commands, entity));
            if (state == nullptr) return false;
            set(*state, part_number<Parent>(), parent_key({commands.created(to), policy_of(n)}));
            return true;
        });
        return;
    }
    with_part(n % k_part_count, [&]<class C>() {
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
    if (mirror_ != nullptr)
        mirror_->watch_order(world_, std::ranges::none_of(recordings_, &Recording::divided));
    apply_all();
}

void Twins::apply_all() {
    say("apply");
    const std::uint32_t version = world_.version();
    const Playback playback = queue_.apply(world_);
    play_effects(std::exchange(recordings_, std::vector<Recording>(k_recordings)), playback, version);
}

/// Many commands of one kind about the entities of one archetype, in any order, in up to three recordings;
/// sometimes with one among them that is about another entity, one that has ended, or one that had its turn.
void Twins::apply_alike(const Operation& operation) {
    const std::optional<Entity> example = target(operation);
    if (!example) return;
    std::vector<Entity> entities;
    for (const Entity entity : model_.alive()) {
        if (model_.at(entity).home == model_.at(*example).home) entities.push_back(entity);
    }
    // Those that a random number of steps leads to, each once.
    const std::size_t wanted = std::min<std::size_t>(entities.size(), 10 + operation.b % 1500);
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t from = i + (operation.c / 64 + i * 7919) % (entities.size() - i);
        std::swap(entities[i], entities[operation.b % 3 == 0 ? i : from]);
    }
    entities.resize(wanted);
    Entity& odd = entities[operation.b / 4 % wanted];
    if (operation.b % 16 == 1) odd = model_.alive()[operation.c % model_.alive().size()];
    if (operation.b % 16 == 2 && !model_.dead().empty()) odd = model_.dead().back();
    if (operation.b % 16 == 3) odd = entities.back();
    CommandQueue queue;
    std::vector<Recording> recordings(1 + operation.a % k_recordings);
    for (std::uint32_t place = 0; place < recordings.size(); ++place)
        recordings[place].commands = &queue.recording({place, 0});
    const bool removes = model_.at(*example).has(operation.c % k_part_count) && operation.b / 16 % 2 == 0;
    say((removes ? "remove from " : "add to ") + std::to_string(wanted) + " alike, in " +
        std::to_string(recordings.size()) + " recordings:");
    const auto part = static_cast<std::uint32_t>(operation.c % k_part_count);
    for (std::uint32_t i = 0; i < wanted; ++i) {
        // Other values of the same part, in the high bits where most parts have theirs.
        const std::uint32_t n = operation.c + (i << 18u);
        Recording& recording = recordings[i * recordings.size() / wanted];
        const Operation one{.c = n - n % static_cast<std::uint32_t>(k_part_count) + part};
        if (removes) {
            record_remove(recording, entities[i], one);
        } else {
            record_add(recording, entities[i], one);
        }
    }
    if (mirror_ != nullptr) mirror_->watch_order(world_, true);
    const std::uint32_t version = world_.version();
    const Playback playback = queue.apply(world_);
    play_effects(recordings, playback, version);
}

void Twins::play_effects(std::span<const Recording> recordings, const Playback& playback,
                         std::uint32_t version) {
    stamp_ = version;
    std::size_t applied = 0;
    std::size_t dropped = 0;
    for (const Recording& recording : recordings) {
        for (const auto& effect : recording.effects)
            ++(effect(*recording.commands) ? applied : dropped);
    }
    for (auto& [key, entity] : model_.entities())
        settle(entity);
    stamp_.reset();
    follow_ends();
    expect(playback.applied == applied && playback.dropped == dropped, "what a playback says it did");
}

}  // namespace rambla::ecs::property
