#pragma once

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Means of the pixels of `display` that are drawn for each one that is shown, into the `backbuffer`; no pass
/// where one is drawn for one. FrameView::samples says how many: the picture that is anti-aliased so is a
/// larger one from the first pass on.
class SupersamplingPass {
public:
    explicit SupersamplingPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    gl::ProgramRegistry& programs_;
    const gl::Program* mean_ = nullptr;  ///< made when it is first wanted
};

}  // namespace rambla::render
