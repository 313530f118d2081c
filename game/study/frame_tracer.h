#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assets/processed.h"
#include "assets/scene.h"
#include "assets/trace/picture.h"
#include "assets/trace/tracer.h"
#include "systems/frame.h"

namespace rambla::game::study {

/// What a Frame draws, to be traced: the same instances at the same camera-relative places, moved by the same
/// joints and morph terms, cut out by the same masks.
///
/// Rays of sight meet Frame::opaque; rays of light Frame::casters, whether the camera sees them or not; rays
/// of both kinds (mirrors, ambient occlusion) meet either. What the Frame leaves out – behind the camera, out
/// of the sun's reach – is not there. Frame::blended is left out too: glass, haze and what fades is not seen,
/// though what fades may throw a shadow. So are lines and points.
class FrameTracer {
public:
    /// @param scene      that the Frame's world shows; where `processed` has only small levels of a mask, its
    ///                   picture is processed anew, without compression
    /// @param processed  what was made of it for the renderer; must outlive this, which the others need not
    /// @throws std::runtime_error  if Embree fails
    FrameTracer(const systems::Frame& frame, const assets::Scene& scene,
                const assets::ProcessedScene& processed);
    ~FrameTracer();
    FrameTracer(const FrameTracer&) = delete;
    FrameTracer& operator=(const FrameTracer&) = delete;

    /// TraceHit::object is Instance::object, TraceHit::instance counts over tracer().scene(), whose instances
    /// are first those of Frame::opaque, in its order, then further casters.
    [[nodiscard]] const assets::Tracer& tracer() const { return *tracer_; }
    /// The Frame's view.
    [[nodiscard]] const assets::TraceCamera& camera() const { return camera_; }

private:
    struct Meshes;

    std::unique_ptr<const Meshes> deformed_;
    std::unique_ptr<const assets::Tracer> tracer_;
    assets::TraceCamera camera_;
};

/// Of each pixel, top row first, TraceHit::object: assets::k_none where nothing is.
[[nodiscard]] std::vector<std::uint32_t> object_ids(const assets::HitPicture& picture);

}  // namespace rambla::game::study
