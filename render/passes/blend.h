#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Forward pass of transparent surfaces over the lit picture, back to front, with the lighting functions of
/// the deferred passes. Without such surfaces there is no pass.
class BlendPass {
public:
    explicit BlendPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    struct Variant {
        bool shadowed = false;
        bool wide_filter = false;
        bool detailed = false;
        bool skinned = false;
        bool morphed = false;
    };
    [[nodiscard]] const gl::Program& program(Variant variant);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 32> variants_{};
};

}  // namespace rambla::render
