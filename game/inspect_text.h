#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rambla::game {

/// The tables that people read, from what inspect_file() returned. Long tables are cut and say so.
[[nodiscard]] std::string inspection_text(const nlohmann::json& inspection);

/// The table of several files and its totals, from what inspect_files() returned; no row and no word is cut.
[[nodiscard]] std::string files_text(const nlohmann::json& files);

}  // namespace rambla::game
