#pragma once

#include "render/settings.h"
#include "render/shaders/shared/frame_uniforms.h"
#include "systems/frame.h"

namespace rambla::render {

/// What all shaders of a frame read.
/// @param view      the Frame's, as it is drawn
/// @param exposure  factor on everything written to HDR targets, > 0
[[nodiscard]] shared::FrameUniforms make_frame_uniforms(const systems::Frame& frame,
                                                        const systems::FrameView& view, float exposure,
                                                        const DetailParameters& detail);

}  // namespace rambla::render
