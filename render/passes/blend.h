#pragma once

#include <array>

#include "assets/material.h"
#include "render/pass_context.h"
#include "render/passes/forward_programs.h"

namespace rambla::render {

/// Forward pass over the lit picture, back to front, with the lighting functions of the deferred passes:
/// transparent surfaces, things that fade, and balls of haze. Without any of them there is no pass.
class BlendPass {
public:
    explicit BlendPass(gl::ProgramRegistry& programs) : programs_{programs}, surfaces_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& surface_program(const FrameResources& resources,
                                                     systems::Pipeline pipeline,
                                                     const assets::Material& look);
    /// What scatters nothing need not be lit.
    [[nodiscard]] const gl::Program& haze_program(const FrameResources& resources,
                                                  const assets::Material& look);

    gl::ProgramRegistry& programs_;
    ForwardPrograms surfaces_;
    std::array<const gl::Program*, 8 * k_brdf_models.size()> haze_{};
};

}  // namespace rambla::render
