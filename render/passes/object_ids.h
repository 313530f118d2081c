#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Which object is seen in each pixel, where somebody asks for it: the opaque surfaces once more, against
/// the depth that they have left.
class ObjectIdsPass {
public:
    explicit ObjectIdsPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool masked, bool skinned, bool morphed);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
};

}  // namespace rambla::render
