#pragma once

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Smooths edges of `display` into the `backbuffer`; no pass when anti-aliasing is off.
class FxaaPass {
public:
    explicit FxaaPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    const gl::Program& program_;
};

}  // namespace rambla::render
