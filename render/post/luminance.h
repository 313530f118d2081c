#pragma once

#include <array>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Sums ln(δ + luminance) over `scene_colour`, of which exposure makes the log-average exp(mean(ln(δ + Y)))
/// (Reinhard et al. 2002, eq. 1), and counts pixels that are no numbers: those, and what is below zero, count
/// as black. No pass unless exposure is automatic or a curve is estimated.
///
/// `chain` sums blocks of 4×4 in 32-bit floats until one is left, and `compute` squares of 64×64. `mips` and
/// `mips16` let GL make mip levels of the logarithms, in 32 and 16 bits: where a level's size is odd, what GL
/// makes of it need not count all pixels alike, or at all.
class LuminancePass {
public:
    explicit LuminancePass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    enum class Shader : std::uint8_t { first_blocks, blocks, squares, sum_of_squares, logarithm, histogram };
    static constexpr std::size_t k_shaders = 6;

    [[nodiscard]] const gl::Program& program(Shader shader);
    void add_chain(RenderGraph& graph, FrameResources& resources, const gl::BufferRange& constants);
    [[nodiscard]] TextureHandle add_step(RenderGraph& graph, const FrameResources& resources,
                                         TextureHandle source, Shader shader,
                                         const gl::BufferRange& constants);
    void add_compute(RenderGraph& graph, FrameResources& resources, const gl::BufferRange& constants);
    void add_mips(RenderGraph& graph, FrameResources& resources, const gl::BufferRange& constants);
    void add_histogram(RenderGraph& graph, FrameResources& resources, const gl::BufferRange& constants);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_shaders> variants_{};
};

/// True where something of a frame asks for the picture's luminances: not where another view is shown instead
/// of the picture.
[[nodiscard]] bool wants_luminance(const Settings& settings);
/// True where scale and white of extended Reinhard come from the picture.
[[nodiscard]] bool estimates_curve(const ToneParameters& tone);

}  // namespace rambla::render
