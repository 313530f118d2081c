#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Shows, instead of the picture, one of the things that it was made from, where the settings ask for it.
/// What the frame does not have (a forward picture has no G-buffer) is shown as grey stripes.
class DebugViewPass {
public:
    explicit DebugViewPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(DebugView view, bool missing, GBufferLayout layout);
    [[nodiscard]] const gl::Program& overdraw_program(bool skinned, bool morphed);
    [[nodiscard]] TextureHandle add_overdraw(RenderGraph& graph, FrameResources& resources);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_debug_views.size() * 4> variants_{};
    std::array<const gl::Program*, 4> overdraw_{};
};

}  // namespace rambla::render
