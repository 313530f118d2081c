#pragma once

#include <array>

#include "render/draw.h"
#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// By how many pixels things have moved since the picture before, apart from the camera: those that did are
/// drawn once more, against the depth that they have left. Only with temporal anti-aliasing, and only where
/// something in view has moved; what is blended has no motion.
class MotionVectorsPass {
public:
    explicit MotionVectorsPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool masked, bool skinned, bool morphed);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
    DrawList moved_;
};

}  // namespace rambla::render
