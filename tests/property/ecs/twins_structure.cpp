#include <algorithm>
#include <string>

#include "ecs/misuse.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

constexpr std::uint32_t k_bundles = 10;

}  // namespace

template <class... Cs>
void Twins::create_with(std::uint32_t n) {
    const Entity entity = [&] {
        if constexpr (sizeof...(Cs) == 0) {
            return world_.create();
        } else {
            return world_.create(make_part<Cs>(n)...);
        }
    }();
    ModelEntity state = newborn();
    ((state.parts[part_number<Cs>()] = value_of<Cs>(n)), ...);
    settle(state);
    model_.born(entity, state);
}

void Twins::create_bundle(std::uint32_t bundle, std::uint32_t n) {
    switch (bundle % k_bundles) {
        case 0:
            return create_with<>(n);
        case 1:
            return create_with<Anchored, Frozen>(n);
        case 2:
            return create_with<Position>(n);
        case 3:
            return create_with<Owner, Position, Health>(n);
        case 4:
            return create_with<Hidden>(n);
        case 5:
            return create_with<Line, Byte, Parent, Burning>(n);
        case 6:
            return create_with<Light, Health, Selected>(n);
        case 7:
            return create_with<Material, Position, Score, Quad>(n);
        case 8:
            return create_with<Tint, Ticket, Health, Light>(n);
        default:
            return create_with<Health, Anchored>(n);
    }
}

void Twins::create(const Operation& operation) {
    if (model_.alive().size() > k_most_entities) return;
    create_bundle(operation.a, operation.c);
    say("create bundle " + std::to_string(operation.a % k_bundles) + " -> " +
        to_string(model_.alive().back()));
}

void Twins::create_wave(const Operation& operation) {
    if (model_.alive().size() > k_most_entities) return destroy_kind(operation);
    const std::uint32_t count = 100 + operation.b % 1500;
    say("create " + std::to_string(count) + " of bundle " + std::to_string(operation.a % k_bundles));
    for (std::uint32_t i = 0; i < count; ++i)
        create_bundle(operation.a, operation.c + i);
}

void Twins::destroy(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    say("destroy " + to_string(*entity));
    world_.destroy(*entity);
    model_.died(*entity);
    follow_ends();
}

void Twins::destroy_kind(const Operation& operation) {
    const std::size_t part = operation.a % k_part_count;
    if (model_.alive().size() < k_most_entities / 2) return;
    std::vector<Entity> ending = model_.alive();
    std::erase_if(ending, [&](Entity entity) { return !model_.at(entity).has(part); });
    say("destroy all " + std::to_string(ending.size()) + " with part " + std::to_string(part));
    for (const Entity entity : ending) {
        if (model_.find(entity) == nullptr) continue;  // as a child of another
        world_.destroy(entity);
        model_.died(entity);
        follow_ends();
    }
}

void Twins::add(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    with_part(operation.c % k_part_count, [&]<class C>() {
        say("add<" + std::string{type_name<C>()} + "> to " + to_string(*entity));
        world_.add(*entity, make_part<C>(operation.c));
        set(model_.at(*entity), part_number<C>(), value_of<C>(operation.c));
        settle(model_.at(*entity));
    });
}

void Twins::remove(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    with_part(operation.c % k_part_count, [&]<class C>() {
        say("remove<" + std::string{type_name<C>()} + "> from " + to_string(*entity));
        ModelEntity& state = model_.at(*entity);
        std::optional<std::uint64_t>& part = state.parts[part_number<C>()];
        if (!part) {
            if (operation.b % 16 != 0) return;  // exceptions are slow
            expect_misuse([&] { world_.remove<C>(*entity); }, "a part was removed that was not there");
            return;
        }
        world_.remove<C>(*entity);
        unset(state, part_number<C>());
        settle(state);
    });
}

void Twins::write(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    with_part(operation.c % k_part_count, [&]<class C>() {
        if constexpr (!is_tag<C> && storage_of<C> != Storage::shared) {
            ModelEntity& state = model_.at(*entity);
            C* part = world_.try_get_mut<C>(*entity);
            expect((part != nullptr) == state.has(part_number<C>()), "try_get_mut finds a part");
            if (part == nullptr) return;
            say("write " + std::string{type_name<C>()} + " of " + to_string(*entity));
            *part = make_part<C>(operation.c);
            overwrite(state, part_number<C>(), value_of<C>(operation.c));
        }
    });
}

void Twins::toggle(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    const bool enabled = operation.c % 2 == 0;
    ModelEntity& state = model_.at(*entity);
    if (!state.has(part_number<Light>())) {
        if (operation.b % 16 != 0) return;
        expect_misuse([&] { world_.set_enabled<Light>(*entity, enabled); }, "a missing part was switched");
        return;
    }
    say((enabled ? "enable Light of " : "disable Light of ") + to_string(*entity));
    world_.set_enabled<Light>(*entity, enabled);
    state.disabled[part_number<Light>()] = !enabled;
}

void Twins::check_one(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    expect(world_.alive(*entity), "an entity is alive");
    const ModelEntity& state = model_.at(*entity);
    with_part(operation.c % k_part_count, [&]<class C>() {
        const std::optional<std::uint64_t>& part = state.parts[part_number<C>()];
        expect(world_.has<C>(*entity) == part.has_value(), "has() agrees");
        if constexpr (has_enable_bit<C>) {
            if (part)
                expect(world_.enabled<C>(*entity) != state.disabled[part_number<C>()], "enabled() agrees");
        }
        if constexpr (!is_tag<C>) {
            const C* found = world_.try_get<C>(*entity);
            expect((found != nullptr) == part.has_value(), "try_get finds a part");
            if (found != nullptr) {
                expect(read_part(*found) == part, "a part keeps its value");
                expect(&world_.get<C>(*entity) == found, "get and try_get agree");
            }
        }
    });
}

void Twins::check_dead(const Operation& operation) {
    if (model_.dead().empty()) return;
    const Entity entity = model_.dead()[operation.a % model_.dead().size()];
    expect(!world_.alive(entity), "a dead entity is not alive");
    if (operation.b % 32 != 0) return;
    expect_misuse([&] { world_.destroy(entity); }, "a dead entity was destroyed again");
    expect_misuse([&] { world_.add(entity, Health{1}); }, "a dead entity got a part");
    expect_misuse([&] { (void)world_.try_get<Health>(entity); }, "a dead entity was read");
}

}  // namespace rambla::ecs::property
