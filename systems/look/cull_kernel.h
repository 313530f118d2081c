#pragma once

#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace rambla::systems {

/// Half space of all points p with dot(normal, p) + offset_m ≥ 0; the normal is a unit vector that points
/// inwards.
struct CullPlane {
    glm::vec3 normal{0.0f};
    float offset_m = 0.0f;
};

/// Convex volume that bounds are tested against: the intersection of at most six half spaces. Without planes
/// it is all of space.
struct CullVolume {
    std::array<CullPlane, 6> planes{};
    std::uint32_t plane_count = 0;
};

/// Boxes as columns of equal length: centres and half extents (≥ 0), in metres, in the space of the volumes.
struct BoxColumns {
    std::span<const float> centre_x, centre_y, centre_z;
    std::span<const float> half_x, half_y, half_z;

    [[nodiscard]] std::size_t size() const { return centre_x.size(); }
};

/// Bits of a visibility mask, hence the number of volumes that one sweep can test.
inline constexpr std::size_t k_max_cull_volumes = 32;

/// How far outside a plane a box must be to be culled, as a share of the magnitudes that went into its
/// distance.
///
/// A distance is summed from seven terms: n·c, the offset and |n|·h. Each coefficient was rounded to float
/// once, each product once, and each term passes through at most four additions: the error is below γ₆ = 6u /
/// (1 − 6u) times the sum m of the terms' magnitudes, with u = 2⁻²⁴. The computed m is low by less than γ₇
/// itself, so 8u would do. 16u leaves as much again to whoever draws the box, whose vertices go through
/// rounded matrices as well.
inline constexpr float k_relative_slack = 16.0f / 16777216.0f;

/// Adds what the relative slack cannot see: coefficients below 2⁻¹²⁶ keep an absolute error of 2⁻¹⁵⁰, which
/// the largest floats turn into 2⁻²² m each; six of them stay below two micrometres.
inline constexpr float k_absolute_slack_m = 2.0e-6f;

namespace detail {

/// Plane a·x + b·y + c·z + d ≥ 0, scaled to a unit normal. Adds nothing for a plane without direction (the
/// far plane of an infinite projection) or with non-finite coefficients: fewer planes only ever show more.
inline void add_plane(CullVolume& volume, const glm::dvec4& plane) {
    const double length = std::sqrt(plane.x * plane.x + plane.y * plane.y + plane.z * plane.z);
    const glm::vec4 unit{plane / length};
    const float sum = unit.x + unit.y + unit.z + unit.w;
    if (!std::isfinite(sum)) return;
    volume.planes[volume.plane_count++] = {glm::vec3{unit}, unit.w};
}

/// Whether the box may reach into every half space. Written as !(outside), so that NaN counts as visible;
/// infinities make `magnitude` infinite and the sum infinite or NaN, hence visible too. AVX2 below does the
/// same operations in the same order.
[[nodiscard]] inline bool box_may_be_seen(const CullVolume& volume, glm::vec3 centre, glm::vec3 half) {
    for (std::uint32_t i = 0; i < volume.plane_count; ++i) {
        const glm::vec3 n = volume.planes[i].normal;
        const float d = volume.planes[i].offset_m;
        const float x = n.x * centre.x;
        const float y = n.y * centre.y;
        const float z = n.z * centre.z;
        const float reach = (std::fabs(n.x) * half.x + std::fabs(n.y) * half.y) + std::fabs(n.z) * half.z;
        const float distance = (((x + y) + z) + d) + reach;
        const float magnitude = (((std::fabs(x) + std::fabs(y)) + std::fabs(z)) + std::fabs(d)) + reach;
        const float slack = k_relative_slack * magnitude + k_absolute_slack_m;
        if (distance + slack < 0.0f) return false;
    }
    return true;
}

}  // namespace detail

