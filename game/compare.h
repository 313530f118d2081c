#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "game/options.h"
#include "game/stage.h"

namespace rambla::game {

/// What was measured of a scene for comparison with other engines, once per counted frame.
struct CompareMeasures {
    std::string scene;
    glm::uvec2 size_px{0};
    std::uint32_t frames = 0;             ///< drawn
    std::vector<double> frame_ms{};       ///< from the step's begin until the picture is complete
    std::vector<double> update_ms{};      ///< of that, simulating one step
    std::vector<double> look_ms{};        ///< of that, culling and packing
    std::vector<std::string> features{};  ///< that were on
};

inline constexpr std::uint32_t k_compare_frames = 100;
inline constexpr glm::uvec2 k_compare_size_px{1280, 720};

/// Frames at the beginning that are drawn and not counted: a fifth, 20 of 100.
[[nodiscard]] constexpr std::uint32_t uncounted(std::uint32_t frames) {
    return frames / 5;
}

/// What a comparison forces on: a shadow map of 2048² texels with PCF that covers the scene, and bloom
/// and FXAA, but for scenes that are compared without post effects. Exposure is fixed. What else the user has
/// chosen stays.
[[nodiscard]] render::Settings compare_settings(render::Settings settings, std::string_view scene);

/// Draws `frames` frames without a window, each complete before the next begins, one simulation step and one
/// sixtieth of a second of the walk each. Nothing is read back or written.
[[nodiscard]] CompareMeasures run_compare(Stage& stage, const Options& options, std::uint32_t frames);

[[nodiscard]] std::string compare_text(const CompareMeasures& measures);
[[nodiscard]] nlohmann::json compare_json(const CompareMeasures& measures);

}  // namespace rambla::game
