#include "render/passes/depth_prepass.h"

#include "assets/material.h"
#include "render/passes/bare_mesh.h"

namespace rambla::render {

const gl::Program& DepthPrePass::program(bool masked, bool skinned, bool morphed) {
    const std::size_t index = (masked ? 1u : 0u) | (skinned ? 2u : 0u) | (morphed ? 4u : 0u);
    if (variants_[index] == nullptr) {
        // The vertices of the passes that shade, so that depths are equal to the bit.
        variants_[index] = &programs_.get({.name = masked ? "depth, masked" : "depth",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = masked ? "depth_mask.frag.glsl" : "",
                                           .compute = {},
                                           .defines = bare_mesh_defines(skinned, morphed)});
    }
    return *variants_[index];
}

void DepthPrePass::add(RenderGraph& graph, FrameResources& resources) {
    if (!resources.settings.lighting.prepass) return;
    graph.add_pass(
        "depth pre-pass", [&](PassBuilder& pass) { write_or_test_depth(pass, resources); },
        [this, &resources](PassContext&) {
            enable_depth(false);
            resources.counts += resources.opaque.draw(
                resources.scene, [this](systems::Pipeline pipeline, std::uint32_t) -> const gl::Program& {
                    return program(pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                                   pipeline.skinned, pipeline.morphed);
                });
        });
}

void write_or_test_depth(PassBuilder& pass, FrameResources& resources) {
    if (resources.depth.valid()) {
        pass.test_depth(resources.depth);
        return;
    }
    const TextureHandle depth =
        pass.create_texture("depth", {.format = GL_DEPTH_COMPONENT32F, .size = resources.size_px()});
    resources.depth = resources.solid_depth = pass.write_depth(depth, LoadOp::clear);
}

void enable_depth(bool known) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(known ? GL_EQUAL : GL_GEQUAL);
    glDepthMask(known ? GL_FALSE : GL_TRUE);
}

}  // namespace rambla::render
