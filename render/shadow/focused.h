#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/draw.h"
#include "render/gl/program.h"
#include "render/pass_context.h"
#include "render/shadow/fit.h"

namespace rambla::render {

/// The sun's shadow map, fitted anew each frame to what the camera sees (shadow/fit.h). Makes `shadow_map`
/// and `sun_shadow`; neither where no shadow can fall: no sun, shadows off, nothing seen or nothing to throw
/// one.
class FocusedShadowPass {
public:
    explicit FocusedShadowPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool masked, bool skinned, bool morphed);
    void cull_casters(const systems::CasterColumns& casters, const shadow::SunFit& fit);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
    DrawList casters_;
    std::vector<std::uint32_t> visible_;  ///< masks of the culling sweep
    std::vector<std::uint32_t> rows_;
};

}  // namespace rambla::render
