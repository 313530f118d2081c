#include "systems/reflection.h"

#include "ecs/reflect_parent.h"
#include "systems/saved_state.h"

namespace rambla::ecs {

using namespace rambla::systems;

template <>
struct reflection<assets::ActorKind> {
    static constexpr auto value = enumeration<assets::ActorKind>(
        {{"walker", assets::ActorKind::walker}, {"car", assets::ActorKind::car}});
};
template <>
struct reflection<LimbRole> {
    static constexpr auto value = enumeration<LimbRole>({{"leg", LimbRole::leg},
                                                         {"shin", LimbRole::shin},
                                                         {"arm", LimbRole::arm},
                                                         {"forearm", LimbRole::forearm},
                                                         {"torso", LimbRole::torso},
                                                         {"head", LimbRole::head}});
};
template <>
struct reflection<WorldPosition> {
    static constexpr auto value = describe<WorldPosition>("world_position")
                                      .field("cell", &WorldPosition::cell, {.unit = "cells"})
                                      .field("local_m", &WorldPosition::local_m, {.unit = "m"});
};
template <>
struct reflection<Cell> {
    static constexpr auto value = describe<Cell>("cell").field("value", &Cell::value, {.unit = "cells"});
};
template <>
struct reflection<LocalTransform> {
    static constexpr auto value = describe<LocalTransform>("local_transform")
                                      .field("translation_m", &LocalTransform::translation_m, {.unit = "m"})
                                      .field("rotation", &LocalTransform::rotation, {.min = -1.0, .max = 1.0})
                                      .field("scale", &LocalTransform::scale);
};
template <>
struct reflection<WorldTransform> {
    static constexpr auto value = describe<WorldTransform>("world_transform")
                                      .field("cell", &WorldTransform::cell, {.unit = "cells"})
                                      .field("linear", &WorldTransform::linear)
                                      .field("translation_m", &WorldTransform::translation_m, {.unit = "m"});
};
template <>
struct reflection<PreviousWorldTransform> {
    static constexpr auto value = describe<PreviousWorldTransform>("previous_world_transform")
                                      .field("value", &PreviousWorldTransform::value);
};
template <>
struct reflection<Renderable> {
    static constexpr auto value = describe<Renderable>("renderable")
                                      .field("mesh", &Renderable::mesh)
                                      .field("material", &Renderable::material)
                                      .field("pipeline", &Renderable::pipeline);
};
template <>
struct reflection<LocalBounds> {
    static constexpr auto value =
        describe<LocalBounds>("local_bounds")
            .field("centre_m", &LocalBounds::centre_m, {.unit = "m"})
            .field("half_extents_m", &LocalBounds::half_extents_m, {.unit = "m", .min = 0.0});
};
template <>
struct reflection<NoShadow> {
    static constexpr auto value = describe<NoShadow>("no_shadow");
};
template <>
struct reflection<Opacity> {
    static constexpr auto value =
        describe<Opacity>("opacity").field("value", &Opacity::value, {.min = 0.0, .max = 1.0});
};
template <>
struct reflection<NearFade> {
    static constexpr auto value = describe<NearFade>("near_fade")
                                      .field("gone_m", &NearFade::gone_m, {.unit = "m", .min = 0.0})
                                      .field("whole_m", &NearFade::whole_m, {.unit = "m", .min = 0.0});
};
template <>
struct reflection<ParticleSource> {
    static constexpr auto value =
        describe<ParticleSource>("particle_source")
            .field("count", &ParticleSource::count, {.min = 1.0, .max = assets::k_max_particles})
            .field("lifetime_s", &ParticleSource::lifetime_s, {.unit = "s", .min = 0.0})
            .field("spread_m", &ParticleSource::spread_m, {.unit = "m", .min = 0.0})
            .field("velocity_m_s", &ParticleSource::velocity_m_s, {.unit = "m/s"})
            .field("velocity_spread_m_s", &ParticleSource::velocity_spread_m_s, {.unit = "m/s", .min = 0.0})
            .field("acceleration_m_s2", &ParticleSource::acceleration_m_s2, {.unit = "m/s2"})
            .field("start_radius_m", &ParticleSource::start_radius_m, {.unit = "m", .min = 0.0})
            .field("end_radius_m", &ParticleSource::end_radius_m, {.unit = "m", .min = 0.0})
            .field("seed", &ParticleSource::seed);
};
template <>
struct reflection<LocalLight> {
    static constexpr auto value =
        describe<LocalLight>("local_light")
            .field("intensity", &LocalLight::intensity, {.unit = "illuminance m2", .min = 0.0})
            .field("radius_m", &LocalLight::radius_m, {.unit = "m", .min = 0.0})
            .field("cos_inner", &LocalLight::cos_inner, {.min = -2.0, .max = 1.0})
            .field("cos_outer", &LocalLight::cos_outer, {.min = -2.0, .max = 1.0});
};
template <>
struct reflection<DirectionalLight> {
    static constexpr auto value =
        describe<DirectionalLight>("directional_light")
            .field("illuminance", &DirectionalLight::illuminance, {.unit = "illuminance", .min = 0.0});
};
template <>
struct reflection<PathLeg> {
    static constexpr auto value = describe<PathLeg>("path_leg")
                                      .field("link", &PathLeg::link)
                                      .field("backwards", &PathLeg::backwards)
                                      .field("aside_m", &PathLeg::aside_m, {.unit = "m"});
};
template <>
struct reflection<PathFollower> {
    static constexpr auto value =
        describe<PathFollower>("path_follower")
            .field("kind", &PathFollower::kind)
            .field("turning", &PathFollower::turning)
            .field("leg", &PathFollower::leg)
            .field("next", &PathFollower::next)
            .field("progress", &PathFollower::progress, {.min = 0.0})
            .field("speed_m_s", &PathFollower::speed_m_s, {.unit = "m/s", .min = 0.0})
            .field("turns", &PathFollower::turns)
            .field("heading", &PathFollower::heading, {.min = -1.0, .max = 1.0})
            .field("travelled_m", &PathFollower::travelled_m, {.unit = "m", .min = 0.0});
};
template <>
struct reflection<Mover> {
    static constexpr auto value = describe<Mover>("mover")
                                      .field("heading_rad", &Mover::heading_rad, {.unit = "rad"})
                                      .field("speed_m_s", &Mover::speed_m_s, {.unit = "m/s", .min = 0.0})
                                      .field("reach_m", &Mover::reach_m, {.unit = "m", .min = 0.0});
};
template <>
struct reflection<Gait> {
    static constexpr auto value = describe<Gait>("gait")
                                      .field("leg_length_m", &Gait::leg_length_m, {.unit = "m", .min = 0.0})
                                      .field("phase", &Gait::phase, {.min = 0.0, .max = 1.0})
                                      .field("reach", &Gait::reach, {.min = 0.0, .max = 1.0});
};
template <>
struct reflection<GaitLimb> {
    static constexpr auto value = describe<GaitLimb>("gait_limb")
                                      .field("actor", &GaitLimb::actor)
                                      .field("role", &GaitLimb::role)
                                      .field("right", &GaitLimb::right)
                                      .field("rest", &GaitLimb::rest, {.min = -1.0, .max = 1.0});
};
template <>
struct reflection<WheelSpin> {
    static constexpr auto value = describe<WheelSpin>("wheel_spin")
                                      .field("actor", &WheelSpin::actor)
                                      .field("radius_m", &WheelSpin::radius_m, {.unit = "m", .min = 0.0})
                                      .field("rest", &WheelSpin::rest, {.min = -1.0, .max = 1.0});
};
template <>
struct reflection<ClipCursor> {
    static constexpr auto value = describe<ClipCursor>("clip_cursor")
                                      .field("clip", &ClipCursor::clip)
                                      .field("time_s", &ClipCursor::time_s, {.unit = "s", .min = 0.0})
                                      .field("speed", &ClipCursor::speed)
                                      .field("looping", &ClipCursor::looping);
};
template <>
struct reflection<AnimationPlayer> {
    static constexpr auto value =
        describe<AnimationPlayer>("animation_player")
            .field("playing", &AnimationPlayer::playing)
            .field("fading", &AnimationPlayer::fading)
            .field("fade_s", &AnimationPlayer::fade_s, {.unit = "s", .min = 0.0})
            .field("fade_left_s", &AnimationPlayer::fade_left_s, {.unit = "s", .min = 0.0});
};
template <>
struct reflection<AnimatedNode> {
    static constexpr auto value = describe<AnimatedNode>("animated_node")
                                      .field("player", &AnimatedNode::player)
                                      .field("node", &AnimatedNode::node)
                                      .field("rest", &AnimatedNode::rest);
};
template <>
struct reflection<Morph> {
    static constexpr auto value = describe<Morph>("morph").field("count", &Morph::count);
};
template <>
struct reflection<MorphWeight> {
    static constexpr auto value = describe<MorphWeight>("morph_weight")
                                      .field("morph", &MorphWeight::morph)
                                      .field("player", &MorphWeight::player)
                                      .field("node", &MorphWeight::node)
                                      .field("target", &MorphWeight::target)
                                      .field("rest", &MorphWeight::rest)
                                      .field("value", &MorphWeight::value)
                                      .field("previous", &MorphWeight::previous);
};
template <>
struct reflection<Skin> {
    static constexpr auto value =
        describe<Skin>("skin").field("skeleton", &Skin::skeleton).field("root", &Skin::root);
};
template <>
struct reflection<SkinJoint> {
    static constexpr auto value = describe<SkinJoint>("skin_joint")
                                      .field("skin", &SkinJoint::skin)
                                      .field("node", &SkinJoint::node)
                                      .field("joint", &SkinJoint::joint);
};
template <>
struct reflection<Skinned> {
    static constexpr auto value = describe<Skinned>("skinned").field("skin", &Skinned::skin);
};
template <>
struct reflection<Morphed> {
    static constexpr auto value = describe<Morphed>("morphed").field("morph", &Morphed::morph);
};
template <>
struct reflection<Clock> {
    static constexpr auto value = describe<Clock>("clock").field("steps", &Clock::steps, {.unit = "steps"});
};
template <>
struct reflection<SavedPlace> {
    static constexpr auto value = describe<SavedPlace>("saved_place")
                                      .field("scene", &SavedPlace::scene)
                                      .field("seed", &SavedPlace::seed)
                                      .field("origin", &SavedPlace::origin)
                                      .field("time", &SavedPlace::time);
};

}  // namespace rambla::ecs

namespace rambla::systems {

ecs::TypeRegistry component_registry() {
    ecs::TypeRegistry registry;
    registry.add<Cell>();
    registry.add<LocalTransform>();
    registry.add<Parent>();
    registry.add<WorldTransform>();
    registry.add<PreviousWorldTransform>();
    registry.add<Renderable>();
    registry.add<LocalBounds>();
    registry.add<NoShadow>();
    registry.add<Opacity>();
    registry.add<NearFade>();
    registry.add<ParticleSource>();
    registry.add<LocalLight>();
    registry.add<DirectionalLight>();
    registry.add<PathFollower>();
    registry.add<Mover>();
    registry.add<Gait>();
    registry.add<GaitLimb>();
    registry.add<WheelSpin>();
    registry.add<AnimationPlayer>();
    registry.add<AnimatedNode>();
    registry.add<Morph>();
    registry.add<MorphWeight>();
    registry.add<Skin>();
    registry.add<SkinJoint>();
    registry.add<Skinned>();
    registry.add<Morphed>();
    registry.add_resource<Clock>();
    registry.add_resource<SavedPlace>();
    return registry;
}

}  // namespace rambla::systems
