#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "render/gl/context.h"
#include "render/graph/graph.h"
#include "render/post/bloom.h"
#include "render/scene_store.h"

namespace rambla::tests {

/// Light by pixel, row-major, as a texture holds it.
struct Light {
    glm::uvec2 size{0};
    std::vector<glm::vec4> texels;

    explicit Light(glm::uvec2 size_px, glm::vec3 light = glm::vec3{0.0f})
        : size{size_px}, texels(std::size_t{size_px.x} * size_px.y, glm::vec4{light, 0.0f}) {}
    [[nodiscard]] glm::vec4& at(std::uint32_t x, std::uint32_t y) {
        return texels[std::size_t{y} * size.x + x];
    }
    [[nodiscard]] const glm::vec4& at(std::uint32_t x, std::uint32_t y) const {
        return texels[std::size_t{y} * size.x + x];
    }
    /// Sum over the pixels of what this has and `other` has not.
    [[nodiscard]] double more_than(const Light& other) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < texels.size(); ++i)
            sum += double{texels[i].y} - double{other.texels[i].y};
        return sum;
    }
};

inline void fill(Light& light, glm::uvec2 low, glm::uvec2 high, glm::vec3 value) {
    for (std::uint32_t y = low.y; y < high.y; ++y)
        for (std::uint32_t x = low.x; x < high.x; ++x)
            light.at(x, y) = glm::vec4{value, 0.0f};
}

inline constexpr std::array k_methods{render::BloomMethod::pyramid, render::BloomMethod::iterated,
                                      render::BloomMethod::kawase, render::BloomMethod::dual};

[[nodiscard]] inline std::string_view name_of(render::BloomMethod method) {
    return render::k_bloom_methods[static_cast<std::size_t>(method)];
}

/// Bloom's passes alone, on scene colour that a test makes up.
class BloomBench {
public:
    BloomBench() {
        settings.bloom = {.intensity = 1.0f, .fireflies = false};  // exact energies
        settings.anti_aliasing.method = render::AntiAliasing::none;
    }

    /// Scene colour with bloom.
    /// @param format  of scene colour; floats of 32 bits keep what bloom adds to something bright
    [[nodiscard]] Light bloom(const Light& scene, GLenum format = GL_RGBA32F) {
        const render::gl::Texture texture{"scene colour", {.format = format, .size = scene.size}};
        const auto width = static_cast<GLsizei>(scene.size.x), height = static_cast<GLsizei>(scene.size.y);
        glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, scene.texels.data());
        systems::Frame frame;
        frame.view.size_px = scene.size;
        render::DrawCounts counts;
        stream_.begin_frame();
        graph_.begin_frame();
        render::FrameResources resources{.frame = frame,
                                         .view = frame.view,
                                         .settings = settings,
                                         .scene = store_,
                                         .samplers = samplers_,
                                         .stream = stream_,
                                         .opaque = nothing_,
                                         .blended = nothing_,
                                         .counts = counts};
        resources.scene_colour = graph_.import_texture("scene colour", texture, true);
        pass_.add(graph_, resources);
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_SAMPLES_PASSED, query);
        graph_.execute();
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &fragments_);
        glDeleteQueries(1, &query);
        stream_.end_frame();
        Light result{scene.size};
        glGetTextureImage(texture.name(), 0, GL_RGBA, GL_FLOAT,
                          static_cast<GLsizei>(result.texels.size() * sizeof(glm::vec4)),
                          result.texels.data());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);  // the bound one loses its texture
        context_.check_errors();
        return result;
    }

    /// Pixels and texels that the last bloom() drew.
    [[nodiscard]] GLuint64 fragments() const { return fragments_; }

private:
    render::gl::Context context_{{}, true};

public:
    render::Settings settings;

private:
    render::gl::ProgramRegistry programs_{render::embedded_shader};
    render::SceneStore store_;
    render::gl::StreamBuffer stream_{"stream", 1 << 16};
    render::PassSamplers samplers_{
        .nearest = render::gl::Sampler{"nearest", {}},
        .linear = render::gl::Sampler{"linear", {.minify = GL_LINEAR, .magnify = GL_LINEAR}},
        .depth_compare = {}};
    render::DrawList nothing_;
    render::BloomPass pass_{programs_};
    render::RenderGraph graph_;
    GLuint64 fragments_ = 0;
};

/// Light of a box of pixels, spread along one axis of `size` pixels by a Gaussian; nothing is known beyond
/// them.
[[nodiscard]] inline std::vector<double> exact_spread_along(std::uint32_t size, std::uint32_t first,
                                                            std::uint32_t end, double sigma_px) {
    std::vector<double> light(size);
    for (std::uint32_t x = 0; x < size; ++x) {
        double inside = 0.0, box = 0.0;
        for (std::uint32_t i = 0; i < size; ++i) {
            const double off = (static_cast<double>(x) - static_cast<double>(i)) / sigma_px;
            const double weight = std::exp(-0.5 * off * off);
            inside += weight;
            if (i >= first && i < end) box += weight;
        }
        light[x] = box / inside;
    }
    return light;
}

/// A box of light, spread exactly. @param low, high  pixels: high is the first that is not in it
[[nodiscard]] inline std::vector<double> exact_spread_of_box(glm::uvec2 size, glm::uvec2 low, glm::uvec2 high,
                                                             double light) {
    std::vector<double> result(std::size_t{size.x} * size.y, 0.0);
    for (const double sigma_px : render::k_bloom_sigmas_px) {
        const std::vector<double> across = exact_spread_along(size.x, low.x, high.x, sigma_px);
        const std::vector<double> up = exact_spread_along(size.y, low.y, high.y, sigma_px);
        for (std::uint32_t y = 0; y < size.y; ++y)
            for (std::uint32_t x = 0; x < size.x; ++x)
                result[std::size_t{y} * size.x + x] +=
                    light * across[x] * up[y] / static_cast<double>(render::k_bloom_sigmas_px.size());
    }
    return result;
}

}  // namespace rambla::tests
