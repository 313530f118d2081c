#include "game/study/surface_errors.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "game/statistics.h"
#include "game/study/metrics/angles.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

glm::vec3 texel_of(const assets::Image& image, std::size_t index) {
    glm::vec3 texel;
    std::memcpy(&texel, image.texels.data() + index * sizeof(glm::vec4), sizeof(texel));
    return texel;
}

/// Whether the ray through a pixel's middle and those of its neighbours meet one smooth surface. Where they
/// do not, the rasteriser may show another triangle than the ray meets.
bool is_smooth(const assets::HitPicture& seen, std::uint32_t x, std::uint32_t y) {
    constexpr double k_step_share = 0.001;  // of the distance, off the plane through the hit
    const glm::uvec2 size = seen.size_px;
    const assets::TraceHit& hit = seen.hits[std::size_t{y} * size.x + x];
    if (!hit.exists()) return false;
    for (std::uint32_t ny = y > 0 ? y - 1 : 0; ny <= std::min(y + 1, size.y - 1); ++ny) {
        for (std::uint32_t nx = x > 0 ? x - 1 : 0; nx <= std::min(x + 1, size.x - 1); ++nx) {
            const assets::TraceHit& other = seen.hits[std::size_t{ny} * size.x + nx];
            if (other.instance != hit.instance) return false;
            const double off_m = glm::dot(hit.geometric_normal, other.position_m - hit.position_m);
            if (std::fabs(off_m) > k_step_share * hit.distance_m) return false;
        }
    }
    return true;
}

}  // namespace

void SurfaceErrors::add(const assets::HitPicture& seen, const render::ObjectImage& objects,
                        const render::SurfaceImages& surfaces) {
    constexpr double k_mm = 1e3;
    constexpr double k_ppm = 1e6;
    constexpr double k_other_surface_share = 0.01;  // no layout is off by that much
    pixels_ += seen.hits.size();
    for (std::size_t i = 0; i < seen.hits.size(); ++i) {
        const assets::TraceHit& hit = seen.hits[i];
        const auto x = static_cast<std::uint32_t>(i % seen.size_px.x);
        const auto y = static_cast<std::uint32_t>(i / seen.size_px.x);
        if (!is_smooth(seen, x, y) || objects.ids[i] != hit.object) continue;
        const glm::vec3 position = texel_of(surfaces.positions, i);
        const glm::vec3 normal = texel_of(surfaces.normals, i);
        if (!is_finite(position) || !is_finite(normal) || normal == glm::vec3{0.0f}) {
            ++broken_;
            continue;
        }
        const double away_m = glm::distance(hit.position_m, glm::dvec3{position});
        if (away_m > k_other_surface_share * hit.distance_m) {
            ++other_surfaces_;
            continue;
        }
        position_mm_.push_back(k_mm * away_m);
        position_ppm_.push_back(k_ppm * away_m / hit.distance_m);
        normals_.emplace_back(hit.shading_normal);
        normals_found_.push_back(normal);
    }
}

std::vector<Metric> SurfaceErrors::metrics() const {
    const std::vector<Metric> counts{{"other_surface_pct", percent(other_surfaces_, pixels_), "%"},
                                     {"broken_pct", percent(broken_, pixels_), "%"},
                                     {"compared_pct", percent(position_mm_.size(), pixels_), "%"}};
    if (position_mm_.empty()) return counts;  // percentiles of nothing would be those of a perfect layout
    const Angles angles = angles_between(normals_, normals_found_);
    std::vector<Metric> metrics{{"position_p50_mm", median(position_mm_), "mm"},
                                {"position_p99_mm", percentile(position_mm_, 0.99), "mm"},
                                {"position_max_mm", percentile(position_mm_, 1.0), "mm"},
                                {"position_p99_ppm", percentile(position_ppm_, 0.99), "ppm"},
                                {"angle_p50_deg", angles.p50_deg, "deg"},
                                {"angle_p99_deg", angles.p99_deg, "deg"},
                                {"angle_max_deg", angles.max_deg, "deg"}};
    metrics.insert(metrics.end(), counts.begin(), counts.end());
    return metrics;
}

}  // namespace rambla::game::study
