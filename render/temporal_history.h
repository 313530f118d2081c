#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "render/motion_history.h"
#include "render/settings.h"
#include "render/shaders/shared/temporal.h"
#include "systems/frame.h"

namespace rambla::render {

/// How a picture follows from the one before it: what temporal anti-aliasing needs to find a pixel again.
struct TemporalFrame {
    systems::FrameView view;    ///< as it is drawn, shifted by the jitter
    glm::vec2 jitter_px{0.0f};  ///< to the right and upwards
    /// The picture before shows the same place a moment ago; else what is kept of it is of no use.
    bool has_past = false;
    bool camera_moved = false;  ///< or turned, or its projection changed
    /// Of a pixel's (x, y, depth, 1), clip space of `view`, to where the picture before, without its jitter,
    /// had what is seen there if that is at rest. For points at infinity, too: depth 0.
    glm::mat4 past_from_present{1.0f};
    glm::mat4 past_clip_from_world{1.0f};  ///< without jitter, of points relative to the eye as it was
    float exposure_ratio = 1.0f;           ///< pre-exposure now over that of the picture before
    const MovedThings* moved = nullptr;    ///< never null
};

/// A cut: the eye is farther away than this from where it was, or the camera has turned by more than
/// k_cut_angle_rad; time runs backwards, or more than k_cut_s have passed; perspective gives way to a
/// parallel view or the other way about.
inline constexpr double k_cut_m = 8.0;
inline constexpr float k_cut_angle_rad = 0.8f;
inline constexpr double k_cut_s = 1.0;

/// The same as shaders read it.
[[nodiscard]] shared::TemporalConstants make_temporal_constants(const TemporalFrame& frame,
                                                                const AntiAliasingParameters& parameters);

/// Whether such settings need what this keeps. Debug views show one picture as it is, without jitter.
[[nodiscard]] bool is_temporal(const Settings& settings);

/// Follows the camera and the things of one Frame after the other.
class TemporalHistory {
public:
    /// @param exposure   pre-exposure of this Frame, > 0
    /// @param continues  the Frame shows the scene of the last one
    /// @return           valid until the next call
    [[nodiscard]] const TemporalFrame& follow(const systems::Frame& frame, float exposure, bool continues);

private:
    struct Past {
        systems::FrameView view;
        double time_s = 0.0;
        float exposure = 1.0f;
    };
    [[nodiscard]] bool is_cut(const systems::Frame& frame) const;

    std::optional<Past> past_;
    std::uint32_t pictures_ = 0;  ///< since the last cut
    MotionHistory things_;
    TemporalFrame frame_;
};

}  // namespace rambla::render
