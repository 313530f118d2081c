#pragma once

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Sky, sun and haze in the pixels of `scene_colour` that show no geometry.
class SkyPass {
public:
    explicit SkyPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    const gl::Program& program_;
};

}  // namespace rambla::render
