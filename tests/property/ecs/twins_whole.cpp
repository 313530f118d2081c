#include <array>
#include <string>

#include "property/ecs/query_check.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

template <class... Terms>
std::vector<Entity> fitting(const Model& model) {
    std::vector<Entity> entities;
    for (const Entity entity : model.alive()) {
        [[maybe_unused]] const ModelEntity& state = *model.find(entity);
        if ((TermModel<Terms>::fits(state) && ...)) entities.push_back(entity);
    }
    return entities;
}

}  // namespace

template <class C, class... Terms>
void Twins::record_add_to_all(Recording& recording, std::uint32_t n) {
    recording.commands->add_to_all<C, Terms...>(make_part<C>(n));
    recording.effects.emplace_back([this, n](const Commands&) {
        for (const Entity entity : fitting<Terms...>(model_))
            set(model_.at(entity), part_number<C>(), value_of<C>(n));
        return true;
    });
}

/// Of an entity that the same recording made before.
template <class... Terms>
void Twins::record_parent_for_all(Recording& recording, std::uint32_t n) {
    if (recording.placeholders.empty()) return record_add_to_all<Parent, Terms...>(recording, n);
    const Entity to = recording.placeholders[n % recording.placeholders.size()];
    recording.commands->add_to_all<Parent, Terms...>({to, policy_of(n)});
    recording.effects.emplace_back([this, to, n](const Commands& commands) {
        for (const Entity entity : fitting<Terms...>(model_)) {
            const Parent parent{commands.created(to), policy_of(n)};
            set(model_.at(entity), part_number<Parent>(), parent_key(parent));
        }
        return true;
    });
}

template <class C, class... Terms>
void Twins::record_remove_from_all(Recording& recording) {
    recording.commands->remove_from_all<C, Terms...>();
    recording.effects.emplace_back([this](const Commands&) {
        for (const Entity entity : fitting<With<C>, Terms...>(model_))
            unset(model_.at(entity), part_number<C>());
        return true;
    });
}

template <class... Terms>
void Twins::record_destroy_all(Recording& recording) {
    recording.commands->destroy_all<Terms...>();
    recording.effects.emplace_back([this](const Commands&) {
        for (const Entity entity : fitting<Terms...>(model_))
            model_.died(entity);
        return true;
    });
}

/// Every kind of column, with terms of every kind that whole archetypes fit, or none.
void Twins::record_whole(const Operation& operation) {
    using Case = void (*)(Twins&, Recording&, std::uint32_t);
    static constexpr std::array k_cases{
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Position, With<Health>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Frozen, With<Light>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Frozen>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Quad>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Line, With<Byte>, Without<Frozen>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Ticket, AnyOf<Health, Hidden>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Light, With<Position>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Light, Without<Hidden>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Byte, With<Material>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Score, With<Frozen>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_parent_for_all<With<Line>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Health, With<Light>, Without<Material>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t n) {
            t.record_add_to_all<Hidden, With<Tint>>(r, n);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Light, With<Position>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Light>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Frozen>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Hidden, With<Health>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Position, Without<Health>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Ticket, With<Byte>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Owner>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Anchored, With<Frozen>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Score>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Quad>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Line>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Parent, With<Hidden>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_remove_from_all<Byte, AnyOf<Tint, Owner>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_destroy_all<With<Hidden>, With<Frozen>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_destroy_all<With<Tint>, With<Line>>(r);
        }},
        Case{[](Twins& t, Recording& r, std::uint32_t) {
            t.record_destroy_all<Without<Health>>(r);
        }},
    };
    const std::size_t chosen = operation.b % k_cases.size();
    Recording& recording = this->recording(operation);
    say("  whole command " + std::to_string(chosen));
    recording.divided = true;
    k_cases[chosen](*this, recording, operation.c);
}

}  // namespace rambla::ecs::property
