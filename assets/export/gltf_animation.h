#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "assets/clip.h"
#include "assets/export/gltf_buffer.h"
#include "assets/skeleton.h"

namespace rambla::assets {

/// Writes what moves in a scene into a glTF buffer.
class GltfAnimation {
public:
    explicit GltfAnimation(GltfBuffer& buffer) : buffer_{buffer} {}

    /// A skin of glTF, from a skeleton with at least one joint.
    [[nodiscard]] nlohmann::json skin_of(const Skeleton& skeleton);

    /// An animation of glTF; null for a clip without channels, which glTF does not have.
    /// @param has_mesh  for each node whether it has a mesh in the document: others have no weights to move
    [[nodiscard]] nlohmann::json animation_of(const Clip& clip, const std::vector<bool>& has_mesh);

private:
    std::size_t add_times(const std::vector<float>& times_s);
    std::size_t add_values(const Channel& channel);

    GltfBuffer& buffer_;
    std::map<std::vector<float>, std::size_t>
        times_;  ///< accessors: channels often have their times in common
};

}  // namespace rambla::assets
