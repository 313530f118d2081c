#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Makes `scene_colour` the mean of this picture and earlier ones, each of which samples another place within
/// the pixels: what was seen in a pixel is found where it was by the motion of camera and things, and
/// forgotten where something hid it, or where its colour is none of those around it now (Karis 2014,
/// "High-quality temporal supersampling"). Keeps the last picture's mean; without this method it keeps
/// nothing.
class TemporalAntiAliasingPass {
public:
    explicit TemporalAntiAliasingPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(bool reproject, bool motion, bool clamp);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
    std::array<gl::Texture, 2> histories_;  ///< one is read, the other one written
    std::size_t latest_ = 0;
};

}  // namespace rambla::render
