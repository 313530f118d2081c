#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "ecs/query.h"
#include "property/ecs/queries.h"
#include "property/ecs/replica.h"
#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

bool later(std::uint32_t version, std::uint32_t than) {
    return static_cast<std::int32_t>(version - than) > 0;
}

/// What was written is in a chunk that says so.
template <class C>
void check_written(const World& world, Model& model) {
    Query<Entity, const C> query;
    for (const auto& chunk : query.chunks(world)) {
        const std::uint32_t version = chunk.template version<C>();
        expect(!later(version, world.version()), "a chunk was written in the future");
        for (const Entity handle : chunk.template get<0>()) {
            const ModelEntity& entity = model.at(handle);
            expect(!later(entity.written[part_number<C>()], version) && !later(entity.moved, version),
                   "a write does not show in its chunk's version");
        }
    }
}

/// Changed hands out all that changed; of a sparse component, nothing else.
template <class C>
void check_changed_since(const World& world, Model& model, std::uint32_t seen) {
    Query<Entity, Changed<C>> query;
    const std::uint32_t walk = ++walks;
    std::size_t rows = 0;
    query.each(world, Since{seen}, [&](Entity handle) {
        ModelEntity& entity = model.at(handle);
        expect(entity.has(part_number<C>()), "a part changed that is not there");
        entity.visited = walk;
        ++rows;
        if constexpr (storage_of<C> == Storage::sparse)
            expect(later(entity.written[part_number<C>()], seen), "a sparse part changed without a write");
    });
    expect(query.count(world, Since{seen}) == rows, "a query counts changes wrongly");
    for (const auto& [key, entity] : model.entities()) {
        const bool changed = later(entity.written[part_number<C>()], seen) ||
                             (storage_of<C> == Storage::column && later(entity.moved, seen));
        expect(!changed || !entity.has(part_number<C>()) || entity.visited == walk, "a change is overlooked");
    }
}

/// Rows that do not count as changed are those of entities that were not.
void check_changed_rows(const World& world, Model& model, std::uint32_t seen) {
    Query<Entity, const Score> query;
    for (const auto& chunk : query.chunks(world)) {
        const std::uint64_t changed = chunk.changed_rows<Score>(seen);
        const std::span<const Entity> entities = chunk.get<0>();
        for (std::size_t row = 0; row < entities.size(); ++row) {
            const ModelEntity& entity = model.at(entities[row]);
            const bool told = (changed >> row / ChunkChanges::k_rows_per_bit & 1u) != 0;
            expect(told || !(later(entity.written[part_number<Score>()], seen) || later(entity.moved, seen)),
                   "a changed row is overlooked");
        }
    }
}

}  // namespace

void Twins::check_query(const Operation& operation) {
    queries_->check(operation.a, world_, model_);
}

void Twins::write_through_query(const Operation& operation) {
    say("write all Health and Position of what is not frozen");
    Query<Entity, Health, Optional<Position>, Without<Frozen>> query;
    std::uint32_t n = operation.a;
    query.each(world_, [&](Entity entity, Health& health, Position* position) {
        ModelEntity& state = model_.at(entity);
        health = make_part<Health>(++n);
        overwrite(state, part_number<Health>(), value_of<Health>(n));
        if (position == nullptr) return;
        *position = make_part<Position>(n);
        overwrite(state, part_number<Position>(), value_of<Position>(n));
    });
}

