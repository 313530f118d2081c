#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rambla::game {

/// The tables that people read, from what inspection() returned. Long tables are cut and say so.
[[nodiscard]] std::string inspection_text(const nlohmann::json& inspection);

}  // namespace rambla::game
