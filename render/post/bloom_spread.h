#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "render/gl/program.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"
#include "render/post/bloom_kernel.h"

namespace rambla::render {

/// Programs of bloom.
enum class BloomProgram : std::uint8_t {
    find,             ///< lists tiles in which something is bright
    bright,           ///< bright light in fewer texels
    bright_weighted,  ///< the same with weights against lone bright pixels
    visible,          ///< lists tiles on which glow is seen
    add,              ///< adds glow to the picture
    reduce,           ///< half the size
    gaussian,         ///< one axis of a blur
    gaussian_onto,    ///< one axis of a blur, onto a coarser level
    thirteen_taps,    ///< one axis of the blur of `iterated`
    kawase,           ///< four corners
    dual_down,        ///< half the size
    dual_up,          ///< twice the size, onto the finer level
    share,            ///< a part of a light
    share_onto        ///< a part of a light, added to another
};
inline constexpr std::size_t k_bloom_programs = 14;

/// What bloom keeps from frame to frame. Each is made when it is first asked for.
class BloomTools {
public:
    explicit BloomTools(gl::ProgramRegistry& programs) : registry_{programs} {}

    [[nodiscard]] const gl::Program& program(BloomProgram which);
    [[nodiscard]] const gl::VertexArray& no_vertices();

private:
    gl::ProgramRegistry& registry_;
    std::array<const gl::Program*, k_bloom_programs> programs_{};
    std::optional<gl::VertexArray> no_vertices_;
};

/// Light in texels of some number of pixels.
struct BloomLight {
    TextureHandle texture{};  ///< GL_RGBA16F
    glm::uvec2 size{0};       ///< texels, so many that they cover the picture
};

/// The steps that spread one frame's bright light. Nothing is drawn where nothing is bright.
class BloomSteps {
public:
    /// @param draws  heads with indirect draws, as shared/bloom.h lists them
    BloomSteps(RenderGraph& graph, FrameResources& resources, BloomTools& tools, BufferHandle draws)
        : graph_{graph}, resources_{resources}, tools_{tools}, draws_{draws} {}

    /// One step: what `which` makes of a light, and of another one if it takes two.
    /// @param name  of the pass: a literal
    /// @param size  of what is made, texels
    [[nodiscard]] BloomLight step(const char* name, BloomProgram which, glm::uvec2 size, BloomLight source,
                                  const shared::BloomStep& constants = {}, BloomLight other = {});

private:
    RenderGraph& graph_;
    FrameResources& resources_;
    BloomTools& tools_;
    BufferHandle draws_;
};

/// Half as many texels along each edge, rounded up, so that the texels of all levels begin at the same
/// corner.
[[nodiscard]] constexpr glm::uvec2 half_of(glm::uvec2 size) {
    return (size + 1u) / 2u;
}

/// A kernel for the shaders. @param axis  (1, 0) or (0, 1)
[[nodiscard]] shared::BloomStep blur_step(const BlurKernel& kernel, glm::vec2 axis);

/// Four levels, each blurred with a standard deviation of 3 of its texels, and added up from the coarsest.
[[nodiscard]] BloomLight spread_by_pyramid(BloomSteps& steps, BloomLight bright);

/// A Gaussian of 13 texels, again and again at half the picture's size: as wide as the square root of the
/// number of passes, 4 pixels for one, which is far from 24 and more.
[[nodiscard]] BloomLight spread_by_iteration(BloomSteps& steps, BloomLight bright, int passes);

/// Shares of levels or passes, found anew when their number changes.
struct BloomShares {
    std::array<double, 32> of{};
    std::size_t count = 0;
};

/// Four corners at growing distances; the passes' lights are added up in fitted shares.
[[nodiscard]] BloomLight spread_by_kawase(BloomSteps& steps, BloomLight bright, int passes,
                                          BloomShares& shares);

/// The dual filter down to 1/256 and up again, which adds the levels in fitted shares.
[[nodiscard]] BloomLight spread_by_dual_filter(BloomSteps& steps, BloomLight bright, BloomShares& shares);

}  // namespace rambla::render
