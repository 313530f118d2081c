#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "game/study/in_turns.h"

namespace rambla::game::study {

/// Median milliseconds of each pass over the rounds, 0 in rounds without it, in the order of first
/// appearance; then of what no pass accounts for, of the whole picture, and of the render thread's work for
/// it.
using PassMs = std::vector<std::pair<std::string, double>>;

[[nodiscard]] PassMs pass_ms(const PictureCost& cost);

/// Of the pass of this name: "12.34", or a dash where there is none.
[[nodiscard]] std::string ms_text(const PassMs& passes, std::string_view name);

/// Milliseconds, share of the picture, bytes written and memory held of each pass of a cost's rounds.
[[nodiscard]] Table cost_table(std::string title, const PictureCost& cost);

}  // namespace rambla::game::study
