#include "systems/simulate/deformation.h"

#include <algorithm>
#include <limits>

#include "ecs/schedule.h"
#include "systems/position.h"

namespace rambla::systems {
namespace {

using assets::Bounds;

constexpr Bounds k_nowhere_else{glm::vec3{0.0f}, glm::vec3{0.0f}};

/// From a mesh to the corner of `cell`.
Placement skinning(const WorldTransform& node, glm::ivec3 cell, const glm::mat4& joint_from_mesh) {
    const glm::vec3 translation_m = cell_offset_m(cell, node.cell) + node.translation_m;
    return {node.linear * glm::mat3{joint_from_mesh},
            node.linear * glm::vec3{joint_from_mesh[3]} + translation_m};
}

Bounds sum(const Bounds& a, const Bounds& b) {
    return {a.min + b.min, a.max + b.max};
}

Bounds moved(const Bounds& box, const Placement& by) {
    const glm::mat3 magnitude{glm::abs(by.linear[0]), glm::abs(by.linear[1]), glm::abs(by.linear[2])};
    const glm::vec3 centre = by.linear * box.centre() + by.translation_m;
    const glm::vec3 half = magnitude * box.half_extents();
    return {centre - half, centre + half};
}

bool turned_inside_out(const glm::mat3& linear) {
    const glm::dmat3 exact{linear};
    return glm::dot(glm::cross(exact[0], exact[1]), exact[2]) < 0.0;
}

/// Of this step and the one before: pictures lie between.
struct Reaches {
    Bounds now = k_nowhere_else;
    Bounds before = k_nowhere_else;
};

Reaches reaches_of(const DeformableMesh& mesh, const Morphed* morphed, const Deformations& deformations) {
    const MorphPose* const pose = morphed == nullptr ? nullptr : deformations.morph(morphed->morph);
    if (pose == nullptr) return {};
    return {morph_reach(mesh, deformations.weights(*pose)),
            morph_reach(mesh, deformations.previous_weights(*pose))};
}

template <class Pose>
void add(std::vector<Pose>& poses, std::vector<std::uint32_t>& row_of, const Pose& pose) {
    const std::size_t index = pose.entity.index;
    if (index >= row_of.size()) row_of.resize(index + 1, 0);
    row_of[index] = static_cast<std::uint32_t>(poses.size());
    poses.push_back(pose);
}

template <class Pose>
const Pose* find(const std::vector<Pose>& poses, const std::vector<std::uint32_t>& row_of,
                 ecs::Entity entity) {
    if (entity.index >= row_of.size()) return nullptr;
    const std::uint32_t row = row_of[entity.index];
    return row < poses.size() && poses[row].entity == entity ? &poses[row] : nullptr;
}

}  // namespace

const SkinPose* Deformations::skin(ecs::Entity skin) const {
    return find(skins_, row_of_skin_, skin);
}

const MorphPose* Deformations::morph(ecs::Entity morph) const {
    return find(morphs_, row_of_morph_, morph);
}

void gather_deformations(ecs::View<ecs::Entity, const Skin> skins, ecs::View<const SkinJoint> joints,
                         ecs::View<ecs::Entity, const Morph> morphs, ecs::View<const MorphWeight> weights,
                         ecs::Lookup<const WorldTransform, const PreviousWorldTransform> nodes,
                         ecs::Res<ClipLibrary> library, ecs::ResMut<Deformations> deformations) {
    Deformations& all = *deformations;
    all.skins_.clear();
    all.morphs_.clear();
    std::uint32_t rows = 0;
    skins.each([&](ecs::Entity entity, const Skin& skin) {
        const auto count = static_cast<std::uint32_t>(library->joint_from_mesh(skin.skeleton).size());
        const bool stands = nodes.alive(skin.root);
        const glm::ivec3 cell = stands ? nodes.get<WorldTransform>(skin.root).cell : glm::ivec3{0};
        add(all.skins_, all.row_of_skin_, {entity, skin.skeleton, rows, count, cell});
        rows += count;
    });
    all.joints_.assign(rows, {});
    all.previous_joints_.assign(rows, {});
    joints.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](const SkinJoint& joint) {
            const SkinPose* const pose = all.skin(joint.skin);
            if (pose == nullptr || joint.joint >= pose->count || !nodes.alive(joint.node)) return;
            const WorldTransform& now = nodes.get<WorldTransform>(joint.node);
            const auto* const before = nodes.try_get<PreviousWorldTransform>(joint.node);
            const glm::mat4& bind = library->joint_from_mesh(pose->skeleton)[joint.joint];
            all.joints_[pose->first + joint.joint] = skinning(now, pose->cell, bind);
            all.previous_joints_[pose->first + joint.joint] =
                skinning(before == nullptr ? now : before->value, pose->cell, bind);
        });
    });

    rows = 0;
    morphs.each([&](ecs::Entity entity, const Morph& morph) {
        add(all.morphs_, all.row_of_morph_, {entity, rows, morph.count});
        rows += morph.count;
    });
    all.weights_.assign(rows, 0.0f);
    all.previous_weights_.assign(rows, 0.0f);
    weights.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](const MorphWeight& weight) {
            const MorphPose* const pose = all.morph(weight.morph);
            if (pose == nullptr || weight.target >= pose->count) return;
            all.weights_[pose->first + weight.target] = weight.value;
            all.previous_weights_[pose->first + weight.target] = weight.previous;
        });
    });
}

