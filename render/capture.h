#pragma once

#include <glm/glm.hpp>

#include "assets/image.h"
#include "render/gl/buffer.h"
#include "render/graph/graph.h"

namespace rambla::render {

/// Pixels on their way from the GPU: copied into a buffer by a pass of the graph, read when the frame's fence
/// has passed, so that nobody waits. Keeps its buffer for the next capture of the same size.
class Capture {
public:
    /// Adds the pass that copies `texture` as four channels of `format`; linear ones (rgba32f) are scaled on
    /// arrival. The object must stay where it is until the graph has run.
    void add(RenderGraph& graph, const char* name, TextureHandle texture, assets::PixelFormat format,
             float scale);

    /// True from add() to take().
    [[nodiscard]] bool pending() const { return pending_; }
    /// The picture, top row first, alpha 1. Waits for the GPU when it is not done yet.
    [[nodiscard]] assets::Image take();
    /// Gives the buffer back.
    void release() { buffer_ = {}; }

private:
    gl::Buffer buffer_;
    glm::uvec2 size_{0};
    assets::PixelFormat format_ = assets::PixelFormat::rgba8;
    float scale_ = 1.0f;
    bool pending_ = false;
};

}  // namespace rambla::render
