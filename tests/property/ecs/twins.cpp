#include "property/ecs/twins.h"

#include <algorithm>
#include <array>
#include <string>

#include "property/ecs/queries.h"
#include "property/ecs/replica.h"

namespace rambla::ecs::property {
namespace {

/// Operations by kind number.
enum Kind : std::uint32_t {
    create,
    create_wave,
    destroy,
    destroy_kind,
    add,
    remove,
    write,
    toggle,
    check_one,
    check_dead,
    record,
    apply,
    check_query,
    write_through_query,
    check_versions,
    check_changed,
    check_versions_of_rows,
    check_replica,
    change_while_iterating,
    kind_count
};

/// Rare ones cost as much as thousands of others.
constexpr auto k_weights = [] {
    std::array<std::uint32_t, kind_count> weights{};
    weights[create] = 1500;
    weights[create_wave] = 2;
    weights[destroy] = 1000;
    weights[destroy_kind] = 1;
    weights[add] = 1200;
    weights[remove] = 900;
    weights[write] = 900;
    weights[toggle] = 500;
    weights[check_one] = 1500;
    weights[check_dead] = 300;
    weights[record] = 2500;
    weights[apply] = 40;
    weights[check_query] = 6;
    weights[write_through_query] = 4;
    weights[check_versions] = 6;
    weights[check_changed] = 10;
    weights[check_versions_of_rows] = 20;
    weights[check_replica] = 3;
    weights[change_while_iterating] = 6;
    return weights;
}();

/// By part: adding and removing it moves no row.
constexpr auto k_sparse = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{storage_of<std::tuple_element_t<I, Parts>> == Storage::sparse...};
}
(std::make_index_sequence<k_part_count>{});

}  // namespace

Twins::Twins(const WorldOptions& options, bool shares)
    : shares_{shares},
      world_{options},
      recordings_(k_recordings),
      queries_{std::make_unique<Queries>()},
      replica_{std::make_unique<Replica>()} {}

Twins::~Twins() = default;

std::span<const std::uint32_t> Twins::weights() {
    return k_weights;
}

void Twins::play(const Operation& operation) {
    switch (operation.kind) {
        case Kind::create:
            return create(operation);
        case Kind::create_wave:
            return create_wave(operation);
        case Kind::destroy:
            return destroy(operation);
        case Kind::destroy_kind:
            return destroy_kind(operation);
        case Kind::add:
            return add(operation);
        case Kind::remove:
            return remove(operation);
        case Kind::write:
            return write(operation);
        case Kind::toggle:
            return toggle(operation);
        case Kind::check_one:
            return check_one(operation);
        case Kind::check_dead:
            return check_dead(operation);
        case Kind::record:
            return record(operation);
        case Kind::apply:
            return apply(operation);
        case Kind::check_query:
            return check_query(operation);
        case Kind::write_through_query:
            return write_through_query(operation);
        case Kind::check_versions:
            return check_versions(operation);
        case Kind::check_changed:
            return check_changed(operation);
        case Kind::check_versions_of_rows:
            return check_versions_of_rows(operation);
        case Kind::check_replica:
            return check_replica(operation);
        default:
            return change_while_iterating(operation);
    }
}

void Twins::check_all() {
    apply_all();
    expect(world_.entity_count() == model_.alive().size(), "the number of entities");
    queries_->check_all(world_, model_);
    for (const Entity entity : model_.dead())
        expect(!world_.alive(entity), "an entity lives after its end");
}

std::uint64_t Twins::digest() {
    std::uint64_t hash = 0xcbf29ce484222325u;
    Query<Entity> all;
    all.each(world_, [&](Entity entity) { hash = (hash ^ key_of(entity)) * 0x100000001b3u; });
    return hash;
}

void Twins::say(const std::string& text) {
    if (trace_ != nullptr) *trace_ += text + "\n";
}

std::optional<Entity> Twins::target(const Operation& operation) const {
    const std::vector<Entity>& alive = model_.alive();
    if (alive.empty()) return {};
    // Three of four operations meet the same few entities, so that those go through everything; the others
    // leave large archetypes large.
    const std::size_t few = std::min<std::size_t>(alive.size(), 200);
    return alive[operation.a % (operation.b % 4 != 0 ? few : alive.size())];
}

ModelEntity Twins::newborn() const {
    ModelEntity entity;
    entity.written.fill(world_.version());
    return entity;
}

void Twins::set(ModelEntity& entity, std::size_t part, std::uint64_t value) const {
    entity.parts[part] = value;
    entity.written[part] = world_.version();
}

void Twins::settle(ModelEntity& entity) const {
    std::uint64_t home = 1;
    for (std::size_t part = 0; part < k_part_count; ++part) {
        if (entity.has(part) && !k_sparse[part]) home |= std::uint64_t{2} << part;
    }
    home |= entity.parts[part_number<Material>()].value_or(0) << 32u;
    if (home != entity.home) entity.moved = world_.version();
    entity.home = home;
}

void Twins::unset(ModelEntity& entity, std::size_t part) const {
    entity.parts[part].reset();
    entity.disabled[part] = false;
}

}  // namespace rambla::ecs::property
