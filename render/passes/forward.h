#pragma once

#include "render/pass_context.h"
#include "render/passes/forward_programs.h"

namespace rambla::render {

/// The lighting path `forward`: opaque surfaces are lit as they are drawn, with the lists of lights of the
/// screen's cells. Makes `depth` (unless a pre-pass did) and `scene_colour`, which is left undefined where
/// nothing is seen. There is no G-buffer.
class ForwardPass {
public:
    explicit ForwardPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    ForwardPrograms programs_;
};

}  // namespace rambla::render
