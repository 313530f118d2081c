#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Sun, sky and emission on the G-buffer's surfaces. Makes `scene_colour`, which is left undefined where
/// nothing is seen: the sky pass fills exactly those pixels.
class LightingPass {
public:
    explicit LightingPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool shadowed, bool emissive);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 4> variants_{};
};

}  // namespace rambla::render
