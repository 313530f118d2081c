#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Scene colour to the display's sRGB bytes. Makes `display` for anti-aliasing, with luma in alpha; without
/// anti-aliasing it draws the `backbuffer` itself.
class TonemapPass {
public:
    explicit TonemapPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(ToneCurve curve);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_tone_curves.size()> variants_{};
};

}  // namespace rambla::render
