#pragma once

#include "render/capture.h"
#include "render/exposure_capture.h"
#include "render/pass_context.h"
#include "render/render_thread.h"

namespace rambla::render {

/// What a frame asked to have back: copies that are made while it is drawn, and read when its fence has
/// passed.
class FrameCaptures {
public:
    /// Of what is between scene and display.
    void add_from_scene(RenderGraph& graph, const FrameResources& resources);
    /// Of what passes after the scene have made.
    void add_from_display(RenderGraph& graph, const FrameResources& resources);

    /// Moves what was captured into the output of the frame, whose fence has passed.
    void take(FrameOutput& output);

private:
    Capture display_;
    Capture linear_;
    Capture glowing_;
    Capture objects_;
    Capture positions_;
    Capture normals_;
    ExposureCapture exposure_;
};

}  // namespace rambla::render
