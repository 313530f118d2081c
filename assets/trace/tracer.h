#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "assets/trace/ray.h"
#include "assets/trace/scene.h"

namespace rambla::assets {

/// Traces rays through a scene: what pictures and shadows are measured against. Embree finds triangles in
/// single precision; whether and where a ray meets one is then decided in double. So distances, positions and
/// normals are exact, culling and masks are those of the renderer (see scene.h), and surfaces count in their
/// exact order. What single precision leaves: a ray that passes within about 2⁻²⁰ of its length (more for
/// maps that squeeze, up to 2⁻¹⁶) of a triangle's edge may count as meeting it or not; edges between
/// triangles of a mesh let nothing through.
///
/// All queries are safe from any number of threads. Their results depend on scene and ray alone, and the
/// caller's floating-point modes stay as they are.
class Tracer {
public:
    /// Builds what is needed to search; takes all threads of oneTBB.
    /// @param scene  its columns must outlive this
    /// @throws std::invalid_argument  if something refers to what is not there: see PlacedScene
    /// @throws std::runtime_error     if Embree fails, with what it says
    explicit Tracer(TraceScene scene);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// The nearest hit; of hits at exactly the same distance that of the first instance and triangle. Rays
    /// whose origin or direction is not finite, or whose direction is 0, hit nothing.
    /// @param spread  of rays that are pixels of a picture: masks are then read as filtered as a renderer
    /// would
    [[nodiscard]] std::optional<TraceHit> first_hit(const TraceRay& ray,
                                                    const RaySpread* spread = nullptr) const;

    /// Whether there is any hit; masks are read from their finest level.
    [[nodiscard]] bool is_stopped(const TraceRay& ray) const;

    [[nodiscard]] const TraceScene& scene() const;
    /// What Embree keeps for the search, its copy of positions and indices included.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::assets
