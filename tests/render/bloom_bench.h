#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "render/pass_bench.h"
#include "render/post/bloom.h"

namespace rambla::tests {

/// Sum over the pixels of what `light` has and `other` has not.
[[nodiscard]] inline double more_than(const Light& light, const Light& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < light.texels.size(); ++i)
        sum += double{light.texels[i].y} - double{other.texels[i].y};
    return sum;
}

inline void fill(Light& light, glm::uvec2 low, glm::uvec2 high, glm::vec3 value) {
    for (std::uint32_t y = low.y; y < high.y; ++y)
        for (std::uint32_t x = low.x; x < high.x; ++x)
            light.at(x, y) = value;
}

inline constexpr std::array k_methods{render::BloomMethod::pyramid, render::BloomMethod::iterated,
                                      render::BloomMethod::kawase, render::BloomMethod::dual};

[[nodiscard]] inline std::string_view name_of(render::BloomMethod method) {
    return render::k_bloom_methods[static_cast<std::size_t>(method)];
}

/// Bloom's passes alone, on scene colour that a test makes up.
class BloomBench {
    PassBench bench_;

public:
    BloomBench() {
        settings.bloom = {.intensity = 1.0f, .fireflies = false};  // exact energies
        settings.anti_aliasing.method = render::AntiAliasing::none;
    }

    render::Settings& settings = bench_.settings;

    /// Scene colour with bloom.
    /// @param format  of scene colour; floats of 32 bits keep what bloom adds to something bright
    [[nodiscard]] Light bloom(const Light& scene, GLenum format = GL_RGBA32F) {
        const render::gl::Texture texture = upload(scene, format);
        systems::Frame frame;
        frame.view.size_px = scene.size;
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_SAMPLES_PASSED, query);
        bench_.run(frame, false, [&](render::RenderGraph& graph, render::FrameResources& resources) {
            resources.scene_colour = graph.import_texture("scene colour", texture, true);
            pass_.add(graph, resources);
        });
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &fragments_);
        glDeleteQueries(1, &query);
        Light result{scene.size};
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(texture.name(), 0, GL_RGB, GL_FLOAT,
                          static_cast<GLsizei>(result.texels.size() * sizeof(glm::vec3)),
                          result.texels.data());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);  // the bound one loses its texture
        bench_.check_errors();
        return result;
    }

    /// Pixels and texels that the last bloom() drew.
    [[nodiscard]] GLuint64 fragments() const { return fragments_; }

private:
    render::BloomPass pass_{bench_.programs()};
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
