#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <tuple>
#include <vector>

#include "assets/environment.h"
#include "assets/place.h"
#include "assets/scene.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/parent.h"

namespace rambla::systems {

/// Edge of a cell of world space.
inline constexpr float k_cell_m = 256.0f;

/// A point anywhere: an integer cell and a place inside it, so that a millimetre stays one 1000 km from the
/// origin.
struct WorldPosition {
    glm::ivec3 cell{0};
    glm::vec3 local_m{0.0f};  ///< [0, k_cell_m) once normalised
};

/// Component of root entities: which cell their LocalTransform's translation counts from.
struct Cell {
    glm::ivec3 value{0};
};

/// Transform relative to the parent, or to the Cell's corner for roots.
struct LocalTransform {
    glm::vec3 translation_m{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
};

using ecs::Parent;

/// Where an entity is: affine map from its own space to the corner of `cell`. Written by the transform system
/// only.
struct WorldTransform {
    glm::ivec3 cell{0};
    glm::mat3 linear{1.0f};
    glm::vec3 translation_m{0.0f};
};

/// WorldTransform of the step before, for things that move: pictures lie between the two.
struct PreviousWorldTransform {
    WorldTransform value;
};

/// One mesh with one material; indices of the world's scene.
struct Renderable {
    std::uint32_t mesh = assets::k_none;
    std::uint32_t material = assets::k_none;
    std::uint32_t pipeline = 0;  ///< pack(Pipeline), but for `mirrored`, which follows the transform
};

/// Box of what is drawn, in the entity's own space.
struct LocalBounds {
    glm::vec3 centre_m{0.0f};
    glm::vec3 half_extents_m{0.0f};
};

/// Does not throw a shadow (glass, ground far below everything).
struct NoShadow {};

/// How much is left of an entity's Renderable; without this, all. What is not whole is blended over what lies
/// behind it, and throws its whole shadow.
struct Opacity {
    float value = 1.0f;  ///< [0, 1]; 0 is not drawn
};

/// Vanishes where the eye comes so near that it would look into it.
struct NearFade {
    float gone_m = 0.0f;   ///< from the eye to the box of what is drawn, and nearer: not drawn
    float whole_m = 0.0f;  ///< and farther: whole; ≥ gone_m
};

/// Its entity's Renderable, which has no mesh, is drawn as balls of haze that begin here, drift and dissolve:
/// see particle_at(). Members as in assets::Emitter.
struct ParticleSource {
    std::uint32_t count = 1;
    float lifetime_s = 0.0f;
    float spread_m = 0.0f;
    glm::vec3 velocity_m_s{0.0f};
    float velocity_spread_m_s = 0.0f;
    glm::vec3 acceleration_m_s2{0.0f};
    float start_radius_m = 1.0f;
    float end_radius_m = 1.0f;
    std::uint32_t seed = 0;  ///< of what each particle draws
};

/// A point or spot light at its entity, shining along −Z.
struct LocalLight {
    glm::vec3 intensity{1.0f};  ///< illuminance · m²
    float radius_m = 10.0f;
    float cos_inner = -1.0f;
    float cos_outer = -2.0f;  ///< −2: a point light
};

/// Parallel light that shines along −Z of its entity, everywhere and without shadows: fill light, or a second
/// sun. The sun that throws shadows is another thing, see Sunlight.
struct DirectionalLight {
    glm::vec3 illuminance{1.0f};  ///< π lights white to radiance 1
};

/// Resource: sun and sky of the world.
struct Sunlight {
    assets::Environment environment;
};

/// Resource: what the queues must know of the scene's materials.
struct MaterialFacts {
    std::vector<std::uint8_t> needs_emission;  ///< by material index: 1 if it emits, is light-mapped or unlit
};

/// Resource: simulation steps taken so far.
struct Clock {
    std::uint64_t steps = 0;
};

/// A link of a path network in one direction, on a line beside its middle.
struct PathLeg {
    std::uint32_t link = 0;
    bool backwards = false;  ///< from the link's end to its start
    float aside_m = 0.0f;    ///< to the right of the direction of travel
};

/// Follows links of the Paths resource at constant speed: straight along a leg, then a curve around its end
/// into the next leg.
struct PathFollower {
    assets::ActorKind kind = assets::ActorKind::walker;
    bool turning = false;  ///< on the curve from `leg` to `next`
    PathLeg leg;
    PathLeg next;
    float progress = 0.0f;  ///< straight: metres from the leg's start; turning: curve parameter in [0, 1)
    float speed_m_s = 1.3f;
    std::uint32_t turns = 0;         ///< ends of links passed; counts the random choices
    glm::vec2 heading{0.0f, -1.0f};  ///< unit vector (x, z) that the actor faces
    double travelled_m = 0.0;
};

/// Goes straight ahead in its parent's xz plane, mirrored by walls at ±reach_m; its LocalTransform says where
/// it is.
struct Mover {
    float heading_rad = 0.0f;  ///< from +X towards +Z; not wrapped
    float speed_m_s = 1.0f;
    float reach_m = 1.0f;
};

/// How an actor walks. A cycle is two steps; each foot stands for one half of it and swings for the other.
struct Gait {
    float leg_length_m = 0.9f;  ///< hip to sole at rest, in the root's own space; > 0
    float phase = 0.0f;         ///< [0, 1); the left foot stands in the first half
    float reach = 0.0f;         ///< sine of the hip's angle when a foot lands; 0 at rest
};

enum class LimbRole : std::uint8_t { leg, shin, arm, forearm, torso, head };

/// A part of a walker that swings about its local X axis (torso and head: turn about Y) as the actor's Gait
/// says.
struct GaitLimb {
    ecs::Entity actor;
    LimbRole role = LimbRole::leg;
    bool right = false;
    glm::quat rest{1.0f, 0.0f, 0.0f, 0.0f};  ///< rotation when standing
};

/// A wheel that rolls about its local X axis as far as its actor travels.
struct WheelSpin {
    ecs::Entity actor;
    float radius_m = 0.3f;
    glm::quat rest{1.0f, 0.0f, 0.0f, 0.0f};
};

/// A clip being played. The clip is an index into the ClipLibrary.
struct ClipCursor {
    std::uint32_t clip = assets::k_none;  ///< k_none: the pose of the file
    double time_s = 0.0;                  ///< into the clip
    float speed = 1.0f;                   ///< clip seconds per second; 0 rests, negative plays backwards
    bool looping = true;                  ///< false: holds at the end
};

/// Moves the AnimatedNodes and MorphWeights that name its entity. See cross_fade().
struct AnimationPlayer {
    ClipCursor playing;
    ClipCursor fading;  ///< what is faded from while fade_left_s > 0
    float fade_s = 0.0f;
    float fade_left_s = 0.0f;
};

/// A node whose LocalTransform is what its player's clip says. What the clip says nothing about is at rest.
struct AnimatedNode {
    ecs::Entity player;
    std::uint32_t node = assets::k_none;  ///< what the clips call it
    LocalTransform rest;
    std::array<std::uint32_t, 6> hints{};  ///< where the keys were last found: speed only, no state
};

/// Weights of the morph targets of one node, each an entity with a MorphWeight.
struct Morph {
    std::uint32_t count = 0;
};

/// Weight of one morph target.
struct MorphWeight {
    ecs::Entity morph;
    ecs::Entity player;                   ///< null: stays as it is
    std::uint32_t node = assets::k_none;  ///< what the clips call it
    std::uint32_t target = 0;             ///< < Morph::count
    float rest = 0.0f;
    float value = 0.0f;
    float previous = 0.0f;                 ///< of the step before
    std::array<std::uint32_t, 2> hints{};  ///< as AnimatedNode::hints
};

/// A skeleton of the ClipLibrary in the world: its joints are nodes, each named by an entity with a
/// SkinJoint.
struct Skin {
    std::uint32_t skeleton = assets::k_none;
    ecs::Entity root;  ///< the node of its first joint; the joints' matrices count from that one's cell
};

/// Which entity is a joint of a skin. A node may be a joint of several.
struct SkinJoint {
    ecs::Entity skin;
    ecs::Entity node;
    std::uint32_t joint = 0;  ///< row of the skeleton
};

/// A renderable whose vertices follow a skin: its WorldTransform and LocalBounds follow from it and are
/// written by the deformation systems.
struct Skinned {
    ecs::Entity skin;
};

/// A renderable whose vertices follow morph weights: its LocalBounds are written by the deformation systems.
struct Morphed {
    ecs::Entity morph;
};

}  // namespace rambla::systems

/// Members that hold entities, for recorded commands.
template <>
struct rambla::ecs::entity_members<rambla::systems::GaitLimb> {
    static constexpr std::tuple value{&rambla::systems::GaitLimb::actor};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::WheelSpin> {
    static constexpr std::tuple value{&rambla::systems::WheelSpin::actor};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::AnimatedNode> {
    static constexpr std::tuple value{&rambla::systems::AnimatedNode::player};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::MorphWeight> {
    static constexpr std::tuple value{&rambla::systems::MorphWeight::morph,
                                      &rambla::systems::MorphWeight::player};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::Skin> {
    static constexpr std::tuple value{&rambla::systems::Skin::root};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::SkinJoint> {
    static constexpr std::tuple value{&rambla::systems::SkinJoint::skin, &rambla::systems::SkinJoint::node};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::Skinned> {
    static constexpr std::tuple value{&rambla::systems::Skinned::skin};
};
template <>
struct rambla::ecs::entity_members<rambla::systems::Morphed> {
    static constexpr std::tuple value{&rambla::systems::Morphed::morph};
};
