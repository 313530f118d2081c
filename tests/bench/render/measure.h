#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/render/scene.h"
#include "render/render_thread.h"

namespace rambla::bench {

/// A way to draw that is compared with others.
struct Way {
    std::string name;
    render::Settings settings;
};

/// What a way of drawing cost, in milliseconds of the GPU's clock, one value per round. All ways have the
/// same pictures in the same rounds.
struct WayCost {
    std::string name;
    std::map<std::string, std::vector<double>> passes;  ///< by name; 0 in rounds without that pass
    std::vector<double> lighting;  ///< passes that light what is stored, with the building of lists
    std::vector<double> surfaces;  ///< from geometry to lit pixels: what deferred and forward do differently
    std::vector<double> frame;     ///< first command to last
    std::vector<double> missing;   ///< of the frame, that no pass accounts for
    std::vector<double> cpu;       ///< of the render thread, to record the passes and hand them to the driver
};

/// The ways that draw a scene with so many lights. `fullscreen` and `volumes`, whose lists are the frame's
/// own, are left out beyond 256.
[[nodiscard]] std::vector<Way> ways(std::uint32_t lights);

/// Draws one picture with each pass timed alone.
[[nodiscard]] render::FrameOutput draw(game::Stage& stage, render::RenderThread& thread,
                                       const render::Settings& settings, const systems::Eye& eye,
                                       bool captured);

/// Draws a picture each way, round after round, and each round another picture of the view; one round before
/// them does not count.
[[nodiscard]] std::vector<WayCost> measure(game::Stage& stage, render::RenderThread& thread,
                                           const std::vector<Way>& ways, View view, glm::uvec2 size_px,
                                           std::uint32_t rounds);

}  // namespace rambla::bench
