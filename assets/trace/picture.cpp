#include "assets/trace/picture.h"

#include <oneapi/tbb/parallel_for.h>

#include <cstddef>

#include "assets/assert.h"
#include "assets/trace/samples.h"

namespace rambla::assets {
namespace {

/// Small enough for the shadiest corner not to hold up the rest, large enough to cost nothing.
constexpr std::size_t k_pixels_at_once = 64;

/// Calls `visit` with the number of each pixel.
template <class Visit>
void for_each_pixel(glm::uvec2 size_px, Visit&& visit) {
    const std::size_t count = std::size_t{size_px.x} * size_px.y;
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count, k_pixels_at_once},
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                              visit(i);
                      });
}

/// A hit for each pixel for which `hit_of` has one.
template <class HitOf>
HitPicture hit_picture(glm::uvec2 size_px, HitOf&& hit_of) {
    HitPicture picture{size_px, std::vector<TraceHit>(std::size_t{size_px.x} * size_px.y)};
    for_each_pixel(size_px, [&](std::size_t i) { picture.hits[i] = hit_of(i).value_or(TraceHit{}); });
    return picture;
}

/// A share for each pixel that shows something, 1 for the others.
template <class ShareOf>
std::vector<float> share_picture(const HitPicture& seen, ShareOf&& share_of) {
    std::vector<float> shares(seen.hits.size(), 1.0f);
    for_each_pixel(seen.size_px, [&](std::size_t i) {
        if (seen.hits[i].exists()) shares[i] = static_cast<float>(share_of(seen.hits[i], i));
    });
    return shares;
}

TraceRay camera_ray(const CameraRays& rays, std::size_t pixel) {
    const std::size_t width = rays.size_px().x;
    return rays.through_pixel(static_cast<std::uint32_t>(pixel % width),
                              static_cast<std::uint32_t>(pixel / width));
}

/// Whether a light in that direction, at t = t_max, shines on a hit.
bool is_lit(const Tracer& tracer, const TraceHit& hit, glm::dvec3 direction, double t_max) {
    if (!(glm::dot(hit.geometric_normal, direction) > 0.0)) return false;
    return !tracer.is_stopped({.origin_m = offset_origin(hit),
                               .direction = direction,
                               .t_max = t_max,
                               .faces = TraceFaces::lit,
                               .rays = k_rays_of_light});
}

glm::dvec3 place_on(const AreaLight& light, glm::dvec2 square) {
    const glm::dvec2 place = light.disc ? on_disc(square) : 2.0 * square - 1.0;
    return light.centre + place.x * light.half_u + place.y * light.half_v;
}

}  // namespace

HitPicture trace_picture(const Tracer& tracer, const TraceCamera& camera) {
    const CameraRays rays{camera};
    return hit_picture(camera.size_px, [&](std::size_t pixel) {
        return tracer.first_hit(camera_ray(rays, pixel), &rays.spread());
    });
}

HitPicture trace_mirrors(const Tracer& tracer, const TraceCamera& camera, const HitPicture& seen) {
    RAMBLA_ASSERT(seen.size_px == camera.size_px, "the hits are those of this camera");
    const CameraRays rays{camera};
    return hit_picture(camera.size_px, [&](std::size_t pixel) -> std::optional<TraceHit> {
        const TraceHit& mirror = seen.hits[pixel];
        if (!mirror.exists()) return {};
        const glm::dvec3 incoming = glm::normalize(camera_ray(rays, pixel).direction);
        glm::dvec3 outgoing = glm::reflect(incoming, mirror.shading_normal);
        if (!(glm::dot(outgoing, mirror.geometric_normal) > 0.0))
            outgoing = glm::reflect(incoming, mirror.geometric_normal);
        return tracer.first_hit({.origin_m = offset_origin(mirror), .direction = outgoing});
    });
}

std::vector<float> trace_sun(const Tracer& tracer, const HitPicture& seen, glm::dvec3 to_sun) {
    return share_picture(seen, [&](const TraceHit& hit, std::size_t) {
        return is_lit(tracer, hit, to_sun, std::numeric_limits<double>::infinity()) ? 1.0 : 0.0;
    });
}

std::vector<float> trace_area_light(const Tracer& tracer, const HitPicture& seen, const AreaLight& light,
                                    SampleCount count) {
    RAMBLA_ASSERT(count.samples > 0, "a mean needs a sample");
    return share_picture(seen, [&](const TraceHit& hit, std::size_t pixel) {
        const glm::dvec3 origin = offset_origin(hit);
        std::uint32_t lit = 0;
        for (std::uint32_t s = 0; s < count.samples; ++s) {
            const glm::dvec3 place = place_on(light, stratified_sample(count.seed, pixel, s, count.samples));
            const bool shines = light.distant
                                    ? is_lit(tracer, hit, place, std::numeric_limits<double>::infinity())
                                    : is_lit(tracer, hit, place - origin, 1.0);
            lit += shines ? 1 : 0;
        }
        return static_cast<double>(lit) / count.samples;
    });
}

std::vector<float> trace_ambient(const Tracer& tracer, const HitPicture& seen, SampleCount count,
                                 double radius_m) {
    RAMBLA_ASSERT(count.samples > 0, "a mean needs a sample");
    return share_picture(seen, [&](const TraceHit& hit, std::size_t pixel) {
        const glm::dvec3 origin = offset_origin(hit);
        std::uint32_t open = 0;
        for (std::uint32_t s = 0; s < count.samples; ++s) {
            const glm::dvec2 disc = on_disc(stratified_sample(count.seed, pixel, s, count.samples));
            const bool stopped = tracer.is_stopped({.origin_m = origin,
                                                    .direction = around_normal(hit.geometric_normal, disc),
                                                    .t_max = radius_m,
                                                    .faces = TraceFaces::all});
            open += stopped ? 0 : 1;
        }
        return static_cast<double>(open) / count.samples;
    });
}

}  // namespace rambla::assets
