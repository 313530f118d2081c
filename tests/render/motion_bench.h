#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/capture.h"
#include "render/frame_uniforms.h"
#include "render/gl/context.h"
#include "render/passes/depth_prepass.h"
#include "render/passes/motion_vectors.h"
#include "render/shaders/shared/bindings.h"
#include "render/support.h"

namespace rambla::tests {

/// Depth and motion vectors of a stage's frames, and nothing else of a renderer.
class MotionBench {
public:
    explicit MotionBench(const Stage& stage) : passes_{programs_} {
        scene_.upload(*stage.process(stage.scene), nullptr);
        settings_.anti_aliasing.method = render::AntiAliasing::taa;
        settings_.lighting.prepass = true;
    }

    /// Of the pixels, from the lower left corner; nothing where the frame has no such target.
    [[nodiscard]] std::optional<std::vector<glm::vec2>> draw(Stage& stage) {
        const systems::Frame& frame = stage.packed();
        temporal_ = &history_.follow(frame, 1.0f, continues_);
        continues_ = true;
        size_ = frame.view.size_px;
        graph_.begin_frame();
        stream_.begin_frame();
        bind(frame);
        opaque_.clear(render::DrawKind::shaded);
        opaque_.add(scene_, frame.opaque);
        opaque_.upload(stream_);
        blended_.clear(render::DrawKind::blended);
        render::DrawCounts counts;
        render::FrameResources resources{
            .frame = frame,
            .view = temporal_->view,
            .settings = settings_,
            .scene = scene_,
            .samplers = samplers_,
            .stream = stream_,
            .opaque = opaque_,
            .blended = blended_,
            .counts = counts,
            .temporal = temporal_,
            .temporal_constants =
                stream_.upload_value(render::make_temporal_constants(*temporal_, settings_.anti_aliasing))};
        passes_.depth.add(graph_, resources);
        passes_.motion.add(graph_, resources);
        const bool any = resources.motion.valid();
        if (any) capture_.add(graph_, "motion", resources.motion, render::CapturedAs::floats);
        graph_.execute();
        stream_.end_frame();
        context_.check_errors();
        if (!any) return std::nullopt;
        return upside_down(capture_.take());
    }

    [[nodiscard]] const render::TemporalFrame& temporal() const { return *temporal_; }

private:
    struct Passes {
        explicit Passes(render::gl::ProgramRegistry& programs) : depth{programs}, motion{programs} {}
        render::DepthPrePass depth;
        render::MotionVectorsPass motion;
    };

    void bind(const systems::Frame& frame) {
        const render::MovedThings& moved = *temporal_->moved;
        stream_.upload_value(render::make_frame_uniforms(frame, temporal_->view, 1.0f, {}))
            .bind(GL_UNIFORM_BUFFER, BINDING_FRAME_UNIFORMS);
        using Instances = std::span<const systems::Instance>;
        stream_.upload(Instances{frame.instances}, Instances{moved.instances})
            .bind(GL_SHADER_STORAGE_BUFFER, BINDING_INSTANCES);
        stream_.upload(std::span<const systems::JointMatrix>{frame.joints}, moved.joints)
            .bind(GL_SHADER_STORAGE_BUFFER, BINDING_JOINTS);
        stream_.upload(std::span<const systems::MorphTerm>{frame.morphs}, moved.morphs)
            .bind(GL_SHADER_STORAGE_BUFFER, BINDING_MORPH_TERMS);
        scene_.materials().bind(GL_SHADER_STORAGE_BUFFER, BINDING_MATERIALS);
        scene_.morphs().bind(GL_SHADER_STORAGE_BUFFER, BINDING_MORPHS);
    }

    [[nodiscard]] std::vector<glm::vec2> upside_down(const assets::Image& image) const {
        std::vector<glm::vec4> texels(std::size_t{size_.x} * size_.y);
        std::memcpy(texels.data(), image.texels.data(), image.texels.size());
        std::vector<glm::vec2> vectors(texels.size());
        for (std::uint32_t y = 0; y < size_.y; ++y) {
            for (std::uint32_t x = 0; x < size_.x; ++x)
                vectors[std::size_t{y} * size_.x + x] =
                    glm::vec2{texels[std::size_t{size_.y - 1 - y} * size_.x + x]};
        }
        return vectors;
    }

    render::gl::Context context_{{}, true};
    render::gl::ProgramRegistry programs_{{}};
    render::SceneStore scene_;
    render::gl::StreamBuffer stream_{"stream", 1 << 16};
    render::PassSamplers samplers_;
    render::Settings settings_;
    Passes passes_;
    render::RenderGraph graph_;
    render::DrawList opaque_;
    render::DrawList blended_;
    render::Capture capture_;
    render::TemporalHistory history_;
    const render::TemporalFrame* temporal_ = nullptr;
    glm::uvec2 size_{0};
    bool continues_ = false;
};

}  // namespace rambla::tests