/// After one write to one entity, exactly its chunk shows a change, and in that part only.
template <class C>
void Twins::check_single_write(Entity writing, std::uint32_t n) {
    const std::uint32_t seen = world_.advance_version();
    if (C* part = world_.try_get_mut<C>(writing)) {
        *part = make_part<C>(n);
        overwrite(model_.at(writing), part_number<C>(), value_of<C>(n));
    }
    Query<Entity, Optional<const Health>, Optional<const Position>, Optional<const Anchored>,
          Optional<const Score>>
        query;
    for (const auto& chunk : query.chunks(static_cast<const World&>(world_))) {
        const auto changed = [&]<class D>() {
            bool holds_it = false;
            for (const Entity handle : chunk.template get<0>())
                holds_it = holds_it || handle == writing;
            const bool written = std::is_same_v<C, D> && holds_it && model_.at(writing).has(part_number<D>());
            expect(chunk.template changed_since<D>(seen) == written, "a version changes without a write");
        };
        changed.template operator()<Health>();
        changed.template operator()<Position>();
        changed.template operator()<Anchored>();
        changed.template operator()<Score>();
        if constexpr (std::is_same_v<C, Score>) {
            if (!chunk.template changed_since<Score>(seen)) continue;
            const auto row = static_cast<std::uint32_t>(std::ranges::find(chunk.template get<0>(), writing) -
                                                        chunk.template get<0>().begin());
            expect(chunk.template changed_rows<Score>(seen) == std::uint64_t{1}
                                                                   << row / ChunkChanges::k_rows_per_bit,
                   "other rows count as written than the one");
        }
    }
}

void Twins::check_versions(const Operation& operation) {
    say("check versions");
    check_written<Health>(world_, model_);
    check_written<Position>(world_, model_);
    check_written<Anchored>(world_, model_);
    check_written<Owner>(world_, model_);
    check_written<Score>(world_, model_);
    check_written<Ticket>(world_, model_);
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    check_single_write<Health>(*entity, operation.c);
    check_single_write<Position>(*entity, operation.c);
    check_single_write<Anchored>(*entity, operation.c);
    check_single_write<Score>(*entity, operation.c);
}

void Twins::check_replica(const Operation& operation) {
    const bool by_delta = operation.a % 4 != 0;
    say(by_delta ? "follow by delta" : "follow by snapshot");
    if (operation.b % 4 == 0) replica_->compact();
    replica_->follow(world_, model_, by_delta);
    if (operation.c % 4 == 0) replica_->compare_bytes(world_);
}

void Twins::check_changed(const Operation& operation) {
    const std::uint32_t seen = world_.version() - operation.a % 40;
    check_changed_since<Health>(world_, model_, seen);
    check_changed_since<Line>(world_, model_, seen);
    check_changed_since<Score>(world_, model_, seen);
    check_changed_rows(world_, model_, seen);
    check_changed_since<Burning>(world_, model_, seen);
    check_changed_since<SparseAnchored>(world_, model_, seen);
}

void Twins::check_versions_of_rows(const Operation& operation) {
    Query<Entity, const Health> query;
    std::unordered_map<const Entity*, std::vector<Entity>> before;
    for (const auto& chunk : query.chunks(world_)) {
        const auto entities = chunk.get<0>();
        before[entities.data()].assign(entities.begin(), entities.end());
    }
    const std::uint32_t seen = world_.advance_version();
    switch (operation.c % 3) {
        case 0:
            create(operation);
            break;
        case 1:
            destroy(operation);
            break;
        default:
            remove(operation);
    }
    for (const auto& chunk : query.chunks(world_)) {
        const auto entities = chunk.get<0>();
        const auto known = before.find(entities.data());
        const bool other_rows = known != before.end() && !std::ranges::equal(known->second, entities);
        expect(!other_rows || chunk.changed_since<Health>(seen), "rows come or go without a new version");
    }
}

void Twins::change_while_iterating(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    Query<Entity> query;
    for (const auto& chunk : query.chunks(world_)) {
        expect(chunk.size() != 0, "a chunk without rows");
        expect_misuse([&] { world_.create(Health{1}); }, "create while iterating");
        expect_misuse([&] { world_.destroy(*entity); }, "destroy while iterating");
        expect_misuse([&] { world_.add(*entity, Byte{1}); }, "add while iterating");
        expect_misuse([&] { queue_.apply(world_); }, "apply while iterating");
        break;
    }
}

}  // namespace rambla::ecs::property
