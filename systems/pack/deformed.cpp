#include "systems/pack/deformed.h"

#include <algorithm>

#include "systems/position.h"

namespace rambla::systems {
namespace {

JointMatrix rows_of(const Placement& place) {
    const glm::mat3 rows = glm::transpose(place.linear);
    return {glm::vec4{rows[0], place.translation_m.x}, glm::vec4{rows[1], place.translation_m.y},
            glm::vec4{rows[2], place.translation_m.z}};
}

}  // namespace

void PackDeformed::begin(const DeformationSource& source, Frame& frame) {
    frame.joints.clear();
    frame.morphs.clear();
    row_of_skin_.assign(source.poses.skin_count(), assets::k_none);
}

std::uint32_t PackDeformed::joints_of(const DeformationSource& source, const SkinPose& pose,
                                      const Observer& observer, Frame& frame) {
    std::uint32_t& row = row_of_skin_[source.poses.skin_index(pose)];
    if (row != assets::k_none) return row;
    row = static_cast<std::uint32_t>(frame.joints.size());
    const glm::vec3 from_eye_m = offset_m(observer.eye, {pose.cell, glm::vec3{0.0f}});
    const std::span<const Placement> now = source.poses.joints(pose);
    const std::span<const Placement> before = source.poses.previous_joints(pose);
    for (std::size_t i = 0; i < now.size(); ++i) {
        Placement place = between(before[i], now[i], observer.interpolation);
        place.translation_m += from_eye_m;
        frame.joints.push_back(rows_of(place));
    }
    return row;
}

std::uint32_t PackDeformed::morphs_of(const DeformationSource& source, const Morphed& morphed,
                                      std::uint32_t mesh, float interpolation, Frame& frame) {
    const auto first = static_cast<std::uint32_t>(frame.morphs.size());
    const DeformableMesh& targets = source.library.mesh(mesh);
    if (const MorphPose* const pose = source.poses.morph(morphed.morph)) {
        const std::span<const float> now = source.poses.weights(*pose);
        const std::span<const float> before = source.poses.previous_weights(*pose);
        const std::size_t count = std::min(now.size(), targets.morph_reach.size());
        for (std::size_t i = 0; i < count; ++i) {
            const float weight = before[i] * (1.0f - interpolation) + now[i] * interpolation;
            if (weight == 0.0f) continue;
            frame.morphs.push_back({targets.first_target + static_cast<std::uint32_t>(i), weight});
        }
    }
    frame.morphs.push_back({});
    return first;
}

}  // namespace rambla::systems
