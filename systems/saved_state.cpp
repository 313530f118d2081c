#include "systems/saved_state.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "ecs/query.h"
#include "ecs/snapshot.h"
#include "systems/frame.h"
#include "systems/look/texture_uses.h"
#include "systems/reflection.h"
#include "systems/simulate/clip_library.h"
#include "systems/simulate/deformation.h"
#include "systems/simulate/paths.h"

namespace rambla::systems {
namespace {

std::string to_text(const SavedPlace& place) {
    const auto& [cell, local_m] = place.origin;
    return fmt::format("{}, seed {}, at {}, in cell ({} {} {}) at ({} {} {}) m", place.scene, place.seed,
                       place.time, cell.x, cell.y, cell.z, local_m.x, local_m.y, local_m.z);
}

bool same(const SavedPlace& a, const SavedPlace& b) {
    return a.scene == b.scene && a.seed == b.seed && a.origin.cell == b.origin.cell &&
           a.origin.local_m == b.origin.local_m && a.time == b.time;
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

/// Throws unless `index` is one of `count`.
void check_index(const char* what, std::uint32_t index, std::uint32_t count) {
    if (index < count) return;
    throw ecs::SnapshotError{0, fmt::format("{} {}", what, index), fmt::format("one of {}", count)};
}

/// Haze comes from sources, of which each particle takes memory, and from nothing else.
void check_sources(const ecs::World& world) {
    ecs::Query<const ParticleSource>{}.each(world, [](const ParticleSource& source) {
        if (source.count > assets::k_max_particles)
            throw ecs::SnapshotError{0, fmt::format("a source of {} particles", source.count),
                                     fmt::format("at most {}", assets::k_max_particles)};
    });
    ecs::Query<const Renderable, ecs::With<ParticleSource>>{}.each(world, [](const Renderable& drawn) {
        const Pipeline haze{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend),
                            .unlit = unpack_pipeline(drawn.pipeline).unlit,
                            .haze = true};
        if (drawn.pipeline != pack(haze) || drawn.mesh != assets::k_none)
            throw ecs::SnapshotError{0, "a source that is not drawn as haze", "one that is drawn so"};
    });
    ecs::Query<const Renderable, ecs::Without<ParticleSource>>{}.each(world, [](const Renderable& drawn) {
        const Pipeline pipeline = unpack_pipeline(drawn.pipeline);
        if (pipeline.haze || drawn.mesh == assets::k_none)
            throw ecs::SnapshotError{0, "haze, or no mesh, without a source", "a mesh"};
        // What fades is decided anew in each frame.
        if (pipeline.fading) throw ecs::SnapshotError{0, "a mesh that fades", "one that is drawn whole"};
    });
}

/// What deforms uses skeletons, joints and meshes as indices. Clips and nodes that there are not just rest.
void check_deformed(const ecs::World& world) {
    const ClipLibrary& library = world.resource<ClipLibrary>();
    ecs::Query<const Skin>{}.each(world, [&](const Skin& skin) {
        check_index("a skin of skeleton", skin.skeleton, library.skeleton_count());
    });
    ecs::Query<const Renderable, ecs::With<Morphed>>{}.each(world, [&](const Renderable& drawn) {
        check_index("a morphed mesh", drawn.mesh, library.mesh_count());
    });
    ecs::Query<const Renderable, const Skinned>{}.each(
        world, [&](const Renderable& drawn, const Skinned& skinned) {
            check_index("a skinned mesh", drawn.mesh, library.mesh_count());
            const Skin* const skin = world.alive(skinned.skin) ? world.try_get<Skin>(skinned.skin) : nullptr;
            const std::vector<JointBox>& used = library.mesh(drawn.mesh).joint_boxes;
            if (skin == nullptr || used.empty()) return;
            const std::size_t joints = library.joint_from_mesh(skin->skeleton).size();
            check_index("a mesh of joint", used.back().joint, static_cast<std::uint32_t>(joints));
        });
    ecs::Query<const SkinJoint>{}.each(world, [&](const SkinJoint& joint) {
        if (world.alive(joint.node) && !world.has<WorldTransform>(joint.node))
            throw ecs::SnapshotError{0, "a joint that is nowhere", "one with a world_transform"};
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
    world.set_resource(ClipLibrary{});
    take_over<Paths>(world, spawned);
    take_over<Sunlight>(world, spawned);
    take_over<MaterialFacts>(world, spawned);
    take_over<TextureUses>(world, spawned);
    take_over<ClipLibrary>(world, spawned);
    check_followers(world);
    check_deformed(world);
    check_sources(world);
    settle_deformations(world);
    return std::move(restored.world);
}

}  // namespace rambla::systems