void bound_morphed(ecs::View<const Morphed, const Renderable, LocalBounds, ecs::Without<Skinned>> renderables,
                   ecs::Res<ClipLibrary> library, ecs::Res<Deformations> deformations) {
    renderables.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](const Morphed& morphed, const Renderable& drawn, LocalBounds& bounds) {
            const DeformableMesh& mesh = library->mesh(drawn.mesh);
            const Reaches reaches = reaches_of(mesh, &morphed, *deformations);
            Bounds box = sum(mesh.rest, reaches.now);
            box.expand(sum(mesh.rest, reaches.before));
            bounds = {box.centre(), box.half_extents()};
        });
    });
}

void bound_skinned(
    ecs::View<const Skinned, ecs::Optional<const Morphed>, const Renderable, WorldTransform, LocalBounds>
        renderables,
    ecs::Res<ClipLibrary> library, ecs::Res<Deformations> deformations) {
    renderables.for_each_chunk([&](const auto& chunk) {
        auto [skins, morphs, drawn, transforms, bounds] = chunk;
        for (std::size_t i = 0; i < skins.size(); ++i) {
            const SkinPose* const pose = deformations->skin(skins[i].skin);
            if (pose == nullptr || pose->count == 0) continue;
            const DeformableMesh& mesh = library->mesh(drawn[i].mesh);
            const Reaches reaches = reaches_of(mesh, morphs.empty() ? nullptr : &morphs[i], *deformations);
            const std::span<const Placement> joints = deformations->joints(*pose);
            Bounds box = skinned_bounds(mesh, joints, reaches.now);
            box.expand(skinned_bounds(mesh, deformations->previous_joints(*pose), reaches.before));
            transforms[i] = {pose->cell, glm::mat3{1.0f}, box.centre()};
            if (turned_inside_out(joints[0].linear)) transforms[i].linear[0].x = -1.0f;
            bounds[i] = {glm::vec3{0.0f}, box.half_extents()};
        }
    });
}

Bounds morph_reach(const DeformableMesh& mesh, std::span<const float> weights) {
    Bounds reach = k_nowhere_else;
    const std::size_t count = std::min(weights.size(), mesh.morph_reach.size());
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 a = mesh.morph_reach[i].min * weights[i];
        const glm::vec3 b = mesh.morph_reach[i].max * weights[i];
        reach.min += glm::min(a, b);
        reach.max += glm::max(a, b);
    }
    return reach;
}

Bounds skinned_bounds(const DeformableMesh& mesh, std::span<const Placement> joints, const Bounds& reach) {
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    Bounds box;
    for (const JointBox& joint : mesh.joint_boxes) {
        const Bounds part = moved(sum(joint.box, reach), joints[joint.joint]);
        if (part.empty()) return {glm::vec3{-k_infinity}, glm::vec3{k_infinity}};  // NaN: could be anywhere
        box.expand(part);
    }
    return box;
}

void settle_deformations(ecs::World& world) {
    if (!world.has_resource<ClipLibrary>()) return;
    if (!world.has_resource<Deformations>()) world.set_resource(Deformations{});
    ecs::Schedule schedule{{.threads = 1}};
    schedule.add("gathering", gather_deformations);
    schedule.add("bounds of morphed", bound_morphed);
    schedule.add("bounds of skinned", bound_skinned).after("bounds of morphed");
    schedule.run(world);
}

}  // namespace rambla::systems
