#pragma once

#include <array>
#include <cstddef>

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Scene colour, times what exposure has adapted to, to the display's sRGB bytes. Makes `display` for
/// anti-aliasing, with luma in alpha; without anti-aliasing it draws the `backbuffer` itself.
class TonemapPass {
public:
    explicit TonemapPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    /// What is compiled in: nobody pays for what is not asked for.
    struct Variant {
        ToneCurve curve = ToneCurve::aces;
        bool on_luminance = false;
        bool adapted = false;
        bool blue_shift = false;
        bool gamma = false;
        bool dither = true;
    };
    static constexpr std::size_t k_switches = 5;

    [[nodiscard]] const gl::Program& program(const Variant& variant);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_tone_curves.size() << k_switches> variants_{};
};

}  // namespace rambla::render
