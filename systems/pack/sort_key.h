#pragma once

#include <bit>
#include <cstdint>

namespace rambla::systems {

/// 64-bit sort key of a draw; ascending keys are the order of drawing.
///
///     63  62 61   57  56
///    ┌──────┬───────┬─────┬───────────────────────────────────────────────────────┐
///    │ pass │ view  │class│ 56 bits that depend on the blend class                │
///    └──────┴───────┴─────┴───────────────────────────────────────────────────────┘
///                     opaque: state changes are dear, and near things hide far ones
///                          55      47 46           31 30           15 14          0
///                         ┌──────────┬───────────────┬───────────────┬─────────────┐
///                         │ pipeline │ material      │ mesh          │ depth ↑     │
///                         └──────────┴───────────────┴───────────────┴─────────────┘
///                     blended: the picture depends on the order
///                          55                          25 24      16 15           0
///                         ┌──────────────────────────────┬──────────┬──────────────┐
///                         │ depth ↓                      │ pipeline │ material     │
///                         └──────────────────────────────┴──────────┴──────────────┘
///
/// Materials and meshes enter with their low 16 bits: beyond 65 536 of them the order stays total and
/// deterministic, only fewer neighbours merge.
using SortKey = std::uint64_t;

enum class DrawPass : std::uint8_t { surfaces, shadow_casters };
enum class BlendClass : std::uint8_t { opaque, blended };

/// Positive floats as 31 bits that ascend with them: for a clear sign bit the bits of a float order like
/// integers. Negative numbers count as 0 (something around the eye), NaN as the farthest.
[[nodiscard]] constexpr std::uint32_t ordered_depth(float depth_m) {
    if (depth_m != depth_m) return 0x7fffffffu;
    return depth_m > 0.0f ? std::bit_cast<std::uint32_t>(depth_m) : 0u;
}

[[nodiscard]] constexpr SortKey key_head(DrawPass pass, std::uint32_t view, BlendClass blend) {
    return (static_cast<SortKey>(pass) << 62u) | (static_cast<SortKey>(view & 31u) << 57u) |
           (static_cast<SortKey>(blend) << 56u);
}

/// @param pipeline  pack(Pipeline), of which the low 9 bits count: the others are of blended things alone
/// @param depth_m   distance along the view; its exponent and 7 bits of its mantissa are kept, which is
/// monotone
[[nodiscard]] constexpr SortKey opaque_key(DrawPass pass, std::uint32_t view, std::uint32_t pipeline,
                                           std::uint32_t material, std::uint32_t mesh, float depth_m) {
    return key_head(pass, view, BlendClass::opaque) | (static_cast<SortKey>(pipeline & 0x1ffu) << 47u) |
           (static_cast<SortKey>(material & 0xffffu) << 31u) | (static_cast<SortKey>(mesh & 0xffffu) << 15u) |
           (ordered_depth(depth_m) >> 16u);
}

/// Far things first; the whole float counts. Equally far ones are in the order of the low 9 bits of their
/// pipelines, then of their materials.
[[nodiscard]] constexpr SortKey blended_key(DrawPass pass, std::uint32_t view, float depth_m,
                                            std::uint32_t pipeline, std::uint32_t material) {
    return key_head(pass, view, BlendClass::blended) |
           (static_cast<SortKey>(0x7fffffffu - ordered_depth(depth_m)) << 25u) |
           (static_cast<SortKey>(pipeline & 0x1ffu) << 16u) | (material & 0xffffu);
}

[[nodiscard]] constexpr DrawPass pass_of(SortKey key) {
    return static_cast<DrawPass>(key >> 62u);
}
[[nodiscard]] constexpr BlendClass blend_class_of(SortKey key) {
    return static_cast<BlendClass>((key >> 56u) & 1u);
}

}  // namespace rambla::systems
