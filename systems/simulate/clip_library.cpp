#include "systems/simulate/clip_library.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>

namespace rambla::systems {
namespace {

using assets::AnimatedPath;
using assets::Channel;
using assets::k_none;

bool holds_what_it_says(const Channel& channel, std::size_t node_count) {
    const std::size_t per_key = channel.interpolation == assets::Interpolation::cubic_spline ? 3 : 1;
    const bool right_width = channel.path == AnimatedPath::rotation  ? channel.width == 4
                             : channel.path == AnimatedPath::weights ? channel.width > 0
                                                                     : channel.width == 3;
    return channel.node < node_count && right_width && !channel.times_s.empty() &&
           channel.values.size() >= channel.times_s.size() * per_key * channel.width;
}

std::vector<JointBox> joint_boxes(const assets::Mesh& mesh) {
    std::map<std::uint32_t, assets::Bounds> boxes;
    for (std::size_t v = 0; v < mesh.weights.size(); ++v) {
        for (int i = 0; i < 4; ++i) {
            if (mesh.weights[v][i] > 0.0f) boxes[mesh.joints[v][i]].expand(mesh.positions[v]);
        }
    }
    std::vector<JointBox> list;
    for (const auto& [joint, box] : boxes)
        list.push_back({joint, box});
    return list;
}

DeformableMesh deformable(const assets::Mesh& mesh, std::uint32_t first_target) {
    DeformableMesh made;
    made.first_target = first_target;
    if (mesh.weights.empty() && mesh.morphs.empty()) return made;
    for (const glm::vec3& position : mesh.positions)
        made.rest.expand(position);
    made.joint_boxes = joint_boxes(mesh);
    for (const assets::MorphTarget& target : mesh.morphs) {
        assets::Bounds reach{glm::vec3{0.0f}, glm::vec3{0.0f}};
        for (const glm::vec3& delta : target.positions)
            reach.expand(delta);
        made.morph_reach.push_back(reach);
    }
    return made;
}

}  // namespace

ClipLibrary::ClipLibrary(const assets::Scene& scene)
    : moves_(scene.nodes.size(), 0), morphs_(scene.nodes.size(), 0) {
    for (const assets::Clip& clip : scene.clips)
        add_clip(clip, scene.nodes.size());
    for (const assets::Skeleton& skeleton : scene.skeletons) {
        joint_from_mesh_.push_back(skeleton.joint_from_mesh);
        joint_from_mesh_.back().resize(skeleton.joints.size(), glm::mat4{1.0f});
    }
    std::uint32_t targets = 0;
    for (const assets::Mesh& mesh : scene.meshes) {
        meshes_.push_back(deformable(mesh, targets));
        targets += static_cast<std::uint32_t>(mesh.morphs.size());
    }
}

void ClipLibrary::add_clip(const assets::Clip& clip, std::size_t node_count) {
    IndexedClip& made = clips_.emplace_back();
    made.clip.name = clip.name;
    made.clip.duration_s = clip.duration_s;
    std::uint32_t first = k_none;
    std::uint32_t last = 0;
    for (const Channel& channel : clip.channels) {
        if (!holds_what_it_says(channel, node_count)) {
            spdlog::warn("clip '{}': a channel of node {} is left out: {} keys with {} values of width {}",
                         clip.name, channel.node, channel.times_s.size(), channel.values.size(),
                         channel.width);
            continue;
        }
        made.clip.channels.push_back(channel);
        first = std::min(first, channel.node);
        last = std::max(last, channel.node);
        (channel.path == AnimatedPath::weights ? morphs_ : moves_)[channel.node] = 1;
    }
    if (made.clip.channels.empty()) return;
    made.first_node = first;
    made.nodes.assign(last - first + 1, {k_none, k_none, k_none, k_none});
    for (std::uint32_t i = 0; i < made.clip.channels.size(); ++i) {
        const Channel& channel = made.clip.channels[i];
        std::uint32_t& entry = made.nodes[channel.node - first][static_cast<std::size_t>(channel.path)];
        if (entry == k_none) entry = i;
    }
}

double ClipLibrary::duration_s(std::uint32_t clip) const {
    return clip < clips_.size() ? static_cast<double>(clips_[clip].clip.duration_s) : 0.0;
}

const Channel* ClipLibrary::channel(std::uint32_t clip, std::uint32_t node, AnimatedPath path) const {
    if (clip >= clips_.size()) return nullptr;
    const IndexedClip& found = clips_[clip];
    // Nodes before the first become huge, and are none.
    const std::uint32_t row = node - found.first_node;
    if (row >= found.nodes.size()) return nullptr;
    const std::uint32_t index = found.nodes[row][static_cast<std::size_t>(path)];
    return index == k_none ? nullptr : &found.clip.channels[index];
}

}  // namespace rambla::systems
