#include "systems/simulate/animation.h"

#include <algorithm>
#include <cmath>

#include "ecs/query.h"
#include "ecs/schedule.h"
#include "systems/pipeline.h"
#include "systems/simulate/deformation.h"
#include "systems/simulate/sampling.h"
#include "systems/simulate/transform.h"

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Channel;

ClipCursor advanced(const ClipLibrary& library, ClipCursor cursor, double step_s) {
    const double way_s = static_cast<double>(cursor.speed) * step_s;
    cursor.time_s = time_in_clip(cursor.time_s + way_s, library.duration_s(cursor.clip), cursor.looping);
    return cursor;
}

/// How much of what fades out is left, in [0, 1].
double fading_share(const AnimationPlayer& player) {
    if (!(player.fade_left_s > 0.0f) || !(player.fade_s > 0.0f)) return 0.0;
    return std::min(static_cast<double>(player.fade_left_s) / static_cast<double>(player.fade_s), 1.0);
}

/// @param hints  of translation, rotation and scale
LocalTransform pose(const ClipLibrary& library, const ClipCursor& cursor, const AnimatedNode& node,
                    std::uint32_t* hints) {
    LocalTransform made = node.rest;
    const auto channel = [&](AnimatedPath path) {
        return library.channel(cursor.clip, node.node, path);
    };
    if (const Channel* found = channel(AnimatedPath::translation))
        made.translation_m = sample_vector(*found, cursor.time_s, hints[0]);
    if (const Channel* found = channel(AnimatedPath::rotation))
        made.rotation = sample_rotation(*found, cursor.time_s, hints[1]);
    if (const Channel* found = channel(AnimatedPath::scale))
        made.scale = sample_vector(*found, cursor.time_s, hints[2]);
    return made;
}

float weight(const ClipLibrary& library, const ClipCursor& cursor, const MorphWeight& of,
             std::uint32_t& hint) {
    const Channel* const found = library.channel(cursor.clip, of.node, AnimatedPath::weights);
    if (found == nullptr || of.target >= found->width) return of.rest;
    return sample_component(*found, of.target, cursor.time_s, hint);
}

}  // namespace

void cross_fade(AnimationPlayer& player, const ClipCursor& to, float fade_s) {
    const float length_s = std::isfinite(fade_s) ? std::max(fade_s, 0.0f) : 0.0f;
    player.fading = player.playing;
    player.playing = to;
    player.fade_s = length_s;
    player.fade_left_s = length_s;
}

AnimationPlayer advanced(const ClipLibrary& library, const AnimationPlayer& player, double step_s) {
    AnimationPlayer made = player;
    made.playing = advanced(library, player.playing, step_s);
    if (!(player.fade_left_s > 0.0f)) return made;
    made.fading = advanced(library, player.fading, step_s);
    made.fade_left_s = std::max(player.fade_left_s - static_cast<float>(step_s), 0.0f);
    return made;
}

LocalTransform posed(const ClipLibrary& library, const AnimationPlayer& player, AnimatedNode& node) {
    LocalTransform made = pose(library, player.playing, node, &node.hints[0]);
    const double share = fading_share(player);
    if (share == 0.0) return made;
    const LocalTransform from = pose(library, player.fading, node, &node.hints[3]);
    const auto old = static_cast<float>(share);
    made.translation_m = made.translation_m * (1.0f - old) + from.translation_m * old;
    made.rotation = mixed_rotation(made.rotation, from.rotation, share);
    made.scale = made.scale * (1.0f - old) + from.scale * old;
    return made;
}

float posed(const ClipLibrary& library, const AnimationPlayer& player, MorphWeight& of) {
    const float made = weight(library, player.playing, of, of.hints[0]);
    const double share = fading_share(player);
    if (share == 0.0) return made;
    const auto old = static_cast<float>(share);
    return made * (1.0f - old) + weight(library, player.fading, of, of.hints[1]) * old;
}

void advance_players(ecs::View<AnimationPlayer> players, ecs::Res<ClipLibrary> library) {
    players.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](AnimationPlayer& player) { player = advanced(*library, player, k_step_s); });
    });
}

void pose_nodes(ecs::View<AnimatedNode, LocalTransform> nodes, ecs::Lookup<const AnimationPlayer> players,
                ecs::Res<ClipLibrary> library) {
    nodes.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](AnimatedNode& node, LocalTransform& local) {
            if (!players.alive(node.player)) return;
            const AnimationPlayer* const player = players.try_get<AnimationPlayer>(node.player);
            if (player != nullptr) local = posed(*library, *player, node);
        });
    });
}

void pose_weights(ecs::View<MorphWeight> weights, ecs::Lookup<const AnimationPlayer> players,
                  ecs::Res<ClipLibrary> library) {
    weights.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](MorphWeight& of) {
            of.previous = of.value;
            if (!players.alive(of.player)) return;
            const AnimationPlayer* const player = players.try_get<AnimationPlayer>(of.player);
            if (player != nullptr) of.value = posed(*library, *player, of);
        });
    });
}

void settle_animation(ecs::World& world) {
    ecs::Schedule schedule{{.threads = 1}};
    schedule.add("nodes", pose_nodes);
    schedule.add("weights", pose_weights);
    schedule.run(world);
    ecs::Query<MorphWeight> weights;
    weights.each(world, [](MorphWeight& of) { of.previous = of.value; });
    settle(world);
    settle_deformations(world);
}

}  // namespace rambla::systems
