#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/gl/context.h"
#include "render/gl/program.h"
#include "render/graph/graph.h"
#include "render/pass_context.h"
#include "render/shader_source.h"

namespace rambla::tests {

/// Light by pixel, row-major, lowest row first, as a texture holds it.
struct Light {
    glm::uvec2 size{0};
    std::vector<glm::vec3> texels;

    explicit Light(glm::uvec2 size_px, glm::vec3 light = glm::vec3{0.0f})
        : size{size_px}, texels(std::size_t{size_px.x} * size_px.y, light) {}
    [[nodiscard]] glm::vec3& at(std::uint32_t x, std::uint32_t y) {
        return texels[std::size_t{y} * size.x + x];
    }
    [[nodiscard]] const glm::vec3& at(std::uint32_t x, std::uint32_t y) const {
        return texels[std::size_t{y} * size.x + x];
    }
};

/// A texture that holds such light. @param format  of its texels
[[nodiscard]] inline render::gl::Texture upload(const Light& light, GLenum format) {
    render::gl::Texture texture{"scene colour", {.format = format, .size = light.size}};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, static_cast<GLsizei>(light.size.x),
                        static_cast<GLsizei>(light.size.y), GL_RGB, GL_FLOAT, light.texels.data());
    return texture;
}

/// A renderer without a scene, that runs the passes which a test gives it.
class PassBench {
public:
    render::Settings settings;

    [[nodiscard]] render::gl::ProgramRegistry& programs() { return programs_; }
    [[nodiscard]] std::size_t program_count() const { return programs_.list().size(); }
    [[nodiscard]] render::RenderGraph& graph() { return graph_; }
    void check_errors() { context_.check_errors(); }

    /// One frame. @param add  adds passes: add(graph, resources), after which they run
    template <class Add>
    void run(const systems::Frame& frame, bool cut, Add&& add) {
        graph_.begin_frame();
        stream_.begin_frame();
        render::DrawCounts counts;
        render::FrameResources resources{.frame = frame,
                                         .view = frame.view,
                                         .settings = settings,
                                         .scene = scene_,
                                         .samplers = samplers_,
                                         .stream = stream_,
                                         .opaque = nothing_,
                                         .blended = nothing_,
                                         .counts = counts,
                                         .cut = cut};
        add(graph_, resources);
        graph_.execute();
        stream_.end_frame();
    }

private:
    render::gl::Context context_{{}, true};
    render::gl::ProgramRegistry programs_{render::embedded_shader};
    render::SceneStore scene_;
    render::PassSamplers samplers_{
        .nearest = render::gl::Sampler{"nearest", {}},
        .linear = render::gl::Sampler{"linear", {.minify = GL_LINEAR, .magnify = GL_LINEAR}},
        .depth_compare = render::gl::Sampler{"depth compare", {}}};
    render::gl::StreamBuffer stream_{"stream", std::size_t{1} << 16};
    render::DrawList nothing_;
    render::RenderGraph graph_;
};

}  // namespace rambla::tests
