#include "render/post/exposure.h"

#include "render/post/adaptation.h"
#include "render/post/luminance.h"
#include "render/shaders/shared/adapted_exposure.h"
#include "render/shaders/shared/bindings.h"

namespace rambla::render {

const gl::Program& ExposurePass::program(const Variant& v) {
    const gl::Program*& program =
        variants_[(v.sums_in_buffer ? 1u : 0u) | (v.estimate ? 2u : 0u) | (v.adapt ? 4u : 0u)];
    if (program == nullptr) {
        program = &programs_.get({.name = "exposure",
                                  .vertex = {},
                                  .fragment = {},
                                  .compute = "exposure.comp.glsl",
                                  .defines = {{"SUMS_IN_BUFFER", v.sums_in_buffer ? "1" : "0"},
                                              {"ESTIMATE", v.estimate ? "1" : "0"},
                                              {"ADAPT", v.adapt ? "1" : "0"}}});
    }
    return *program;
}

gl::BufferRange ExposurePass::upload_step(FrameResources& resources, glm::uvec2 size_px) {
    const ExposureParameters& parameters = resources.settings.exposure;
    const double now_s = resources.frame.time_s;
    const bool follows = last_time_s_.has_value() && !resources.cut;
    const FollowedShares shares =
        follows ? followed_shares(now_s - *last_time_s_, parameters) : FollowedShares{1.0, 1.0};
    last_time_s_ = now_s;
    const float pixels = static_cast<float>(size_px.x) * static_cast<float>(size_px.y);
    const bool means = resources.luminance.means;
    return resources.stream.upload_value(shared::ExposureStep{
        .follows = {shares.up, shares.down, parameters.key, parameters.strength},
        .bounds = {parameters.range_ev, parameters.delta, means ? 1.0f : pixels, means ? pixels : 1.0f},
        .curve = {resources.settings.tone.white, 0.0f, 0.0f, 0.0f}});
}

void ExposurePass::add(RenderGraph& graph, FrameResources& resources) {
    if (!resources.luminance.valid()) {
        state_ = {};
        last_time_s_.reset();
        return;
    }
    if (!state_) {
        const shared::AdaptedExposure none{};
        state_ = gl::Buffer{"adapted exposure", sizeof(none), &none};
    }
    const LuminanceSums sums = resources.luminance;
    const Variant variant{.sums_in_buffer = sums.buffer.valid(),
                          .estimate = estimates_curve(resources.settings.tone),
                          .adapt = resources.settings.exposure.mode == ExposureMode::automatic};
    const gl::BufferRange step = upload_step(resources, graph.desc(resources.scene_colour).size);
    graph.add_pass(
        "exposure",
        [&](PassBuilder& pass) {
            if (sums.buffer.valid()) pass.read(sums.buffer, graph::Use::storage);
            if (sums.texture.valid()) pass.read(sums.texture);
            if (sums.histogram.valid()) pass.read(sums.histogram, graph::Use::storage);
            resources.adapted_exposure =
                pass.write_storage(graph.import_buffer("adapted exposure", state_, true));
        },
        [&resources, &find = program(variant), sums, step](PassContext& context) {
            const auto bind = [&](GLuint index, BufferHandle buffer) {
                if (buffer.valid())
                    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE + index,
                                     context.buffer(buffer));
            };
            bind(0, resources.adapted_exposure);
            bind(1, sums.buffer);
            bind(2, sums.histogram);
            if (sums.texture.valid())
                context.bind_texture(UNIT_PASS, sums.texture, resources.samplers.nearest);
            step.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the frame before has written what is read here
            find.use();
            glDispatchCompute(1, 1, 1);
        });
}

}  // namespace rambla::render