/// The volume that a view sees, from its matrix with clip depth 0 … 1 (reversed or not). An infinite far
/// plane, whose row of the matrix has no direction, is left out. Gribb and Hartmann 2001, "Fast extraction of
/// viewing frustum planes from the world-view-projection matrix".
[[nodiscard]] inline CullVolume frustum_volume(const glm::mat4& clip_from_world) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4{clip_from_world});
    CullVolume volume;
    detail::add_plane(volume, rows[3] + rows[0]);
    detail::add_plane(volume, rows[3] - rows[0]);
    detail::add_plane(volume, rows[3] + rows[1]);
    detail::add_plane(volume, rows[3] - rows[1]);
    detail::add_plane(volume, rows[3] - rows[2]);
    detail::add_plane(volume, rows[2]);
    return volume;
}

/// The volume of everything whose shadow may fall into `seen`: `seen` swept towards the light.
///
///        sun          A caster's shadow travels along t. It can reach the volume if the volume, swept along
///        −t, ╲ t          meets the caster. A half space with dot(n, t) > 0 is left behind by that sweep:
///        dropped.
///    ┌────╲─┐         The others hold for the swept body as well. (Planes through silhouette edges, which
///    would │     ╲│ seen    bound it more tightly, are not added.) └──────┘
///
/// @param direction_to_light  unit vector; the light travels the other way
[[nodiscard]] inline CullVolume shadow_caster_volume(const CullVolume& seen, glm::vec3 direction_to_light) {
    // Kept only if the sign is certain: the sum of three products is off by less than γ₃ of its terms'
    // magnitudes. A plane that is parallel to the light in every coordinate (a level camera under the zenith
    // sun) has no such terms: kept.
    constexpr float k_certain = 8.0f / 16777216.0f;
    CullVolume volume;
    for (std::uint32_t i = 0; i < seen.plane_count; ++i) {
        const glm::vec3 terms = seen.planes[i].normal * direction_to_light;
        const float magnitude = std::fabs(terms.x) + std::fabs(terms.y) + std::fabs(terms.z);
        const bool kept = (terms.x + terms.y) + terms.z >= k_certain * magnitude;
        if (kept) volume.planes[volume.plane_count++] = seen.planes[i];
    }
    return volume;
}

/// Whether a sphere may reach into the volume: never false for a visible one, true for non-finite input.
/// @param radius_m  ≥ 0
[[nodiscard]] inline bool sphere_may_be_seen(const CullVolume& volume, glm::vec3 centre, float radius_m) {
    for (std::uint32_t i = 0; i < volume.plane_count; ++i) {
        const glm::vec3 n = volume.planes[i].normal;
        const float d = volume.planes[i].offset_m;
        const glm::vec3 terms = n * centre;
        const glm::vec3 sizes = glm::abs(terms);
        const float distance = (((terms.x + terms.y) + terms.z) + d) + radius_m;
        const float magnitude = (((sizes.x + sizes.y) + sizes.z) + std::fabs(d)) + radius_m;
        if (distance + (k_relative_slack * magnitude + k_absolute_slack_m) < 0.0f) return false;
    }
    return true;
}

/// Tests rows [first, size) against all volumes, one after the other.
/// @param seen_by  gets one mask per box: bit v is set if volume v may see it. Never unset for a visible box,
/// for any
///                 finite input; always set for non-finite boxes.
inline void cull_scalar(const BoxColumns& boxes, std::span<const CullVolume> volumes,
                        std::span<std::uint32_t> seen_by, std::size_t first = 0) {
    for (std::size_t row = first; row < boxes.size(); ++row) {
        const glm::vec3 centre{boxes.centre_x[row], boxes.centre_y[row], boxes.centre_z[row]};
        const glm::vec3 half{boxes.half_x[row], boxes.half_y[row], boxes.half_z[row]};
        std::uint32_t mask = 0;
        for (std::size_t v = 0; v < volumes.size(); ++v) {
            if (detail::box_may_be_seen(volumes[v], centre, half)) mask |= 1u << v;
        }
        seen_by[row] = mask;
    }
}

