#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Deferred shadowing: one byte per pixel, how much of the sun reaches it, from the sun's shadow map. Makes
/// `shadow_result` where there is a map. Only pixels that show geometry are drawn.
class ShadowResultPass {
public:
    explicit ShadowResultPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(ShadowTaps taps, GBufferLayout layout);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 4> variants_{};
};

}  // namespace rambla::render
