#pragma once

#include "render/pass_context.h"
#include "render/passes/forward_programs.h"

namespace rambla::render {

/// Forward pass of transparent surfaces over the lit picture, back to front, with the lighting functions of
/// the deferred passes. Without such surfaces there is no pass.
class BlendPass {
public:
    explicit BlendPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    ForwardPrograms programs_;
};

}  // namespace rambla::render
