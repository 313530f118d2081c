#pragma once

#include <cstdint>

#include "ecs/res.h"
#include "ecs/view.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/simulate/clip_library.h"

namespace rambla::systems {

/// Plays `to` from now on, and fades what has been playing out over `fade_s`. A fade that is under way is cut
/// short. No length, or none that is finite, means at once.
void cross_fade(AnimationPlayer& player, const ClipCursor& to, float fade_s);

/// The player after a step of `step_s`: times stay within their clips (see time_in_clip).
[[nodiscard]] AnimationPlayer advanced(const ClipLibrary& library, const AnimationPlayer& player,
                                       double step_s);

/// Where a player has an animated node now. @param node  its hints are used and renewed
[[nodiscard]] LocalTransform posed(const ClipLibrary& library, const AnimationPlayer& player,
                                   AnimatedNode& node);

/// What a player makes of a morph weight now. @param weight  its hints are used and renewed
[[nodiscard]] float posed(const ClipLibrary& library, const AnimationPlayer& player, MorphWeight& weight);

/// System: advances all players by one step.
void advance_players(ecs::View<AnimationPlayer> players, ecs::Res<ClipLibrary> library);

/// System: moves animated nodes to where their players say.
void pose_nodes(ecs::View<AnimatedNode, LocalTransform> nodes, ecs::Lookup<const AnimationPlayer> players,
                ecs::Res<ClipLibrary> library);

/// System: gives morph weights the values that their players say, after keeping those of the step before.
void pose_weights(ecs::View<MorphWeight> weights, ecs::Lookup<const AnimationPlayer> players,
                  ecs::Res<ClipLibrary> library);

/// Brings all that players move to where they say now, as if it had been there before: after a player was set
/// to another clip or time by hand, and without a fade.
void settle_animation(ecs::World& world);

}  // namespace rambla::systems
