#pragma once

#include <cstring>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/capture.h"
#include "render/gl/context.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/pass_context.h"
#include "render/post/exposure.h"
#include "render/post/luminance.h"
#include "render/post/tonemap.h"
#include "render/shader_source.h"
#include "render/shaders/shared/adapted_exposure.h"

namespace rambla::tests {

/// Scene light of a picture, and its size.
struct Light {
    glm::uvec2 size{1};
    std::vector<glm::vec3> texels;  ///< row-major, lowest row first

    Light(glm::uvec2 of, glm::vec3 all) : size{of}, texels(std::size_t{of.x} * of.y, all) {}
};

/// What became of a picture.
struct Shown {
    std::optional<render::shared::AdaptedExposure> exposure;  ///< none: nothing made it
    std::vector<std::byte> bytes;                             ///< RGBA, as Light
    std::vector<std::string> passes;

    [[nodiscard]] glm::ivec3 display(std::size_t texel) const {
        const auto byte = [&](std::size_t channel) {
            return std::to_integer<int>(bytes[4 * texel + channel]);
        };
        return {byte(0), byte(1), byte(2)};
    }
};

/// Runs the passes from scene colour to display over given light.
class DisplayHarness {
public:
    DisplayHarness() {
        settings.exposure.mode = render::ExposureMode::automatic;
        settings.anti_aliasing.method = render::AntiAliasing::none;
        settings.tone.dither = false;
    }

    render::Settings settings;
    bool cut = false;

    /// The next frame. @param format  of scene colour
    Shown show(const Light& light, double time_s = 0.0, GLenum format = GL_RGBA32F) {
        const render::gl::Texture scene_colour = upload(light, format);
        const render::gl::Texture backbuffer{"backbuffer", {.format = GL_RGBA8, .size = light.size}};
        systems::Frame frame;
        frame.time_s = time_s;
        frame.view.size_px = light.size;
        // Without a surface there is nothing to draw into until something is bound, and Mesa says so of
        // dispatches.
        render::gl::FramebufferDesc target;
        target.colours[0] = {.texture = backbuffer.name()};
        const render::gl::Framebuffer framebuffer{"display harness", target};
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        graph_.begin_frame();
        stream_.begin_frame();
        render::FrameResources resources{.frame = frame,
                                         .view = frame.view,
                                         .settings = settings,
                                         .scene = scene_,
                                         .samplers = samplers_,
                                         .stream = stream_,
                                         .opaque = nothing_,
                                         .blended = nothing_,
                                         .counts = counts_,
                                         .cut = cut};
        resources.scene_colour = graph_.import_texture("scene colour", scene_colour, true);
        resources.backbuffer = graph_.import_texture("backbuffer", backbuffer, true);
        luminance_.add(graph_, resources);
        exposure_.add(graph_, resources);
        tonemap_.add(graph_, resources);
        Shown shown;
        if (resources.adapted_exposure.valid()) read_exposure(resources, shown.exposure.emplace());
        graph_.execute();
        stream_.end_frame();
        shown.bytes.resize(4 * light.texels.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(backbuffer.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(shown.bytes.size()), shown.bytes.data());
        for (const render::PassCost& pass : graph_.take_cost().passes)
            shown.passes.emplace_back(pass.name);
        context_.check_errors();
        return shown;
    }

    [[nodiscard]] std::size_t programs() const { return programs_.list().size(); }

private:
    static render::gl::Texture upload(const Light& light, GLenum format) {
        render::gl::Texture texture{"scene colour", {.format = format, .size = light.size}};
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(texture.name(), 0, 0, 0, static_cast<GLsizei>(light.size.x),
                            static_cast<GLsizei>(light.size.y), GL_RGB, GL_FLOAT, light.texels.data());
        return texture;
    }

    void read_exposure(const render::FrameResources& resources, render::shared::AdaptedExposure& to) {
        const render::BufferHandle from = resources.adapted_exposure;
        graph_.add_pass(
            "read exposure",
            [&](render::PassBuilder& pass) {
                pass.read(from, render::graph::Use::transfer);
                pass.side_effect();
            },
            [from, &to](render::PassContext& context) {
                glGetNamedBufferSubData(context.buffer(from), 0, sizeof(to), &to);
            });
    }

    render::gl::Context context_{{}, true};
    render::gl::ProgramRegistry programs_{render::embedded_shader};
    render::SceneStore scene_;
    render::PassSamplers samplers_{.nearest = render::gl::Sampler{"nearest", {}},
                                   .linear = render::gl::Sampler{"linear", {}},
                                   .depth_compare = render::gl::Sampler{"depth compare", {}}};
    render::gl::StreamBuffer stream_{"stream", std::size_t{1} << 16};
    render::DrawList nothing_;
    render::DrawCounts counts_;
    render::LuminancePass luminance_{programs_};
    render::ExposurePass exposure_{programs_};
    render::TonemapPass tonemap_{programs_};
    render::RenderGraph graph_;
};

}  // namespace rambla::tests
