#include "property/ecs/mirror.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "ecs/commands.h"
#include "ecs/world_access.h"

namespace rambla::ecs::property {
namespace {

std::optional<EntityRecord> record_of(const World& world, Entity entity) {
    const EntityRecord* record = detail::WorldAccess::entities(world).find(entity);
    return record == nullptr ? std::optional<EntityRecord>{} : *record;
}

}  // namespace

/// Not in the order of their numbers, nor in that in which components come to be known.
Mirror::Mirror(World& world, Watches watches) : world_{&world} {
    observe<Score>();
    observe<Health>();
    if (watches == Watches::sparse_too) {
        observe<Burning>();
        observe<Selected>();
        observe<SparseAnchored>();
        world.observers().on_add<Burning>([this](Entity entity, const Burning&, Commands& later) {
            later.remove<Frozen>(entity);
            echoes_.push_back({entity, {}});
        });
    }
    observe<Frozen>();
    observe<Parent>();
    observe<Ticket>();
    observe<Material>();
    observe<Light>();
    observe<Position>();
    observe<Tint>();
    observe<Anchored>();
    world.observers().on_set<Score>([this](Entity entity, const Score& score, Commands& later) {
        const auto n = static_cast<std::uint32_t>(score.points);
        if (n % 4 != 0) return;
        later.add(entity, make_part<Byte>(n));
        echoes_.push_back({entity, n});
    });
}

template <class C>
void Mirror::observe() {
    constexpr std::size_t k_part = part_number<C>();
    observed_[k_part] = true;
    if (!rank_[k_part]) rank_[k_part] = ranks_++;
    Observers& observers = world_->observers();
    if constexpr (is_tag<C>) {
        observers_[k_part] = {
            observers.on_remove<C>([this](Entity entity) { told<C>(removed, entity, nullptr); }),
            observers.on_add<C>([this](Entity entity) { told<C>(added, entity, nullptr); })};
    } else {
        observers_[k_part] = {
            observers.on_set<C>([this](Entity entity, const C& value) { told(was_set, entity, &value); }),
            observers.on_add<C>([this](Entity entity, const C& value) { told(added, entity, &value); }),
            observers.on_remove<C>([this](Entity entity, const C& value) { told(removed, entity, &value); })};
    }
}

template <class C>
void Mirror::toggle(const Model& model) {
    constexpr std::size_t k_part = part_number<C>();
    if (observed_[k_part]) {
        for (const ObserverId id : observers_[k_part])
            world_->observers().end(id);
        for (const auto& [key, value] : values_[k_part])
            sums_.minus(k_part, entity_of(key), value);
        values_[k_part].clear();
        observed_[k_part] = false;
        return;
    }
    observe<C>();
    for (const auto& [key, entity] : model.entities()) {
        if (!entity.has(k_part)) continue;
        values_[k_part].emplace(key, *entity.parts[k_part]);
        sums_.plus(k_part, entity_of(key), *entity.parts[k_part]);
    }
}
template void Mirror::toggle<Byte>(const Model& model);
template void Mirror::toggle<Hidden>(const Model& model);

template <class C>
void Mirror::told(Moment moment, Entity entity, const C* value) {
    constexpr std::size_t k_part = part_number<C>();
    expect(world_->alive(entity) && world_->has<C>(entity), "an observer is told of what is not there");
    std::uint64_t now = 0;
    if constexpr (!is_tag<C>) {
        expect(world_->try_get<C>(entity) == value, "an observer gets a value of another place");
        const std::optional<std::uint64_t> read = read_part(*value);
        expect(read.has_value(), "an observer gets a damaged value");
        now = *read;
    }
    const auto known = values_[k_part].find(key_of(entity));
    expect((known != values_[k_part].end()) == (moment != added), "an observer is told of a wrong moment");
    if (moment != added) {
        sums_.minus(k_part, entity, known->second);
        if (moment == removed) expect(known->second == now, "an observer sees another value at the end");
        if (k_storage[k_part] == Storage::shared && moment == was_set)
            expect(known->second != now, "a shared value is replaced by itself");
        values_[k_part].erase(known);
    }
    if (moment != removed) {
        values_[k_part].emplace(key_of(entity), now);
        sums_.plus(k_part, entity, now);
    }
    calls_.push_back({moment, *rank_[k_part], k_part, entity});
    for (const std::uint64_t word : {std::uint64_t{moment}, std::uint64_t{k_part}, key_of(entity), now})
        digest_ = (digest_ ^ word) * 0x100000001b3u;
}

void Mirror::overwrite(std::size_t part, Entity entity, std::uint64_t value) {
    if (!observed_[part]) return;
    std::uint64_t& known = values_[part].at(key_of(entity));
    sums_.minus(part, entity, known);
    sums_.plus(part, entity, value);
    known = value;
}

void Mirror::compare(const PartSums& sums) const {
    for (std::size_t part = 0; part < k_part_count; ++part)
        expect(!observed_[part] || sums_[part] == sums[part], "a mirror kept by observers is not the world");
}

void Mirror::watch_order(const World& world, bool whole) {
    checks_order_ = whole;
    before_.clear();
    if (!whole) return;
    Query<Entity> all;
    all.each(world, [&](Entity entity) {
        const EntityRecord record = *record_of(world, entity);
        before_.emplace(key_of(entity), Place{record.archetype, record.row});
    });
}

std::vector<Mirror::Echo> Mirror::settle(const World& world) {
    if (checks_order_ && echoes_.empty()) check_order(world);
    checks_order_ = false;
    calls_.clear();
    return std::exchange(echoes_, {});
}

/// Those that were created come behind all others.
Mirror::Place Mirror::place_before(Entity entity) const {
    const auto found = before_.find(key_of(entity));
    return found == before_.end() ? Place{} : found->second;
}

void Mirror::check_order(const World& world) const {
    const auto destination = [&](const Call& call) {
        const std::optional<EntityRecord> record = record_of(world, call.entity);
        return record ? record->archetype : k_no_archetype;
    };
    const auto of_same_part = [](const Call& a, const Call& b) {
        return a.moment == b.moment && a.rank == b.rank;
    };
    std::vector<std::uint32_t> left;  // destinations of the archetype that is told of, but the last
    for (std::size_t i = 1; i < calls_.size(); ++i) {
        const Call& a = calls_[i - 1];
        const Call& b = calls_[i];
        expect(std::tie(a.moment, a.rank) <= std::tie(b.moment, b.rank),
               "observers of parts are called out of order");
        if (!of_same_part(a, b) || k_storage[a.part] == Storage::sparse) {
            left.clear();
            continue;
        }
        const Place from_a = place_before(a.entity);
        const Place from_b = place_before(b.entity);
        expect(from_a.archetype <= from_b.archetype, "observers are told of archetypes out of order");
        if (from_a.archetype != from_b.archetype) {
            left.clear();
        } else if (destination(a) == destination(b)) {
            expect(from_a.row <= from_b.row, "observers are told of rows out of order");
        } else {
            left.push_back(destination(a));
            expect(std::ranges::find(left, destination(b)) == left.end(), "a shared fate is told in parts");
        }
    }
}

}  // namespace rambla::ecs::property
