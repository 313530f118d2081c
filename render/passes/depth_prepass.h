#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Depth of all opaque surfaces before anything is shaded, where the settings ask for it: what is hidden is
/// then not shaded, at the price of drawing the geometry twice.
class DepthPrePass {
public:
    explicit DepthPrePass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool masked, bool skinned, bool morphed);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
};

/// For the set-up of a pass that draws the opaque surfaces: makes `depth`, or tests against what the pre-pass
/// made of it.
void write_or_test_depth(PassBuilder& pass, FrameResources& resources);
/// The depth test of such a pass. @param known  by a pre-pass
void enable_depth(bool known);

}  // namespace rambla::render
