#pragma once

#include <glm/glm.hpp>

#include "assets/image.h"
#include "render/gl/buffer.h"
#include "render/graph/graph.h"
#include "render/render_thread.h"

namespace rambla::render {

/// What pixels are read as.
enum class CapturedAs : std::uint8_t {
    bytes,   ///< assets::PixelFormat::rgba8
    floats,  ///< assets::PixelFormat::rgba32f
    objects  ///< of FrameResources::objects
};

/// Pixels on their way from the GPU: copied into a buffer by a pass of the graph, read when the frame's fence
/// has passed, so that nobody waits. Keeps its buffer for the next capture of the same size.
class Capture {
public:
    /// Adds the pass that copies `texture`; floats are scaled on arrival. The object must stay where it is
    /// until the graph has run.
    void add(RenderGraph& graph, const char* name, TextureHandle texture, CapturedAs what,
             float scale = 1.0f);

    /// True from add() to take…().
    [[nodiscard]] bool pending() const { return pending_; }
    /// The picture, top row first, alpha 1. Waits for the GPU when it is not done yet.
    [[nodiscard]] assets::Image take();
    /// The same of objects.
    [[nodiscard]] ObjectImage take_objects();
    /// Gives the buffer back.
    void release() { buffer_ = {}; }

private:
    void copy_rows(std::byte* to);

    gl::Buffer buffer_;
    glm::uvec2 size_{0};
    CapturedAs what_ = CapturedAs::bytes;
    float scale_ = 1.0f;
    bool pending_ = false;
};

}  // namespace rambla::render
