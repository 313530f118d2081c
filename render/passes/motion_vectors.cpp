#include "render/passes/motion_vectors.h"

#include "assets/material.h"
#include "render/passes/depth_prepass.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

/// As motion.glsl has it.
constexpr float k_at_rest = 60000.0f;

}  // namespace

const gl::Program& MotionVectorsPass::program(bool masked, bool skinned, bool morphed) {
    const std::size_t index = (masked ? 1u : 0u) | (skinned ? 2u : 0u) | (morphed ? 4u : 0u);
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = masked ? "motion vectors, masked" : "motion vectors",
                                           .vertex = "mesh.vert.glsl",
                                           .fragment = "motion_vectors.frag.glsl",
                                           .compute = {},
                                           .defines = {{"MOTION", "1"},
                                                       {"ALPHA_MASK", masked ? "1" : "0"},
                                                       {"DETAIL", "0"},
                                                       {"EMISSION", "0"},
                                                       {"SPECULAR", "0"},
                                                       {"TRANSMISSION", "0"},
                                                       {"LIGHT_MAP", "0"},
                                                       {"SKINNED", skinned ? "1" : "0"},
                                                       {"MORPHED", morphed ? "1" : "0"}}});
    }
    return *variants_[index];
}

void MotionVectorsPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.temporal == nullptr || resources.temporal->moved->batches.empty()) return;
    moved_.clear(DrawKind::shaded);
    moved_.add(resources.scene, resources.temporal->moved->batches);
    moved_.upload(resources.stream);
    graph.add_pass(
        "motion vectors",
        [&](PassBuilder& pass) {
            pass.test_depth(resources.solid_depth);
            // Half floats know motions of up to 256 pixels to a sixteenth of one.
            const TextureHandle target =
                pass.create_texture("motion", {.format = GL_RG16F, .size = resources.size_px()});
            resources.motion = pass.write_colour(0, target, LoadOp::clear, glm::vec4{k_at_rest});
        },
        [this, &resources](PassContext&) {
            resources.temporal_constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            enable_depth(true);
            resources.counts += moved_.draw(
                resources.scene, [this](systems::Pipeline pipeline, std::uint32_t) -> const gl::Program& {
                    return program(pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                                   pipeline.skinned, pipeline.morphed);
                });
        });
}

}  // namespace rambla::render
