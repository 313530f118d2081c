#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// What lighting reads of the G-buffer, as floats, where somebody asks for it.
class SurfaceCapturePass {
public:
    explicit SurfaceCapturePass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_gbuffer_layouts.size()> variants_{};
};

}  // namespace rambla::render
