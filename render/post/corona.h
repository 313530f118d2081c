#pragma once

#include <optional>

#include "render/gl/program.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Adds rays and a halo to scene colour about the Frame's lights that are seen, as eyes make them of lamps in
/// the dark. How much of a lamp is seen the vertex stage finds in the depths, so that nothing is queried and
/// nobody waits. No pass unless BloomParameters::corona asks for it, there are lights, and the eye is one:
/// an orthographic picture has none.
class CoronaPass {
public:
    explicit CoronaPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    gl::ProgramRegistry& programs_;
    const gl::Program* program_ = nullptr;
    std::optional<gl::VertexArray> no_vertices_;
};

}  // namespace rambla::render