/// As cull_scalar, eight rows at a time, and equal to it in every bit: no fused multiply-add, the same order
/// of operations. Needs a processor with AVX2.
__attribute__((target("avx2"))) inline void cull_avx2(const BoxColumns& boxes,
                                                      std::span<const CullVolume> volumes,
                                                      std::span<std::uint32_t> seen_by) {
    const __m256 sign = _mm256_set1_ps(-0.0f);
    const __m256 relative = _mm256_set1_ps(k_relative_slack);
    const __m256 absolute = _mm256_set1_ps(k_absolute_slack_m);
    const std::size_t whole = boxes.size() / 8 * 8;
    for (std::size_t row = 0; row < whole; row += 8) {
        const __m256 cx = _mm256_loadu_ps(&boxes.centre_x[row]);
        const __m256 cy = _mm256_loadu_ps(&boxes.centre_y[row]);
        const __m256 cz = _mm256_loadu_ps(&boxes.centre_z[row]);
        const __m256 hx = _mm256_loadu_ps(&boxes.half_x[row]);
        const __m256 hy = _mm256_loadu_ps(&boxes.half_y[row]);
        const __m256 hz = _mm256_loadu_ps(&boxes.half_z[row]);
        __m256i masks = _mm256_setzero_si256();
        for (std::size_t v = 0; v < volumes.size(); ++v) {
            __m256 outside = _mm256_setzero_ps();
            for (std::uint32_t i = 0; i < volumes[v].plane_count; ++i) {
                const CullPlane& plane = volumes[v].planes[i];
                const __m256 nx = _mm256_set1_ps(plane.normal.x);
                const __m256 ny = _mm256_set1_ps(plane.normal.y);
                const __m256 nz = _mm256_set1_ps(plane.normal.z);
                const __m256 d = _mm256_set1_ps(plane.offset_m);
                const __m256 x = _mm256_mul_ps(nx, cx);
                const __m256 y = _mm256_mul_ps(ny, cy);
                const __m256 z = _mm256_mul_ps(nz, cz);
                const __m256 reach_x = _mm256_mul_ps(_mm256_andnot_ps(sign, nx), hx);
                const __m256 reach_y = _mm256_mul_ps(_mm256_andnot_ps(sign, ny), hy);
                const __m256 reach_z = _mm256_mul_ps(_mm256_andnot_ps(sign, nz), hz);
                const __m256 reach = _mm256_add_ps(_mm256_add_ps(reach_x, reach_y), reach_z);
                __m256 distance = _mm256_add_ps(_mm256_add_ps(x, y), z);
                distance = _mm256_add_ps(_mm256_add_ps(distance, d), reach);
                __m256 magnitude = _mm256_add_ps(_mm256_andnot_ps(sign, x), _mm256_andnot_ps(sign, y));
                magnitude = _mm256_add_ps(magnitude, _mm256_andnot_ps(sign, z));
                magnitude = _mm256_add_ps(_mm256_add_ps(magnitude, _mm256_andnot_ps(sign, d)), reach);
                const __m256 slack = _mm256_add_ps(_mm256_mul_ps(relative, magnitude), absolute);
                const __m256 below =
                    _mm256_cmp_ps(_mm256_add_ps(distance, slack), _mm256_setzero_ps(), _CMP_LT_OQ);
                outside = _mm256_or_ps(outside, below);
            }
            const __m256i bit = _mm256_set1_epi32(static_cast<int>(1u << v));
            masks = _mm256_or_si256(masks, _mm256_andnot_si256(_mm256_castps_si256(outside), bit));
        }
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(&seen_by[row]), masks);
    }
    cull_scalar(boxes, volumes, seen_by, whole);
}

/// One sweep over all boxes against up to k_max_cull_volumes volumes, with the best instructions of this
/// processor.
/// @param seen_by  as long as the columns; see cull_scalar
inline void cull(const BoxColumns& boxes, std::span<const CullVolume> volumes,
                 std::span<std::uint32_t> seen_by) {
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) {
        cull_avx2(boxes, volumes, seen_by);
    } else {
        cull_scalar(boxes, volumes, seen_by);
    }
}

}  // namespace rambla::systems
