#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "systems/frame.h"
#include "systems/look/culling.h"
#include "systems/look/texture_uses.h"
#include "systems/simulate/deformation.h"

namespace rambla::systems {

/// What of a view says how far apart on a surface neighbouring pixels can lie.
///
/// A point at depth z, seen θ off the view's axis, lies z·k·cos θ from the ray of the next pixel at least, if
/// pixels are k apart on the plane at depth 1: whatever way its surface faces, one pixel's step moves that
/// far on it or farther.
struct PixelSteps {
    explicit PixelSteps(const FrameView& view);

    /// Metres that a step of one pixel covers at least on whatever is seen inside of a box.
    /// @param centre, half  of the box, camera-relative; anything broken gives 0
    /// @return              ≥ 0, perhaps infinite, never NaN
    [[nodiscard]] float least_m(glm::vec3 centre, glm::vec3 half) const;

    glm::vec3 forward{0.0f, 0.0f, -1.0f};
    float step = 0.0f;        ///< of a pixel: on the plane at depth 1, orthographic views: everywhere, m
    float cos_corner = 1.0f;  ///< of the largest θ, in the picture's corner
    float near_m = 0.0f;      ///< nothing nearer is seen
    bool orthographic = false;
};

/// The most by which a map makes lengths grow, rounded up: exact where the axes stay perpendicular.
[[nodiscard]] float stretch_of(const glm::mat3& linear);

/// The finest level that can be sampled where a step of one pixel covers `step_m` metres or more.
/// @param texels_per_m  as TextureUse::texels_per_m
[[nodiscard]] std::uint8_t finest_level(float step_m, float texels_per_m, std::uint8_t last);

/// Finds for each image the finest level that the picture can need, and writes it to
/// Frame::texture_demand. Never too coarse, but for meshes that deform: those are taken to be compressed to
/// no less than half. Shadow maps may be of any fineness, so images that cut out casters are needed whole.
/// Keeps its memory.
class TextureDemand {
public:
    /// @param frame  with its view
    void operator()(const Culling& culling, const TextureUses& uses, const Deformations& poses, Frame& frame);

private:
    void note_seen(const Culling& culling, const TextureUses& uses, const Deformations& poses,
                   const PixelSteps& steps);

    struct Seen {
        float step_m = 0.0f;  ///< least over its instances, in the mesh's own metres; infinite: not seen
        bool throws_shadow = false;
    };
    std::vector<Seen> seen_;  ///< by pair of TextureUses
};

}  // namespace rambla::systems
