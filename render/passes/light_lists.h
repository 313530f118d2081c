#pragma once

#include <vector>

#include "render/gl/program.h"
#include "render/pass_context.h"
#include "render/passes/light_bins.h"

namespace rambla::render {

/// Finds which local lights reach which part of the picture, in the form that the frame's lighting asks for:
/// bounds (`volumes`), lists by cell (`clustered`, forward shading and blending), or lists by tile, which a
/// compute pass narrows to the depths that a tile shows (`tiled`). What nobody asks for is not made.
class LightListsPass {
public:
    explicit LightListsPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    void make_cells(FrameResources& resources);
    void add_tiles(RenderGraph& graph, FrameResources& resources);
    [[nodiscard]] gl::BufferRange upload_cells(gl::StreamBuffer& stream, const LightBins& bins);

    gl::ProgramRegistry& programs_;
    const gl::Program* sort_tiles_ = nullptr;
    std::vector<BoundedLight> bounded_;
    std::vector<shared::LightDepths> depths_;
    LightBinner cells_;
    LightBinner tiles_;
};

}  // namespace rambla::render
