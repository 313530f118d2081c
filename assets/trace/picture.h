#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "assets/trace/camera.h"
#include "assets/trace/tracer.h"

namespace rambla::assets {

/// Whole pictures, side by side on oneTBB. Each pixel depends on its arguments alone, so that pictures are
/// the same to the bit for any number of threads.

/// A hit for each pixel, row-major, top row first. A TraceHit takes about 200 bytes.
struct HitPicture {
    glm::uvec2 size_px{0};
    std::vector<TraceHit> hits;  ///< those that do not exist() show the sky
};

/// What the centre of each pixel sees: instances that rays of sight meet, back faces culled, masks filtered
/// as a rasteriser would.
[[nodiscard]] HitPicture trace_picture(const Tracer& tracer, const TraceCamera& camera);

/// What each pixel sees in a mirror that lies in its surface: the ray of the eye, reflected at the shading
/// normal – at the geometric one where it would otherwise go into the surface. Meets all instances, back
/// faces culled. Distances are those from the mirror.
/// @param seen  of the same camera; pixels without a hit have none here either
[[nodiscard]] HitPicture trace_mirrors(const Tracer& tracer, const TraceCamera& camera,
                                       const HitPicture& seen);

/// Whether the sun shines on what each pixel sees: 1 or 0; 1 for the sky. Of single-sided things, those faces
/// throw a shadow that the sun sees, as in the renderer's maps. What faces away has none.
/// @param to_sun  of any length but 0
[[nodiscard]] std::vector<float> trace_sun(const Tracer& tracer, const HitPicture& seen, glm::dvec3 to_sun);

/// A light that has an area: rectangle or ellipse centre + a·half_u + b·half_v, |a|, |b| ≤ 1 or a² + b² ≤ 1.
struct AreaLight {
    bool disc = false;
    /// `centre` is a direction of length 1, and the halves are tangents of angles: the sun is a distant disc
    /// with halves of length tan 0.27°. Else metres.
    bool distant = false;
    glm::dvec3 centre{0.0, 1.0, 0.0};
    glm::dvec3 half_u{0.0};
    glm::dvec3 half_v{0.0};
};

struct SampleCount {
    std::uint32_t samples = 1;  ///< > 0, a pixel; best a square number, see stratified_sample()
    std::uint64_t seed = 0;
};

/// The share of an area light's area that what each pixel sees can see, each part of it counted alike; 1 for
/// the sky. Faces count as in trace_sun().
[[nodiscard]] std::vector<float> trace_area_light(const Tracer& tracer, const HitPicture& seen,
                                                  const AreaLight& light, SampleCount count);

/// Ambient occlusion of what each pixel sees: the share of the hemisphere over its geometric normal, weighted
/// by the cosine, in which nothing stands nearer than the radius: 1 in the open, also for the sky. All
/// instances, both faces of everything.
[[nodiscard]] std::vector<float> trace_ambient(const Tracer& tracer, const HitPicture& seen,
                                               SampleCount count,
                                               double radius_m = std::numeric_limits<double>::infinity());

}  // namespace rambla::assets
