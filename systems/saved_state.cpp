#include "systems/saved_state.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "ecs/query.h"
#include "ecs/snapshot.h"
#include "systems/reflection.h"
#include "systems/simulate/paths.h"

namespace rambla::systems {
namespace {

std::string to_text(const SavedPlace& place) {
    const auto& [cell, local_m] = place.origin;
    return fmt::format("{}, seed {}, in cell ({} {} {}) at ({} {} {}) m", place.scene, place.seed, cell.x,
                       cell.y, cell.z, local_m.x, local_m.y, local_m.z);
}

bool same(const SavedPlace& a, const SavedPlace& b) {
    return a.scene == b.scene && a.seed == b.seed && a.origin.cell == b.origin.cell &&
           a.origin.local_m == b.origin.local_m;
}

template <class R>
void take_over(ecs::World& world, const ecs::World& spawned) {
    if (spawned.has_resource<R>()) world.set_resource(R{spawned.resource<R>()});
}

/// Followers use links as indices.
void check_followers(const ecs::World& world) {
    ecs::Query<const PathFollower> query;
    query.each(world, [&](const PathFollower& follower) {
        const Paths& paths = world.resource<Paths>();
        const PathGraph& graph = follower.kind == assets::ActorKind::car ? paths.lanes : paths.pavements;
        const std::uint32_t link = std::max(follower.leg.link, follower.next.link);
        if (link >= graph.links().size()) {
            throw ecs::SnapshotError{0, "an actor on link " + std::to_string(link),
                                     "one of " + std::to_string(graph.links().size())};
        }
    });
}

}  // namespace

std::vector<std::byte> save_state(ecs::World& world, const SavedPlace& place) {
    world.set_resource(SavedPlace{place});
    const ecs::TypeRegistry registry = component_registry();
    ecs::SnapshotWriter writer{registry};
    const std::span<const std::byte> bytes = writer.write(world);
    return {bytes.begin(), bytes.end()};
}

std::unique_ptr<ecs::World> load_state(std::span<const std::byte> bytes, const ecs::World& spawned,
                                       const SavedPlace& place) {
    ecs::RestoredWorld restored = ecs::read_snapshot(bytes, component_registry());
    ecs::World& world = *restored.world;
    const std::string found =
        world.has_resource<SavedPlace>() ? to_text(world.resource<SavedPlace>()) : "no place";
    if (!world.has_resource<SavedPlace>() || !same(world.resource<SavedPlace>(), place)) {
        throw ecs::SnapshotError{0, "a state of " + found, "one of " + to_text(place)};
    }
    world.set_resource(Paths{});
    take_over<Paths>(world, spawned);
    take_over<Sunlight>(world, spawned);
    take_over<MaterialFacts>(world, spawned);
    check_followers(world);
    return std::move(restored.world);
}

}  // namespace rambla::systems
