#include "property/ecs/twins.h"

#include <algorithm>
#include <string>

#include "property/ecs/queries.h"
#include "property/ecs/replica.h"

namespace rambla::ecs::property {

/// What an operation may be, by its number, and how often it is that, relative to the others: rare ones cost
/// as much as thousands of others.
struct Twins::Kind {
    std::string_view name;
    void (Twins::*perform)(const Operation&);
    std::uint32_t weight;
};

std::span<const Twins::Kind> Twins::kinds() {
    static constexpr Kind k_kinds[]{
        {"create", &Twins::create, 1500},
        {"create wave", &Twins::create_wave, 2},
        {"destroy", &Twins::destroy, 1000},
        {"destroy kind", &Twins::destroy_kind, 1},
        {"add", &Twins::add, 1200},
        {"remove", &Twins::remove, 900},
        {"write", &Twins::write, 900},
        {"toggle", &Twins::toggle, 500},
        {"check one", &Twins::check_one, 1500},
        {"check dead", &Twins::check_dead, 300},
        {"record", &Twins::record, 2500},
        {"record whole", &Twins::record_whole, 40},
        {"apply", &Twins::apply, 40},
        {"apply alike", &Twins::apply_alike, 12},
        {"observe more", &Twins::observe_more, 4},
        {"create many", &Twins::create_many, 10},
        {"get many", &Twins::get_many, 60},
        {"compact", &Twins::compact, 12},
        {"hang", &Twins::hang, 300},
        {"hang chain", &Twins::hang_chain, 2},
        {"destroy tree", &Twins::destroy_tree, 40},
        {"end orphans", &Twins::end_orphans, 20},
        {"check children", &Twins::check_children, 10},
        {"check query", &Twins::check_query, 6},
        {"write through query", &Twins::write_through_query, 4},
        {"check versions", &Twins::check_versions, 6},
        {"check changed", &Twins::check_changed, 10},
        {"check versions of rows", &Twins::check_versions_of_rows, 20},
        {"check replica", &Twins::check_replica, 3},
        {"change while iterating", &Twins::change_while_iterating, 6},
    };
    return k_kinds;
}

Twins::Twins(const WorldOptions& options, std::optional<Mirror::Watches> observed, bool follows)
    : world_{options},
      mirror_{observed ? std::make_unique<Mirror>(world_, *observed) : nullptr},
      follows_{follows},
      recordings_(k_recordings),
      queries_{std::make_unique<Queries>()},
      replica_{std::make_unique<Replica>()} {
    if (follows) hierarchy_.follow_ends();
}

Twins::~Twins() = default;

std::span<const std::uint32_t> Twins::weights() {
    static const std::vector<std::uint32_t> weights = [] {
        std::vector<std::uint32_t> result;
        for (const Kind& kind : kinds())
            result.push_back(kind.weight);
        return result;
    }();
    return weights;
}

std::string_view Twins::name_of(const Operation& operation) {
    return kinds()[operation.kind].name;
}

void Twins::play(const Operation& operation) {
    begun_ = world_.version();
    (this->*kinds()[operation.kind].perform)(operation);
    if (mirror_ != nullptr) check_mirror();
}

/// The model repeats what observers have recorded, then both must be the same.
void Twins::check_mirror() {
    stamp_ = begun_;
    for (const Mirror::Echo& echo : mirror_->settle(world_)) {
        ModelEntity* state = model_.find(echo.entity);
        if (state == nullptr) continue;
        if (echo.byte) {
            set(*state, part_number<Byte>(), value_of<Byte>(*echo.byte));
        } else {
            unset(*state, part_number<Frozen>());
        }
        settle(*state);
    }
    stamp_.reset();
    mirror_->compare(model_.sums());
}

void Twins::observe_more(const Operation&) {
    if (mirror_ == nullptr) return;
    say("begin or end to observe Byte and Hidden");
    mirror_->toggle<Byte>(model_);
    mirror_->toggle<Hidden>(model_);
}

void Twins::check_all() {
    apply_all();
    if (mirror_ != nullptr) check_mirror();
    expect(world_.entity_count() == model_.alive().size(), "the number of entities");
    queries_->check_all(world_, model_);
    check_hierarchy();
    for (const Entity entity : model_.dead())
        expect(!world_.alive(entity), "an entity lives after its end");
}

std::uint64_t Twins::digest() const {
    return order_of_rows() ^ (mirror_ != nullptr ? mirror_->digest() : 0);
}

std::uint64_t Twins::order_of_rows() const {
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
    entity.written.fill(version_now());
    return entity;
}

void Twins::set(ModelEntity& entity, std::size_t part, std::uint64_t value) {
    model_.give(entity, part, value);
    entity.written[part] = version_now();
}

void Twins::overwrite(ModelEntity& entity, std::size_t part, std::uint64_t value) {
    set(entity, part, value);
    if (mirror_ != nullptr) mirror_->overwrite(part, entity.handle, value);
}

void Twins::settle(ModelEntity& entity) const {
    std::uint64_t home = 1;
    for (std::size_t part = 0; part < k_part_count; ++part) {
        if (entity.has(part) && k_storage[part] != Storage::sparse) home |= std::uint64_t{2} << part;
    }
    home |= entity.parts[part_number<Material>()].value_or(0) << 32u;
    home |= entity.parts[part_number<Tint>()].value_or(0) << 40u;
    if (home != entity.home) entity.moved = version_now();
    entity.home = home;
}

void Twins::unset(ModelEntity& entity, std::size_t part) {
    model_.take(entity, part);
    entity.disabled[part] = false;
}

}  // namespace rambla::ecs::property
