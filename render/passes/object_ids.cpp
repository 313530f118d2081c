#include "render/passes/object_ids.h"

#include <utility>

#include "assets/material.h"
#include "render/passes/bare_mesh.h"
#include "render/passes/depth_prepass.h"

namespace rambla::render {

const gl::Program& ObjectIdsPass::program(bool masked, bool skinned, bool morphed) {
    const std::size_t index = (masked ? 1u : 0u) | (skinned ? 2u : 0u) | (morphed ? 4u : 0u);
    if (variants_[index] == nullptr) {
        auto defines = bare_mesh_defines(skinned, morphed);
        defines.emplace_back("OBJECTS", "1");
        defines.emplace_back("ALPHA_MASK", masked ? "1" : "0");
        variants_[index] = &programs_.get({.name = masked ? "object ids, masked" : "object ids",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "object_ids.frag.glsl",
                                           .compute = {},
                                           .defines = std::move(defines)});
    }
    return *variants_[index];
}

void ObjectIdsPass::add(RenderGraph& graph, FrameResources& resources) {
    const bool shown = resources.settings.debug.view == DebugView::objects;
    if (!resources.frame.capture.objects && !shown) return;
    graph.add_pass(
        "object ids",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.solid_depth);
            const TextureHandle target =
                pass.create_texture("objects", {.format = GL_R32UI, .size = resources.size_px()});
            resources.objects = pass.write_colour(0, target, LoadOp::clear);
        },
        [this, &resources](PassContext&) {
            enable_depth(true);
            resources.counts += resources.opaque.draw(
                resources.scene, [this](systems::Pipeline pipeline, std::uint32_t) -> const gl::Program& {
                    return program(pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                                   pipeline.skinned, pipeline.morphed);
                });
        });
}

}  // namespace rambla::render
