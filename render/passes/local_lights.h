#pragma once

#include <vector>

#include "render/gl/program.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"
#include "render/shaders/shared/light_rectangle.h"

namespace rambla::render {

/// Adds the Frame's point and spot lights to `scene_colour`: one quad per light over its rectangle on the
/// screen. Without lights that reach the screen there is no pass.
class LocalLightsPass {
public:
    explicit LocalLightsPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    const gl::Program& program_;
    gl::VertexArray no_vertices_;
    std::vector<shared::LightRectangle> rectangles_;
};

}  // namespace rambla::render
