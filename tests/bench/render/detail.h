#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/render_thread.h"
#include "render/settings.h"

namespace rambla::bench {

/// What a grade of surface detail cost in the street at noon, and how far its pictures are from those of the
/// reference, which meets heights at 128 places. One value per round; all grades have the same pictures.
struct DetailCost {
    std::string name;
    render::DetailParameters detail;
    std::vector<double> surfaces_ms;  ///< the pass that samples it
    std::vector<double> frame_ms;     ///< first command to last
    std::vector<double> rms_error;    ///< of the display's values, [0, 1]
    std::vector<double> differing;    ///< share of the pixels that differ by more than 4/255 in a channel
};

[[nodiscard]] std::vector<DetailCost> measure_detail(render::RenderThread& thread, glm::uvec2 size_px,
                                                     std::uint32_t rounds);

/// A line for each grade, medians.
[[nodiscard]] std::string to_text(const std::vector<DetailCost>& costs, glm::uvec2 size_px);
[[nodiscard]] nlohmann::json to_json(const DetailCost& cost, glm::uvec2 size_px);

}  // namespace rambla::bench
