#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rambla::game {

/// The table of several files, from what inspect_files() returned, as comma-separated values with a head line
/// (RFC 4180, but for the line ends, which are those of Unix).
[[nodiscard]] std::string files_csv(const nlohmann::json& files);

}  // namespace rambla::game
