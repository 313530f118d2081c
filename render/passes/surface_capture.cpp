#include "render/passes/surface_capture.h"

#include "render/passes/gbuffer.h"

namespace rambla::render {

void SurfaceCapturePass::add(RenderGraph& graph, FrameResources& resources) {
    if (!resources.frame.capture.surfaces || !resources.normal.valid()) return;
    const GBufferLayout layout = resources.settings.gbuffer.layout;
    const gl::Program*& program = variants_[static_cast<std::size_t>(layout)];
    if (program == nullptr) {
        program = &programs_.get({.name = "surface capture",
                                  .vertex = "full_screen.vert.glsl",
                                  .fragment = "surface_capture.frag.glsl",
                                  .compute = {},
                                  .defines = {{"GBUFFER_WIDE", gbuffer_define(layout)}}});
    }
    graph.add_pass(
        "surface capture",
        [&](PassBuilder& pass) {
            read_geometry(pass, resources);
            const gl::TextureDesc floats{.format = GL_RGBA32F, .size = resources.size_px()};
            resources.read_positions =
                pass.write_colour(0, pass.create_texture("read positions", floats), LoadOp::discard);
            resources.read_normals =
                pass.write_colour(1, pass.create_texture("read normals", floats), LoadOp::discard);
        },
        [&resources, program](PassContext& context) {
            bind_geometry(context, resources);
            program->use();
            context.draw_full_screen();
        });
}

}  // namespace rambla::render
