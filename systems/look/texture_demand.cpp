#include "systems/look/texture_demand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rambla::systems {
namespace {

constexpr float k_infinity = std::numeric_limits<float>::infinity();

/// Steps along x and y move on the surface by vectors that span all of its directions by `step` or more, so
/// the squares of the four numbers ∂(s,t)/∂(x,y) sum to ‖gradient‖²·step² or more, and the largest of them
/// (which is what coarse hardware, and llvmpipe, take for the length of the longest) is half of the root or
/// more. The rest is for derivatives that are taken between pixels just beside a triangle.
constexpr float k_least_share = 0.5f * 0.9f;

/// Deformed meshes may be compressed to this part of what their joints and weights make of them at rest.
constexpr float k_deformed_share = 0.5f;

float largest_stretch(std::span<const Placement> places) {
    float stretch = 0.0f;
    for (const Placement& place : places)
        stretch = std::max(stretch, stretch_of(place.linear));
    return stretch;
}

/// Metres in the world for one in the mesh's own space, at most.
float stretch_in(const LookChunk& chunk, std::size_t row, const Deformations& poses) {
    float stretch = stretch_of(chunk.now[row].linear);
    if (!chunk.before.empty()) stretch = std::max(stretch, stretch_of(chunk.before[row].value.linear));
    if (!chunk.skins.empty()) {
        const SkinPose* const pose = poses.skin(chunk.skins[row].skin);
        if (pose == nullptr) return stretch;  // not drawn yet
        stretch =
            std::max(largest_stretch(poses.joints(*pose)), largest_stretch(poses.previous_joints(*pose)));
    }
    const bool deforms = !chunk.skins.empty() || !chunk.morphs.empty();
    return deforms ? stretch / k_deformed_share : stretch;
}

}  // namespace

PixelSteps::PixelSteps(const FrameView& view)
    : forward{-glm::transpose(glm::mat3{view.view_from_world})[2]}, orthographic{view.orthographic} {
    const glm::mat4& p = view.clip_from_view;
    const glm::vec2 size{glm::max(view.size_px, glm::uvec2{1})};
    const glm::vec2 tangent{1.0f / p[0][0], 1.0f / p[1][1]};  // orthographic: half the picture's size, m
    step = std::min(2.0f * tangent.x / size.x, 2.0f * tangent.y / size.y);
    if (orthographic) return;
    cos_corner = 1.0f / std::sqrt(1.0f + glm::dot(tangent, tangent));
    near_m = p[3][2];
}

float PixelSteps::least_m(glm::vec3 centre, glm::vec3 half) const {
    if (orthographic) return step > 0.0f ? step : 0.0f;
    const float depth_m = std::max(glm::dot(forward, centre) - glm::dot(glm::abs(forward), half), near_m);
    // Whatever is seen lies at most θ off the axis: its depth is its distance times cos θ or more.
    const float distance_m = glm::length(glm::max(glm::abs(centre) - half, glm::vec3{0.0f}));
    const float least = step * cos_corner * std::max(depth_m, distance_m * cos_corner);
    return least > 0.0f ? least : 0.0f;
}

float stretch_of(const glm::mat3& linear) {
    // The largest eigenvalue of MᵀM is at most the largest sum of a row's magnitudes.
    const glm::mat3 products = glm::transpose(linear) * linear;
    float largest = 0.0f;
    for (glm::length_t i = 0; i < 3; ++i) {
        const glm::vec3 row = glm::abs(products[i]);
        const float sum = row.x + row.y + row.z;
        largest = sum <= largest ? largest : sum;  // NaN wins
    }
    return std::sqrt(largest);
}

std::uint8_t finest_level(float step_m, float texels_per_m, std::uint8_t last) {
    const float texels = k_least_share * step_m * texels_per_m;
    if (!(texels >= 2.0f)) return 0;  // NaN included
    return static_cast<std::uint8_t>(std::min<int>(last, std::ilogb(texels)));
}

void TextureDemand::operator()(const Culling& culling, const TextureUses& uses, const Deformations& poses,
                               Frame& frame) {
    frame.texture_demand.assign(uses.last_levels().size(), k_not_demanded);
    if (frame.texture_demand.empty()) return;
    seen_.assign(uses.pair_count(), {k_infinity, false});
    note_seen(culling, uses, poses, PixelSteps{frame.view});
    for (std::uint32_t pair = 0; pair < uses.pair_count(); ++pair) {
        const auto [step_m, throws_shadow] = seen_[pair];
        for (const TextureUse& use : uses.uses(pair)) {
            std::uint8_t& demand = frame.texture_demand[use.image];
            if (use.cuts_out && throws_shadow) demand = 0;
            if (step_m == k_infinity) continue;
            demand = std::min(demand, finest_level(step_m, use.texels_per_m, uses.last_levels()[use.image]));
        }
    }
}

void TextureDemand::note_seen(const Culling& culling, const TextureUses& uses, const Deformations& poses,
                              const PixelSteps& steps) {
    const BoxColumns boxes = culling.boxes();
    const std::span<const std::uint32_t> seen_by = culling.seen_by();
    for (const LookChunk& chunk : culling.chunks()) {
        for (std::size_t i = 0; i < chunk.entities.size(); ++i) {
            const std::size_t row = chunk.first_row + i;
            if (seen_by[row] == 0) continue;
            const std::uint32_t pair = uses.pair(chunk.renderables[i].mesh, chunk.renderables[i].material);
            if (pair == assets::k_none) continue;
            Seen& seen = seen_[pair];
            if (chunk.casts_shadows && (seen_by[row] & k_seen_by_sun) != 0) seen.throws_shadow = true;
            if ((seen_by[row] & k_seen_by_camera) == 0) continue;
            const float step_m =
                steps.least_m({boxes.centre_x[row], boxes.centre_y[row], boxes.centre_z[row]},
                              {boxes.half_x[row], boxes.half_y[row], boxes.half_z[row]});
            const float own_m = step_m / stretch_in(chunk, i, poses);
            // Nothing may count as unseen, and no number is nearer than any.
            seen.step_m = std::min(seen.step_m, own_m >= 0.0f ? std::min(own_m, 1e30f) : 0.0f);
        }
    }
}

}  // namespace rambla::systems
