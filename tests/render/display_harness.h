#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/capture.h"
#include "render/gl/framebuffer.h"
#include "render/pass_bench.h"
#include "render/post/exposure.h"
#include "render/post/luminance.h"
#include "render/post/tonemap.h"
#include "render/shaders/shared/adapted_exposure.h"

namespace rambla::tests {

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
    PassBench bench_;

public:
    DisplayHarness() {
        settings.exposure.mode = render::ExposureMode::automatic;
        settings.anti_aliasing.method = render::AntiAliasing::none;
        settings.tone.dither = false;
    }

    render::Settings& settings = bench_.settings;
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
        Shown shown;
        bench_.run(frame, cut, [&](render::RenderGraph& graph, render::FrameResources& resources) {
            resources.scene_colour = graph.import_texture("scene colour", scene_colour, true);
            resources.backbuffer = graph.import_texture("backbuffer", backbuffer, true);
            luminance_.add(graph, resources);
            exposure_.add(graph, resources);
            tonemap_.add(graph, resources);
            if (resources.adapted_exposure.valid()) read_exposure(resources, shown.exposure.emplace());
        });
        shown.bytes.resize(4 * light.texels.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(backbuffer.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(shown.bytes.size()), shown.bytes.data());
        for (const render::PassCost& pass : bench_.graph().take_cost().passes)
            shown.passes.emplace_back(pass.name);
        bench_.check_errors();
        return shown;
    }

    [[nodiscard]] std::size_t programs() const { return bench_.program_count(); }

private:
    void read_exposure(const render::FrameResources& resources, render::shared::AdaptedExposure& to) {
        const render::BufferHandle from = resources.adapted_exposure;
        bench_.graph().add_pass(
            "read exposure",
            [&](render::PassBuilder& pass) {
                pass.read(from, render::graph::Use::transfer);
                pass.side_effect();
            },
            [from, &to](render::PassContext& context) {
                glGetNamedBufferSubData(context.buffer(from), 0, sizeof(to), &to);
            });
    }

    render::LuminancePass luminance_{bench_.programs()};
    render::ExposurePass exposure_{bench_.programs()};
    render::TonemapPass tonemap_{bench_.programs()};
};

}  // namespace rambla::tests
