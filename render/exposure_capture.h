#pragma once

#include "render/gl/buffer.h"
#include "render/graph/graph.h"
#include "systems/feedback.h"

namespace rambla::render {

/// What exposure has seen and done, on its way from the GPU: like Capture, a copy that is read when the
/// frame's fence has passed.
class ExposureCapture {
public:
    /// Adds the pass that copies a shared::AdaptedExposure. Without one gives its memory back. The object
    /// must stay where it is until the graph has run.
    void add(RenderGraph& graph, BufferHandle adapted_exposure);

    /// True from add() to take().
    [[nodiscard]] bool pending() const { return pending_; }
    [[nodiscard]] systems::ExposureFeedback take();

private:
    gl::Buffer buffer_;
    bool pending_ = false;
};

}  // namespace rambla::render
