#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/render/measure.h"

namespace rambla::bench {

/// What was drawn in which ways.
struct Setting {
    View view = View::above;
    glm::uvec2 size_px{0};
    std::uint32_t lights = 0;
    std::uint32_t suns = 1;
    std::vector<WayCost> costs;
};

/// One column per way, one line per pass, medians in milliseconds; then sums, and how many times faster
/// `tiled` is than the others (medians of the rounds' ratios).
[[nodiscard]] std::string to_text(const Setting& setting);
[[nodiscard]] nlohmann::json to_json(const Setting& setting);

/// The claim that the culled path is judged by: lighting of `tiled`, with the building of its tiles, against
/// `fullscreen`, on `blocks` from above with 64 lights at 1280×720. Empty if that was not measured.
[[nodiscard]] std::string verdict(const std::vector<Setting>& settings);

}  // namespace rambla::bench
