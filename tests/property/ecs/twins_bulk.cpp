#include <algorithm>
#include <stdexcept>
#include <string>

#include "ecs/create_many.h"
#include "ecs/get_many.h"
#include "ecs/query.h"
#include "property/ecs/queries.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

/// Whether all of these rows are in one chunk.
bool in_one_chunk(const World& world, std::span<const Entity> rows) {
    Query<Entity> all;
    for (const auto& chunk : all.chunks(world)) {
        const std::span<const Entity> entities = chunk.get<0>();
        const bool begins_here =
            rows.data() >= entities.data() && rows.data() < entities.data() + entities.size();
        if (begins_here) return rows.data() + rows.size() <= entities.data() + entities.size();
    }
    return false;
}

struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace

template <class... Cs>
void Twins::create_copies(std::uint32_t count, std::uint32_t n) {
    const std::span<const Entity> made = ecs::create_many(world_, count, make_part<Cs>(n)...);
    expect(made.size() == count, "as many as wanted are made");
    for (const Entity entity : made) {
        ModelEntity state = newborn();
        ((state.parts[part_number<Cs>()] = value_of<Cs>(n)), ...);
        settle(state);
        model_.born(entity, state);
    }
}

/// Numbers from n on; some fillers throw on the way, and what they have not reached stays as it began.
template <class... Cs>
void Twins::create_filled(std::uint32_t count, const Operation& operation) {
    const std::uint32_t n = operation.c;
    const std::uint32_t until = operation.b % 4 == 0 ? n % (count + 1) : count;
    std::vector<Entity> met;
    const auto fill = [&](std::span<const Entity> entities, auto... columns) {
        expect(in_one_chunk(world_, entities), "a filler gets rows of several chunks at once");
        for (std::size_t i = 0; i < entities.size(); ++i) {
            if (met.size() == until) throw Refused{"enough"};
            const std::uint32_t number = n + static_cast<std::uint32_t>(met.size());
            ((columns[i] = make_part<typename decltype(columns)::value_type>(number)), ...);
            met.push_back(entities[i]);
        }
    };
    std::vector<Entity> made;
    bool refused = false;
    try {
        const std::span<const Entity> all = create_many_with<Cs...>(world_, count, fill);
        made.assign(all.begin(), all.end());
    } catch (const Refused&) {
        refused = true;
    }
    expect(refused == (until < count), "what a filler throws comes to its caller");
    if (refused) {
        Query<Entity> all;
        all.each(world_, [&](Entity entity) {
            if (model_.find(entity) == nullptr) made.push_back(entity);
        });
        // New rows are the last of their archetype, so they come in the order in which they were met.
    }
    expect(made.size() == count && std::equal(met.begin(), met.end(), made.begin()),
           "a filler gets all entities in the order of their rows");
    const std::size_t filled = met.size();
    for (std::size_t i = 0; i < made.size(); ++i) {
        ModelEntity state = newborn();
        const std::uint32_t number = n + static_cast<std::uint32_t>(i);
        ((state.parts[part_number<Cs>()] = i < filled ? value_of<Cs>(number) : *read_part(Cs{})), ...);
        settle(state);
        model_.born(made[i], state);
    }
}

void Twins::create_many(const Operation& operation) {
    if (model_.alive().size() > k_most_entities) return;
    const std::uint32_t count = operation.a % 8 == 0 ? operation.b % 2000 : operation.b % 60;
    say("create many: " + std::to_string(count) + ", way " + std::to_string(operation.a % 7));
    switch (operation.a % 7) {
        case 0:
            return create_copies<Health, Light>(count, operation.c);
        case 1:
            return create_copies<Ticket, Frozen>(count, operation.c);
        case 2:
            return create_copies<Line, Byte, Parent>(count, operation.c);
        case 3:
            return create_copies<Score, Position>(count, operation.c);
        case 4:
            return create_filled<Health, Byte>(count, operation);
        case 5:
            return create_filled<Ticket, Score, Light>(count, operation);
        default:
            return create_filled<Owner, Parent>(count, operation);
    }
}

template <class C>
void Twins::get_many_of(const std::vector<Entity>& entities, const Operation& operation) {
    if constexpr (!is_tag<C>) {
        const std::size_t part = part_number<C>();
        const auto missing =
            std::ranges::find_if(entities, [&](Entity entity) { return !model_.at(entity).has(part); });
        std::size_t next = 0;
        const auto check = [&](std::size_t i, const C& value) {
            expect(i == next++, "many are handed out one after the other");
            expect(read_part(value) == model_.at(entities[i]).parts[part], "one of many has a wrong value");
        };
        if (missing != entities.end()) {
            return expect_misuse([&] { world_.get_many<C>(entities, check); }, "a missing part was got");
        }
        world_.get_many<C>(entities, check);
        expect(next == entities.size(), "many are handed out");
        if constexpr (storage_of<C> != Storage::shared) {
            if (operation.c % 4 != 0) return;
            world_.get_many_mut<C>(entities, [&](std::size_t i, C& value) {
                const std::uint32_t n = operation.c + static_cast<std::uint32_t>(i) * 512;
                value = make_part<C>(n);
                overwrite(model_.at(entities[i]), part, value_of<C>(n));
            });
        }
    }
}

void Twins::get_many(const Operation& operation) {
    const std::vector<Entity>& alive = model_.alive();
    const std::size_t part = operation.b % k_part_count;
    std::vector<Entity> entities;
    std::size_t place = operation.a;
    const bool careless = operation.c % 32 == 0;  // takes one that lacks the part
    for (std::size_t tries = alive.empty() ? 0 : operation.c / 64 % 300; tries > 0; --tries) {
        place = place * 7919 + 104729;
        const Entity entity = alive[place % alive.size()];
        if (careless || model_.at(entity).has(part)) entities.push_back(entity);
    }
    say("get many: " + std::to_string(entities.size()) + " of part " + std::to_string(part));
    with_part(part, [&]<class C>() { get_many_of<C>(entities, operation); });
}

void Twins::compact(const Operation&) {
    say("compact");
    const std::uint64_t order = order_of_rows();
    const std::size_t held = world_.memory_bytes();
    world_.compact();
    // Blocks that rows move to may need a slab before those that they leave are free.
    expect(world_.memory_bytes() <= held + BlockPool::k_slab_bytes, "a world is larger when compact");
    expect(order_of_rows() == order, "compact() changes the order of rows");
    queries_->check(0, world_, model_);
}

}  // namespace rambla::ecs::property
